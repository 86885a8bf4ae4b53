// SPDX-License-Identifier: Apache-2.0
// The test bench from Python: scenarios, AVs as classes, comparisons, stores, tests step by step.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "env/simulator/simulator.h"
#include "env/vehicle/controller_processes.h"
#include "env/world/world_spec.h"
#include "experiment/compare/experiment.h"
#include "experiment/judge/trace_file.h"
#include "experiment/library/library.h"
#include "experiment/report/player/player.h"
#include "experiment/results/reader.h"
#include "experiment/scenario/number_list.h"
#include "experiment/test_run/prepared_scenario.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/term/heap.h"
#include "python/module/values.h"
#include <jaywalk/comparison.h>
#include <jaywalk/store.h>

namespace jaywalk::python {
namespace {

/// A view that Python may keep.
struct View {
  explicit View(const VehicleView& view)
      : seen(view),
        actors(view.actors.begin(), view.actors.end()),
        stop_lines(view.stop_lines.begin(), view.stop_lines.end()),
        obstacles(view.obstacles.begin(), view.obstacles.end()),
        lanes(view.lanes.begin(), view.lanes.end()) {
    seen.actors = {};
    seen.stop_lines = {};
    seen.obstacles = {};
    seen.lanes = {};
  }

  VehicleView seen;
  std::vector<SeenActor> actors;
  std::vector<StopLine> stop_lines;
  std::vector<SeenObstacle> obstacles;
  std::vector<SeenLane> lanes;
};

/// A Python object with act(view); an exception ends the test errored.
class PyDriver final : public VehicleDriver {
 public:
  explicit PyDriver(const py::object& make) {
    const py::gil_scoped_acquire acquire;
    try {
      act_ = make().attr("act");
    } catch (py::error_already_set& error) {
      failure_ = report("the AV", error);
    }
  }
  ~PyDriver() override {
    const py::gil_scoped_acquire acquire;
    act_ = {};
  }

  double decide(const VehicleView& view) override {
    if (!failure_.empty()) return 0;
    const py::gil_scoped_acquire acquire;
    try {
      return act_(View(view)).cast<double>();
    } catch (py::error_already_set& error) {
      failure_ = report("the AV", error);
    } catch (py::cast_error&) {
      failure_ = "act() returns no number";
    }
    return 0;
  }
  [[nodiscard]] std::string failure() const override { return failure_; }

 private:
  py::object act_;
  std::string failure_;
};

std::shared_ptr<const OwnVehicle> own_vehicle(const py::object& make) {
  if (make.is_none()) return nullptr;
  return std::make_shared<const OwnVehicle>(
      OwnVehicle{.name = py::str(py::getattr(make, "__name__", py::str("Python"))),
                 .make = [kept = shared(make)] { return std::make_unique<PyDriver>(*kept); }});
}

py::object or_none(const std::optional<double>& value) {
  return value ? py::object(py::float_(*value)) : py::none();
}

py::list columns_of(const TestReport& report) {
  py::list actors;
  for (const ActorTrack& track : report.actors) {
    const auto column = [&](double ActorMoment::*field) {
      py::list values(track.moments.size());
      for (std::size_t i = 0; i < track.moments.size(); ++i) {
        values[i] = track.moments[i].*field;
      }
      return values;
    };
    py::dict actor;
    actor["name"] = track.name;
    actor["kind"] = std::string(track.kind);
    actor["length_m"] = track.length_m;
    actor["width_m"] = track.width_m;
    actor["x_m"] = column(&ActorMoment::x_m);
    actor["y_m"] = column(&ActorMoment::y_m);
    actor["speed_mps"] = column(&ActorMoment::speed_mps);
    actor["heading_rad"] = column(&ActorMoment::heading_rad);
    actors.append(actor);
  }
  return actors;
}

py::dict to_python(const TestReport& report) {
  py::dict said;
  said["error"] = report.error;
  said["succeeded"] = report.succeeded;
  said["ended_by"] = report.ended_by;
  said["ticks"] = report.ticks;
  said["tick_s"] = report.tick_s;
  said["score"] = report.score;
  said["impact_mps"] = or_none(report.impact_mps);
  said["actors"] = columns_of(report);
  py::list events;
  for (const TestEvent& each : report.events) {
    events.append(py::make_tuple(each.tick, each.actor, each.kind, each.text));
  }
  said["events"] = events;
  py::list verdicts;
  for (const TestVerdict& each : report.verdicts) {
    verdicts.append(py::make_tuple(each.assertion, std::string(name(each.verdict)),
                                   or_none(each.robustness),
                                   each.tick ? py::object(py::int_(*each.tick)) : py::none()));
  }
  said["verdicts"] = verdicts;
  py::dict metrics;
  for (const MetricReading& each : report.metrics) {
    metrics[py::str(std::string(each.metric))] = or_none(each.value);
  }
  said["metrics"] = metrics;
  return said;
}

py::dict to_python(const ComparisonReport& report) {
  py::list rows;
  for (const ComparisonRow& row : report.rows) {
    py::dict said;
    said["behaviour"] = row.behaviour;
    said["agents"] = row.agents;
    said["tests"] = row.tests;
    said["successes"] = row.successes;
    said["errored"] = row.errored;
    const std::vector<MeasureInfo> measures = measure_list();
    for (std::size_t i = 0; i < measures.size(); ++i) {
      const std::string measure(measures[i].name);
      const Estimate& found = row.measures[i];
      if (said.contains(measure.c_str())) continue;  // a count that each row has
      const bool is_count = found.is_count && found.value;
      said[py::str(measure)] = is_count
                                   ? py::object(py::int_(static_cast<std::int64_t>(*found.value)))
                                   : or_none(found.value);
      said[py::str(measure + "_low")] = or_none(found.low);
      said[py::str(measure + "_high")] = or_none(found.high);
    }
    for (const VerdictTally& tally : row.verdicts) {
      for (std::size_t i = 0; i < kVerdictCount; ++i) {
        said[py::str(tally.assertion + "." + std::string(name(static_cast<Verdict>(i))))] =
            tally.tests[i];
      }
    }
    rows.append(said);
  }
  py::list kills;
  for (const KillTally& tally : report.kills) {
    py::dict said;
    said["behaviour"] = tally.behaviour;
    said["agents"] = tally.agents;
    said["defect"] = tally.defect;
    said["tests"] = tally.tests;
    said["kills"] = tally.kills;
    said["healthy_failures"] = tally.healthy_failures;
    said["first_kill_median"] =
        tally.first_kill_median ? py::object(py::int_(*tally.first_kill_median)) : py::none();
    kills.append(said);
  }
  py::dict said;
  said["rows"] = rows;
  said["kills"] = kills;
  said["is_complete"] = report.is_complete;
  said["csv"] = report.csv;
  said["json"] = report.json;
  return said;
}

JudgingRules rules_of(const RunnableScenario& scenario,
                      const std::optional<std::vector<std::string>>& assertions, bool metrics) {
  return (assertions ? value_of(JudgingRules::read(*assertions)) : scenario.rules())
      .with_metrics(metrics);
}

RunnableScenario load(const std::string& name, const std::optional<std::string>& text,
                      const std::optional<std::string>& preset,
                      const std::vector<std::string>& sets,
                      const std::vector<std::string>& behaviours,
                      const std::vector<std::string>& policies,
                      const std::vector<std::string>& include, const std::string& data_folder,
                      const py::object& vehicle) {
  ScenarioChoice choice{.preset = preset,
                        .sets = sets,
                        .behaviours = behaviours,
                        .policies = policies,
                        .vehicle = own_vehicle(vehicle),
                        .data_folder = data_folder};
  choice.folders.included = include;
  // Files of the caller's own are the caller's to read.
  choice.folders.readable = include;
  return value_of(text ? RunnableScenario::parse(name, *text, choice)
                       : RunnableScenario::read(name, choice));
}

py::dict run(const RunnableScenario& scenario, const std::string& behaviour, std::uint32_t agents,
             std::uint64_t test, const std::optional<std::uint64_t>& seed, const py::object& print,
             const std::optional<std::vector<std::string>>& assertions) {
  TestChoice choice{.behaviour = behaviour, .agents = agents, .test = test, .seed = seed};
  Thrown thrown;
  choice.print = line_printer(print, thrown);
  choice.interrupted = [&] { return thrown.is_interrupted(); };
  const JudgingRules rules = rules_of(scenario, assertions, true);
  std::optional<Result<TestReport>> report;
  {
    const py::gil_scoped_release release;
    report.emplace(scenario.run(choice, rules));
  }
  thrown.rethrow();
  return to_python(value_of(*std::move(report)));
}

py::dict compare_in_python(const RunnableScenario& scenario,
                           const std::optional<std::uint64_t>& tests,
                           const std::optional<std::vector<std::uint32_t>>& agents,
                           const std::optional<std::uint64_t>& seed, unsigned threads,
                           const std::optional<std::vector<std::string>>& assertions, bool metrics,
                           const std::string& store, bool resume, const py::object& progress) {
  Thrown thrown;
  std::atomic<std::uint64_t> done = 0;
  std::atomic<std::uint64_t> total = 0;
  const ComparisonOptions options{.tests = tests,
                                  .agents = agents,
                                  .seed = seed,
                                  .threads = threads,
                                  .rules = rules_of(scenario, assertions, metrics),
                                  .store = store,
                                  .resume = resume,
                                  .progress = [&](std::uint64_t now, std::uint64_t all) {
                                    done = now;
                                    total = all;
                                    return !thrown.is_there();
                                  }};
  std::optional<Result<ComparisonReport>> report;
  wait_for([&] { report.emplace(compare(scenario, options)); },
           [&] {
             if (!progress.is_none() && total > 0) progress(done.load(), total.load());
           },
           thrown);
  return to_python(value_of(*std::move(report)));
}

/// The page that plays a test. Errors: those of running it.
std::string page(const RunnableScenario& scenario, const std::string& behaviour,
                 std::uint32_t agents, std::uint64_t test,
                 const std::optional<std::uint64_t>& seed) {
  Thrown thrown;
  const TestChoice choice{
      .behaviour = behaviour, .agents = agents, .test = test, .seed = seed, .interrupted = [&] {
        return thrown.is_interrupted();
      }};
  const PreparedScenario& prepared = *scenario.prepared();
  Recording recording;
  MindRecorder minds;
  auto setup = setup_of(scenario, choice);
  if (setup) {
    const py::gil_scoped_release release;
    (void)run_test(prepared, setup.value(),
                   {.observe = [&](const World&, const Mas& mas) { minds.observe(mas); },
                    .record = &recording,
                    .observer = &minds,
                    .interrupted = choice.interrupted});
  }
  thrown.rethrow();
  const std::uint64_t used = value_of(std::move(setup)).seed;
  return render_player(
      fmt::format("{}, {} agents, seed {}, test {}", behaviour, agents, used, test),
      prepared.scenario().world->plan(), recording, minds);
}

std::string stored_page(const std::string& path, std::int64_t id) {
  const py::gil_scoped_release release;
  const auto render = [&]() -> Result<std::string> {
    const auto reader = ResultsReader::open(path);
    if (!reader) return reader.diagnostics();
    const auto test = reader.value()->test(id);
    if (!test) return test.diagnostics();
    return replay_page(*reader.value(), test.value());
  };
  auto page = render();
  const py::gil_scoped_acquire acquire;
  return value_of(std::move(page));
}

/// A drive that was recorded elsewhere, as CSV (docs/reference/assertions.md), on the scenario's
/// ground.
py::dict judge(const std::string& name, const std::string& csv, const RunnableScenario& scenario,
               const std::optional<std::vector<std::string>>& assertions) {
  Diagnostics warnings;
  const Recording recording =
      value_of(parse_trace(std::make_shared<const Source>(name, csv), warnings));
  py::dict said = to_python(report_of(recording, rules_of(scenario, assertions, true).criteria(),
                                      scenario.prepared()->scenario().world->ground()));
  said["warnings"] = python::to_python(warnings);
  said["ticks"] = recording.scenes() - 1;
  return said;
}

py::list lines_of(const ResultsStore& store, const std::optional<std::string>& behaviour,
                  const std::optional<std::uint32_t>& agents, const std::optional<bool>& succeeded,
                  const std::optional<bool>& errored) {
  py::list lines;
  const auto trouble = store.for_each_test(
      {.behaviour = behaviour, .agents = agents, .succeeded = succeeded, .errored = errored},
      [&](const TestLine& test) {
        py::dict line;
        line["id"] = test.id;
        line["behaviour"] = test.behaviour;
        line["agents"] = test.agents;
        line["test"] = test.test;
        line["vehicle"] = test.vehicle;
        line["succeeded"] = test.succeeded;
        line["errored"] = test.errored;
        line["ended_by"] = test.ended_by;
        line["ticks"] = test.ticks;
        line["score"] = test.score;
        lines.append(line);
        return true;
      });
  if (trouble) raise(*trouble);
  return lines;
}

/// A test whose agents are driven from Python, tick by tick.
class Episode {
 public:
  Episode(const RunnableScenario& scenario, std::uint32_t agents, std::uint64_t test,
          const std::optional<std::uint64_t>& seed)
      : prepared_(scenario.prepared()), symbols_(prepared_->symbols()), percepts_(agents) {
    if (!prepared_->actors().empty()) {
      throw py::value_error("the scenario has other agents, whose programs run in tests alone");
    }
    const TestSetup setup =
        value_of(setup_of(scenario, {.agents = agents, .test = test, .seed = seed}));
    world_ = prepared_->world(0).make(start_of(setup));
    world_->begin({.test = test,
                   .seed = setup.seed,
                   .behaviour = "python",
                   .agents = agents,
                   .processes = &processes_,
                   .simulators = &simulators_});
  }

  py::list percepts(std::size_t agent) {
    Percepts& seen = percepts_.at(agent);
    seen.begin_look();
    world_->perceive(AgentId{static_cast<std::uint32_t>(agent)}, seen);
    seen.end_look();
    const Terms terms(heap_, symbols_);
    py::list told;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      py::tuple args(seen.args(i).size());
      for (std::size_t k = 0; k < args.size(); ++k) {
        args[k] = python::to_python(terms, seen.args(i)[k]);
      }
      told.append(structure_class()(std::string(symbols_.functor(seen.predicate(i))), args));
    }
    return told;
  }

  /// One tick: an action, or None, of each agent. The reasons why they failed; None: they did not.
  py::list step(const py::sequence& actions) {
    if (world_->finished()) throw py::value_error("the test has ended");
    if (actions.size() != percepts_.size()) throw py::value_error("expected one action an agent");
    const Terms terms(heap_, symbols_);
    std::vector<std::vector<Value>> args(actions.size());
    std::vector<ActionRequest> requests;
    std::vector<std::size_t> agents;
    for (std::size_t i = 0; i < actions.size(); ++i) {
      const py::object action = actions[i];
      if (action.is_none()) continue;
      const py::object literal = as_literal(action);
      for (const py::handle arg : literal.attr("args")) {
        args[i].push_back(from_python(terms, arg));
      }
      const auto functor = literal.attr("functor").cast<std::string>();
      requests.push_back({.agent = AgentId{static_cast<std::uint32_t>(i)},
                          .predicate = predicate_named(symbols_, functor, args[i].size()),
                          .args = args[i]});
      agents.push_back(i);
    }
    std::vector<ActionResult> results(requests.size());
    {
      const py::gil_scoped_release release;
      world_->execute(requests, results);
      world_->advance();
      if (world_->finished()) world_->end();
    }
    if (const std::string failure = world_->failure(); !failure.empty()) {
      throw std::runtime_error(failure);
    }
    py::list reasons(actions.size());
    for (std::size_t i = 0; i < actions.size(); ++i) reasons[i] = py::none();
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (!results[i].succeeded) reasons[agents[i]] = results[i].reason;
    }
    return reasons;
  }

  [[nodiscard]] bool is_finished() const { return world_->finished(); }
  [[nodiscard]] py::dict result() const {
    const WorldResult& result = world_->result();
    py::dict said;
    said["succeeded"] = result.success;
    said["ended_by"] = std::string(result.end);
    said["ticks"] = world_->ticks();
    said["met_by"] = result.met_by;
    py::list scores;
    for (const AgentOutcome& each : result.agents) scores.append(each.reward - each.cost);
    said["scores"] = scores;
    return said;
  }

 private:
  std::shared_ptr<const PreparedScenario> prepared_;
  SymbolTable symbols_;
  Heap heap_;
  ControllerProcesses processes_;
  Simulators simulators_;
  std::vector<Percepts> percepts_;
  std::unique_ptr<World> world_;
};

void add_views(py::module_& module) {
  py::class_<SeenActor>(module, "SeenActor")
      .def_readonly("id", &SeenActor::id)
      .def_property_readonly("kind",
                             [](const SeenActor& self) { return std::string(name(self.kind)); })
      .def_readonly("gap_m", &SeenActor::gap_m)
      .def_readonly("left_m", &SeenActor::left_m)
      .def_readonly("right_m", &SeenActor::right_m)
      .def_readonly("speed_ahead_mps", &SeenActor::speed_ahead_mps)
      .def_readonly("speed_right_mps", &SeenActor::speed_right_mps)
      .def_readonly("length_m", &SeenActor::length_m)
      .def_readonly("heading_rad", &SeenActor::heading_rad);
  py::class_<StopLine>(module, "StopLine")
      .def_readonly("gap_m", &StopLine::gap_m)
      .def_readonly("closed", &StopLine::closed);
  py::class_<SeenObstacle>(module, "SeenObstacle")
      .def_readonly("gap_m", &SeenObstacle::gap_m)
      .def_readonly("far_m", &SeenObstacle::far_m)
      .def_readonly("left_m", &SeenObstacle::left_m)
      .def_readonly("right_m", &SeenObstacle::right_m);
  py::class_<SeenLane>(module, "SeenLane")
      .def_readonly("left_m", &SeenLane::left_m)
      .def_readonly("right_m", &SeenLane::right_m)
      .def_readonly("oncoming", &SeenLane::oncoming);
  const auto number = [](double VehicleView::*field) {
    return [field](const View& self) { return self.seen.*field; };
  };
  py::class_<View>(module, "View",
                   "What the sensors of an AV see; docs/reference/controller_protocol.md")
      .def_property_readonly("time_s", number(&VehicleView::time_s))
      .def_property_readonly("period_s", number(&VehicleView::period_s))
      .def_property_readonly("speed_mps", number(&VehicleView::speed_mps))
      .def_property_readonly("cruise_mps", number(&VehicleView::cruise_mps))
      .def_property_readonly("left_m", number(&VehicleView::left_m))
      .def_property_readonly("right_m", number(&VehicleView::right_m))
      .def_property_readonly("lane_left_m", number(&VehicleView::lane_left_m))
      .def_property_readonly("lane_right_m", number(&VehicleView::lane_right_m))
      .def_property_readonly("front_m", number(&VehicleView::front_m))
      .def_property_readonly("length_m", number(&VehicleView::length_m))
      .def_property_readonly("range_m", number(&VehicleView::range_m))
      .def_readonly("actors", &View::actors)
      .def_readonly("stop_lines", &View::stop_lines)
      .def_readonly("obstacles", &View::obstacles)
      .def_readonly("lanes", &View::lanes);
}

}  // namespace

void add_bench(py::module_& module) {
  module.attr("MOST_AGENTS") = kMaxAgents;
  module.attr("MOST_TESTS") = kMaxTests;
  module.attr("MOST_THREADS") = kMaxThreads;
  add_views(module);
  py::class_<RunnableScenario>(module, "Scenario")
      .def_static("load", &load)
      .def_property_readonly("name", &RunnableScenario::name)
      .def_property_readonly("world",
                             [](const RunnableScenario& self) { return std::string(self.world()); })
      .def_property_readonly("behaviours", &RunnableScenario::behaviours)
      .def_property_readonly("agents", &RunnableScenario::agents)
      .def_property_readonly("tests", &RunnableScenario::tests)
      .def_property_readonly("seed", &RunnableScenario::seed)
      .def_property_readonly(
          "warnings", [](const RunnableScenario& self) { return to_python(self.warnings()); })
      .def("run", &run)
      .def("page", &page)
      .def("compare", &compare_in_python);
  py::class_<ResultsStore>(module, "Store")
      .def_static("open",
                  [](const std::string& path) { return value_of(ResultsStore::open(path)); })
      .def_property_readonly("count", &ResultsStore::count)
      .def_property_readonly("is_complete", &ResultsStore::is_complete)
      .def("tests", &lines_of)
      .def("test", [](const ResultsStore& self,
                      std::int64_t id) { return to_python(value_of(self.test(id))); })
      .def("comparison",
           [](const ResultsStore& self) { return to_python(value_of(self.comparison())); });
  py::class_<Episode>(module, "Episode")
      .def(py::init<const RunnableScenario&, std::uint32_t, std::uint64_t,
                    std::optional<std::uint64_t>>())
      .def("percepts", &Episode::percepts)
      .def("step", &Episode::step)
      .def_property_readonly("is_finished", &Episode::is_finished)
      .def("result", &Episode::result);
  module.def("stored_page", &stored_page);
  module.def("judge", &judge);
  module.def("measures", [] {
    py::dict measures;
    for (const MeasureInfo& each : measure_list()) {
      measures[py::str(std::string(each.name))] = std::string(each.summary);
    }
    return measures;
  });
}

}  // namespace jaywalk::python

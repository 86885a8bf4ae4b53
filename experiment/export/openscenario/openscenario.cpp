// SPDX-License-Identifier: Apache-2.0
// Tests as ASAM OpenSCENARIO XML. Only what is valid in all of 1.0 to 1.3 is written, with 1.0 in
// the header, since some players refuse other minors; the parameter values of a batch came
// with 1.1. For each test:
//
//   STEM.xosc           every actor on a timetable, at every tick where it was
//   STEM-reactive.xosc  the AV drives as it did; each pedestrian steps out when the AV's time to
//                       collision with it falls to what it was in the test
//
// and for each behaviour and number of agents `…-batch.xosc`, the reactive scenario with
// parameters, and `…-batch-values.xosc`, a set of values for each test. The ground is `road.xodr`.

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "env/crossing/world.h"
#include "experiment/export/exporter.h"
#include "experiment/export/openscenario/openscenario_text.h"
#include "experiment/export/openscenario/road_plan.h"

namespace jaywalk {
namespace {

/// The sets of values of one batch: OpenSCENARIO 1.1's parameter distribution.
std::string distribution(const std::string& scenario_file, const std::string& sets) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenSCENARIO>\n"
      "<FileHeader revMajor=\"1\" revMinor=\"1\" date=\"2020-01-01T00:00:00\" "
      "description=\"a set of values for each test\" author=\"jaywalk\"/>\n"
      "<ParameterValueDistribution><ScenarioFile filepath=\"{}\"/><Deterministic>"
      "<DeterministicMultiParameterDistribution><ValueSetDistribution>\n{}"
      "</ValueSetDistribution></DeterministicMultiParameterDistribution></Deterministic>"
      "</ParameterValueDistribution>\n</OpenSCENARIO>\n",
      scenario_file, sets);
}

std::string value_set(const ParameterValues& values) {
  std::string text = "<ParameterValueSet>\n";
  for (const auto& [name, value] : values) {
    text += fmt::format("<ParameterAssignment parameterRef=\"{}\" value=\"{}\"/>\n", name, value);
  }
  return text + "</ParameterValueSet>\n";
}

/// The tests of one behaviour and number of agents.
struct Batch {
  Recording first;
  std::vector<Courses> tests;
  /// The phases of the signals, and whether all tests of the batch have the same.
  std::string signals;
  bool same_signals = true;
  bool same_actors = true;
};

BatchShape shape_of(const Batch& batch) {
  BatchShape shape(batch.first.actors().size(), 2);
  for (const Courses& test : batch.tests) {
    for (std::size_t i = 0; i < shape.size(); ++i) {
      shape[i] = std::max(shape[i], test.courses[i].points.size());
    }
  }
  return shape;
}

class Export {
 public:
  explicit Export(const ExportRequest& request) : request_(request) {}

  ExportedFiles run() {
    const auto prepared = request_.store.prepared();
    if (!prepared.ok()) return prepared.diagnostics();
    const CrossingSpec* const crossing = find_crossing(*prepared.value()->scenario().world);
    if (crossing == nullptr) {
      diagnostics_.error("openscenario",
                         fmt::format("tests of the world {} cannot be exported so",
                                     prepared.value()->scenario().world->kind()),
                         "it writes the roads of the crossing alone");
      return diagnostics_;
    }
    const CrossingParameters& world = crossing->parameters();
    const RoadPlan plan = plan_roads(world);
    write("road.xodr", to_opendrive(plan, world.cell_m));
    for (const std::string& each : plan.unsaid) warn("road.xodr", each);
    for (const std::int64_t id : request_.tests) {
      if (diagnostics_.has_errors()) break;
      const Result<StoredTest> test = request_.store.test(id);
      if (!test.ok()) return test.diagnostics();
      const Result<Recording> recording = request_.store.recording(id);
      if (!recording.ok()) return recording.diagnostics();
      write_test(test.value(), recording.value(), world, plan);
    }
    for (const auto& [stem, batch] : batches_) write_batch(stem, batch, world, plan);
    if (diagnostics_.has_errors()) return diagnostics_;
    // Otherwise it merges places nearer than 0.1 m and leaves out pauses shorter than a second.
    exported_.note = "esmini plays them as recorded with --traj_filter 0";
    return exported_;
  }

 private:
  void write(const std::string& name, std::string_view text) {
    if (diagnostics_.has_errors()) return;
    (void)write_export(request_, name, text, exported_.files, diagnostics_);
  }

  void warn(const std::string& file, std::string what) {
    exported_.warnings.add(
        {.severity = Severity::warning, .message = std::move(what), .subject = file});
  }

  void warn_of(const std::string& file, const Recording& recording, const Courses& courses) {
    for (std::size_t i = 0; i < courses.courses.size(); ++i) {
      if (courses.courses[i].keeps_outcome) continue;
      warn(file, fmt::format("a player may find another outcome between the AV and {} than the "
                             "test had",
                             recording.actors()[i].name));
    }
  }

  void write_test(const StoredTest& test, const Recording& recording,
                  const CrossingParameters& world, const RoadPlan& plan) {
    const std::string stem = file_stem(request_.store, test.test);
    if (recording.scenes() < 2) {
      warn(stem + ".xosc", "is not written: nothing happened in the test");
      return;
    }
    const ScenarioText text(recording, world, plan, request_.dialect);
    const Courses timed = timed_courses(recording);
    write(stem + ".xosc", text.trajectories(stem, timed));
    warn_of(stem + ".xosc", recording, timed);
    Courses reactive = reactive_courses(recording);
    write(stem + "-reactive.xosc", text.reactive(stem + ", reactive", reactive));
    warn_of(stem + "-reactive.xosc", recording, reactive);
    const std::string& behaviour =
        request_.store.description().behaviours[test.test.behaviour].name;
    Batch& batch = batches_[fmt::format("{}-{}", behaviour, test.test.agents)];
    const std::string signals = text.signals(0);
    if (batch.tests.empty()) {
      batch.first = recording;
      batch.signals = signals;
    }
    const bool same = std::ranges::equal(batch.first.actors(), recording.actors());
    if (!same && world.simulator.name.empty()) {
      diagnostics_.error(request_.store.path(),
                         fmt::format("the store is damaged: the actors of test {}", test.id));
      return;
    }
    batch.same_actors = batch.same_actors && same;
    batch.same_signals = batch.same_signals && batch.signals == signals;
    batch.tests.push_back(std::move(reactive));
  }

  void write_batch(const std::string& stem, const Batch& batch, const CrossingParameters& world,
                   const RoadPlan& plan) {
    const std::string file = stem + "-batch.xosc";
    if (!batch.same_actors) {
      warn(file, "is not written: a simulator's traffic differs from test to test");
      return;
    }
    const ScenarioText text(batch.first, world, plan, request_.dialect);
    const BatchShape shape = shape_of(batch);
    write(file, text.batch(stem + ", all tests", shape, text.values(batch.tests.front(), shape)));
    if (!batch.same_signals) warn(file, "has the first test's signals; those of others differ");
    std::string sets;
    for (const Courses& test : batch.tests) sets += value_set(text.values(test, shape));
    write(stem + "-batch-values.xosc", distribution(file, sets));
  }

  const ExportRequest& request_;
  std::map<std::string, Batch> batches_;
  Exported exported_;
  Diagnostics diagnostics_;
};

}  // namespace

ExportedFiles export_openscenario(const ExportRequest& request) { return Export(request).run(); }

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// `jaywalk explain`: why an agent did something in a stored test, or did not.

#include <algorithm>

#include <fmt/format.h>

#include "experiment/report/explanation_json.h"
#include "experiment/report/player/player.h"
#include "experiment/test_run/plan_coverage.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/explain/explanation.h"
#include "interpreter/support/text.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/stored_test.h"

namespace jaywalk::command::explain {
namespace {

/// Runs the test again with an observer that keeps the agents' deliberations.
Result<std::vector<Deliberation>> deliberations(const ResultsReader& store, const StoredTest& test,
                                                ExplainingObserver::Wanted wanted) {
  const auto prepared = store.prepared();
  if (!prepared.ok()) return prepared.diagnostics();
  Probes probes(prepared.value()->symbols(), Probes::Detail::bindings);
  const auto setup = store.setup(test.id);
  if (!setup.ok()) return setup.diagnostics();
  add_programs(*prepared.value(), {{setup.value().behaviour, setup.value().agents}}, probes);
  const ProbeTexts texts = find_texts(probes, prepared.value()->inputs());
  ExplainingObserver observer(probes, texts, std::move(wanted));
  std::uint32_t tick = 0;
  TestOptions options;
  options.observer = &observer;
  options.observe = [&](const World&, const Mas&) { observer.set_tick(++tick); };
  const auto result = store.rerun(test.id, options);
  if (!result.ok()) return result.diagnostics();
  return observer.deliberations();
}

bool has_agent(const ResultsReader& store, const StoredTest& test, const std::string& name,
               Console& console) {
  const auto recording = store.recording(test.id);
  if (!recording.ok()) {
    console.report(recording.diagnostics());
    return false;
  }
  std::vector<std::string> names;
  for (const Actor& actor : recording.value().actors().subspan(1)) names.push_back(actor.name);
  if (std::ranges::find(names, name) != names.end()) return true;
  console.error(fmt::format("the test has no agent '{}'", name), did_you_mean(name, names));
  return false;
}

bool has_tick(const StoredTest& test, std::uint32_t tick, Console& console) {
  if (tick >= 1 && tick <= test.result.ticks) return true;
  Diagnostics diagnostics;
  diagnostics.error(option::kTick.dashed(),
                    fmt::format("the test has {}, from 1", counted(test.result.ticks, "tick")));
  console.report(diagnostics);
  return false;
}

/// A text for each deliberation of a tick: the agent, the event and the chosen plan.
std::vector<std::string> choices(const std::vector<Deliberation>& all, std::uint32_t tick) {
  std::vector<std::string> texts;
  for (const Deliberation& each : all) {
    if (each.tick != tick) continue;
    const TriedPlan* chosen = each.chosen();
    texts.push_back(
        fmt::format("{} {} {}", each.agent, each.event, chosen == nullptr ? "" : chosen->where));
  }
  return texts;
}

/// The first tick in which the agents decide otherwise; nothing if they never do.
std::optional<std::uint32_t> first_other_choice(const std::vector<Deliberation>& healthy,
                                                const std::vector<Deliberation>& defective) {
  std::uint32_t last = 0;
  for (const Deliberation& each : defective) last = std::max(last, each.tick);
  for (const Deliberation& each : healthy) last = std::max(last, each.tick);
  for (std::uint32_t tick = 0; tick <= last; ++tick) {
    if (choices(healthy, tick) != choices(defective, tick)) return tick;
  }
  return std::nullopt;
}

std::string in_tick(const std::vector<Deliberation>& all, std::uint32_t tick) {
  std::vector<Deliberation> of_tick;
  for (const Deliberation& each : all) {
    if (each.tick == tick) of_tick.push_back(each);
  }
  const std::string text = explanation_text(of_tick);
  return text.empty() ? "no deliberation\n" : text;
}

/// The assertions that the AV failed in the test, one line each.
Result<std::string> failures(const ResultsReader& store, const StoredTest& test,
                             std::string_view name) {
  const auto assessments = store.assessments(test.id);
  if (!assessments.ok()) return assessments.diagnostics();
  std::string text;
  for (const AssessmentRow& each : assessments.value()) {
    if (each.verdict != StoredVerdict::fail) continue;
    text += fmt::format("{} fails {}", name, each.id);
    if (each.tick) text += fmt::format(" in tick {}", *each.tick);
    text += '\n';
  }
  return text;
}

/// A test with a defect beside the same test of the healthy AV.
Result<std::string> both_runs(const ResultsReader& store, const StoredTest& test,
                              const ExplainingObserver::Wanted& wanted) {
  const auto own = store.recording(test.id);
  if (!own.ok()) return own.diagnostics();
  const auto healthy = twin_recording(store, test);
  if (!healthy.ok()) return healthy.diagnostics();
  const std::string& name = store.description().vehicles[test.test.vehicle];
  const auto failed = failures(store, test, name);
  if (!failed.ok()) return failed.diagnostics();
  std::string text = failed.value() + side_by_side(*healthy.value(), own.value(), name);

  StoredTest twin = test;
  twin.id = twin_id(store.description(), test.test);
  const auto theirs = deliberations(store, twin, wanted);
  if (!theirs.ok()) return theirs.diagnostics();
  const auto ours = deliberations(store, test, wanted);
  if (!ours.ok()) return ours.diagnostics();
  const auto tick = first_other_choice(theirs.value(), ours.value());
  if (!tick) return text + "\nthe agents decide alike in both\n";
  text += fmt::format("\nthe agents decide otherwise from tick {} on\n", *tick);
  text += fmt::format("\n--- healthy\n\n{}", in_tick(theirs.value(), *tick));
  text += fmt::format("\n--- {}\n\n{}", name, in_tick(ours.value(), *tick));
  return text;
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "STORE [OPTIONS]",
      .description =
          "Explains why agents did what they did in a stored test: for each of their\n"
          "deliberations the plans that were relevant, which of them were applicable, on\n"
          "which condition the contexts of the others failed and with which bindings, what\n"
          "was chosen, and where the beliefs came from. The test is run again from what the\n"
          "store has of it, so ordinary runs pay nothing for it. With --defect the runs of the\n"
          "healthy and of the defective AV stand side by side from the tick in which they part,\n"
          "then what the agents decided where they first decided otherwise.\n",
      .options =
          {
              {option::kAgent, "NAME", "of this agent only, as p1"},
              {option::kTick, "N", "in this tick only, from 1"},
              {option::kJson, "FILE", "write it as JSON instead", Written::file},
              kAllowCommandsOption,
          },
      .examples =
          "  jaywalk explain runs.gpkg --test 7\n"
          "  jaywalk explain runs.gpkg --test 7 --agent p1 --tick 4\n"
          "  jaywalk explain kills.gpkg --defect latency=0.3\n"};
  help.options.insert(help.options.begin(), kStoredTestOptions.begin(), kStoredTestOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  ExplainingObserver::Wanted wanted{.agent = arguments.text(option::kAgent)};
  if (const auto tick = arguments.number(option::kTick, 0, diagnostics)) {
    wanted.tick = static_cast<std::uint32_t>(std::min<std::uint64_t>(*tick, 0xFFFF'FFFFU));
  }
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return ExitCode::usage;
  }
  const auto store = open_results(arguments, "explain", console);
  if (!store) return ExitCode::usage;
  const auto test = find_stored_test(*store, arguments, console);
  if (!test) return ExitCode::usage;
  if (wanted.agent && !has_agent(*store, *test, *wanted.agent, console)) return ExitCode::usage;
  if (wanted.tick && !has_tick(*test, *wanted.tick, console)) return ExitCode::usage;
  if (test->test.vehicle > 0 && !arguments.has(option::kJson)) {
    const auto text = both_runs(*store, *test, wanted);
    if (text.ok()) console.print(fmt::format("{}\n\n{}", name_of(*store, *test), text.value()));
    if (!text.ok()) console.report(text.diagnostics());
    return text.ok() ? ExitCode::success : ExitCode::usage;
  }
  const auto found = deliberations(*store, *test, wanted);
  if (!found.ok()) {
    console.report(found.diagnostics());
    return ExitCode::usage;
  }
  if (const auto path = arguments.text(option::kJson)) {
    const bool written = write_output(*path, explanation_json(found.value()), console);
    return written ? ExitCode::success : ExitCode::failed;
  }
  console.print(fmt::format("{}\n\n", name_of(*store, *test)));
  const std::string text = explanation_text(found.value());
  console.print(text.empty() ? "no deliberation: nothing happened that a plan is for\n" : text);
  return ExitCode::success;
}

}  // namespace jaywalk::command::explain

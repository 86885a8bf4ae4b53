// `jaywalk explain`: why an agent did something in a stored test, or did not.

#include <algorithm>

#include <fmt/format.h>

#include "experiment/plan_coverage.h"
#include "experiment/report/explanation_json.h"
#include "experiment/report/replay_page.h"
#include "interpreter/explain/explanation.h"
#include "tools/jaywalk/command.h"
#include "tools/jaywalk/output_files.h"
#include "tools/jaywalk/stored_test.h"

namespace jaywalk::command::explain {
namespace {

/// Runs the test again, this time looking closely.
Result<std::vector<Deliberation>> deliberations(const ResultsReader& store, const StoredTest& test,
                                                ExplainingObserver::Wanted wanted) {
  const auto prepared = store.prepared();
  if (!prepared.ok()) return prepared.diagnostics();
  Probes probes(prepared.value()->symbols(), Probes::Detail::bindings);
  const auto input = store.input(test.id);
  if (!input.ok()) return input.diagnostics();
  add_programs(*prepared.value(), {{input.value().behaviour, input.value().agents}}, probes);
  const ProbeTexts texts = find_texts(probes, prepared.value()->inputs());
  ExplainingObserver observer(probes, texts, std::move(wanted));
  std::uint32_t tick = 0;
  TrialOptions options;
  options.observer = &observer;
  options.observe = [&](const Crossing&, const Mas&) { observer.set_tick(++tick); };
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

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "STORE [OPTIONS]",
      .description =
          "Tells why agents did what they did in a stored test: for each of their\n"
          "deliberations the plans that were relevant, which of them were applicable, on\n"
          "which condition the contexts of the others failed and with which bindings, what\n"
          "was chosen, and where the beliefs came from. The test is run again from what the\n"
          "store has of it, so ordinary runs pay nothing for it.\n",
      .options =
          {
              {"agent", "NAME", "of this agent only, as p1"},
              {"tick", "N", "in this tick only, from 1"},
              {"json", "FILE", "write it as JSON instead", Written::file},
          },
      .examples =
          "  jaywalk explain runs.gpkg --test 7\n"
          "  jaywalk explain runs.gpkg --test 7 --agent p1 --tick 4\n"};
  help.options.insert(help.options.begin(), kStoredTestOptions.begin(), kStoredTestOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  ExplainingObserver::Wanted wanted{.agent = arguments.text("agent")};
  if (const auto tick = arguments.number("tick", 0, diagnostics)) {
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
  const auto found = deliberations(*store, *test, wanted);
  if (!found.ok()) {
    console.report(found.diagnostics());
    return ExitCode::failed;
  }
  if (const auto path = arguments.text("json")) {
    const bool written = write_output(*path, explanation_json(found.value()), console);
    return written ? ExitCode::success : ExitCode::failed;
  }
  console.print(fmt::format("{}\n\n", name_of(*store, *test)));
  const std::string text = explanation_text(found.value());
  console.print(text.empty() ? "no deliberation: nothing happened that a plan is for\n" : text);
  return ExitCode::success;
}

}  // namespace jaywalk::command::explain

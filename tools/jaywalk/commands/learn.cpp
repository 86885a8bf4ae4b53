// SPDX-License-Identifier: Apache-2.0
// `jaywalk learn`: agents learn which of their plans to choose, from tests.

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "experiment/learning/training.h"
#include "experiment/scenario/files/write_file.h"
#include "experiment/scenario/number_list.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/support/text.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/progress_line.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"

namespace jaywalk::command::learn {
namespace {

/// More tests than this are a slip.
constexpr std::uint64_t kMostTests = 1'000'000'000;
/// How often the policy is saved while learning, in case the process is killed.
constexpr auto kKeepEvery = std::chrono::seconds(2);

struct Request {
  TrainingPlan plan;
  std::uint64_t tests = 1000;
  std::string file;
  bool resume = false;
};

std::optional<Request> read_request(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  const auto file = only_input(arguments, "learn", "scenario", kScenarios, diagnostics);
  if (!arguments.has(option::kPolicy)) {
    diagnostics.error(option::kPolicy.dashed(), "expected a file to keep what is learned in",
                      "--policy learned.json");
  }
  const auto agents = arguments.number(option::kAgents, 1, diagnostics, kMaxAgents);
  const auto tests = arguments.number(option::kTests, 1, diagnostics, kMostTests);
  const auto seed = arguments.number(option::kSeed, 0, diagnostics);
  const unsigned threads = read_threads(arguments, diagnostics);
  // No policy is read but the one that goes on.
  std::vector<std::string> sets{"policy=[]"};
  std::ranges::copy(limit_sets(arguments, diagnostics), std::back_inserter(sets));
  console.report(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::vector<std::string> behaviours;
  if (const auto behaviour = arguments.text(option::kBehaviour)) behaviours.push_back(*behaviour);
  Request request{.file = *arguments.text(option::kPolicy),
                  .resume = arguments.has(option::kResume)};
  request.plan.prepared = prepare_scenario(*file, arguments, std::move(behaviours), console, sets);
  if (request.plan.prepared == nullptr) return std::nullopt;
  const ExperimentSpec& defaults = request.plan.prepared->scenario().experiment;
  request.plan.agents = static_cast<std::uint32_t>(agents.value_or(defaults.agents.front()));
  request.plan.seed = seed.value_or(defaults.seed);
  request.plan.threads = threads;
  request.plan.sets = arguments.texts(option::kSet);
  request.tests = tests.value_or(defaults.tests);
  const std::string why =
      problem(*request.plan.prepared, {.agents = request.plan.agents, .seed = request.plan.seed});
  if (!why.empty()) console.error(why);
  return why.empty() ? std::optional(std::move(request)) : std::nullopt;
}

/// The policy to continue: that of the file, with --resume, or one that has learned nothing. Null
/// after reporting an error.
std::shared_ptr<Policy> policy_for(const Request& request, Console& console) {
  std::error_code ignored;
  if (!std::filesystem::exists(request.file, ignored)) {
    auto made = new_policy(request.plan);
    if (!made.ok()) console.report(made.diagnostics());
    return made.ok() ? made.value() : nullptr;
  }
  if (!request.resume) {
    console.error(fmt::format("{} is there already", request.file),
                  "--resume goes on with it; otherwise remove it, or name another file");
    return nullptr;
  }
  const auto source = read_source(request.file, kMostPolicyBytes);
  const auto policy = source.ok() ? parse_policy(source.value())
                                  : Result<std::shared_ptr<Policy>>(source.diagnostics());
  if (!policy.ok()) {
    console.report(policy.diagnostics());
    return nullptr;
  }
  const std::string why = why_not_the_same(request.plan, *policy.value());
  if (why.empty()) return policy.value();
  console.error(fmt::format("{} cannot be gone on with: {}", request.file, why));
  return nullptr;
}

bool keep(const Request& request, const Policy& policy, Console& console) {
  const auto problem = write_file(request.file, policy.text());
  if (problem) console.error(fmt::format("cannot write {}: {}", request.file, *problem));
  if (!problem) console.wrote(request.file);
  return !problem;
}

std::string how_it_goes(const Policy& policy) {
  if (policy.origin().curve.empty()) return "nothing learned yet";
  const LearningPoint& last = policy.origin().curve.back();
  return fmt::format("reward {:.1f}, accuracy {:.0f} %", last.reward, last.success_pct);
}

/// The curve in ten parts.
std::string curve_text(const Policy& policy) {
  const std::vector<LearningPoint>& curve = policy.origin().curve;
  constexpr std::size_t kParts = 10;
  std::string text = fmt::format("{:>10}  {:>10}  {:>10}\n", "tests", "reward", "accuracy");
  std::size_t begin = 0;
  for (std::size_t part = 1; part <= kParts; ++part) {
    const std::size_t end = curve.size() * part / kParts;
    if (end == begin) continue;
    double reward = 0;
    double success = 0;
    for (std::size_t i = begin; i < end; ++i) {
      reward += curve[i].reward;
      success += curve[i].success_pct;
    }
    const auto count = static_cast<double>(end - begin);
    text += fmt::format("{:>10}  {:>10.2f}  {:>8.1f} %\n", curve[end - 1].tests, reward / count,
                        success / count);
    begin = end;
  }
  return text;
}

ExitCode train(const Request& request, Training& training, Console& console) {
  ProgressLine line(console);
  auto kept = std::chrono::steady_clock::now();
  const std::uint64_t before = training.policy().origin().tests;
  while (training.policy().origin().tests < request.tests) {
    const std::uint64_t done = training.policy().origin().tests;
    line.show({.done = done - before, .total = request.tests - before},
              how_it_goes(training.policy()));
    std::string problem;
    const Training::End end = training.run_generation(request.tests - done, problem);
    if (end == Training::End::learned && std::chrono::steady_clock::now() - kept < kKeepEvery) {
      continue;
    }
    kept = std::chrono::steady_clock::now();
    if (!keep(request, training.policy(), console)) return ExitCode::failed;
    if (end == Training::End::interrupted) {
      line.clear();
      console.note(
          fmt::format("interrupted after {}, which {} has; the same command with "
                      "--resume goes on",
                      counted(done, "test"), request.file));
      return ExitCode::interrupted;
    }
    if (end == Training::End::failed) {
      line.clear();
      console.error(problem);
      return ExitCode::failed;
    }
  }
  return keep(request, training.policy(), console) ? ExitCode::success : ExitCode::failed;
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "SCENARIO.yaml --policy FILE [OPTIONS]",
      .description =
          "Lets the agents of a behaviour learn which of its plans to choose: those that\n"
          "are labelled learned(P), by what its rules observation(P, Features) answer and\n"
          "what the scenario rewards (its key `learning`). Runs tests in generations and\n"
          "writes what is learned to FILE, which `run`, `compare`, `search` and scenarios\n"
          "(`policy`) take. With --defects, the AVs of the tests have these defects in turn.\n"
          "What is learned does not depend on --threads.\n",
      .options =
          {
              {option::kPolicy, "FILE", "where what is learned is kept", Written::file},
              {option::kResume, "", "go on with FILE, up to --tests in all"},
              {option::kBehaviour, "FILE",
               "this program (.asl), behaviour of the scenario or installed one\n"
               "(jaywalk list behaviours) instead of the first"},
              {option::kAgents, "N", "the number of pedestrians in each test"},
              {option::kTests, "N", "tests to learn from"},
              {option::kLearner, "NAME", "who learns (jaywalk list learners)"},
              {option::kDefects, "LIST",
               "the AV has each of these defects in turn (jaywalk list defects)"},
              {option::kThreads, "N", "threads (default: as many as cores)"},
              {option::kQuiet, "", "print no table"},
          },
      .examples =
          "  jaywalk learn scenarios/learning/steps.yaml --policy learned.json\n"
          "  jaywalk compare scenarios/learning/steps.yaml --policy learned.json --seed 1\n"
          "  jaywalk learn scenarios/learning/steps.yaml --learner actor-critic --policy "
          "ac.json\n"};
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  help.options.insert(help.options.end(), kScenarioOptions.begin(), kScenarioOptions.end());
  help.options.insert(help.options.end(), kLimitOptions.begin(), kLimitOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  std::optional<Request> request = read_request(arguments, console);
  if (!request) return ExitCode::usage;
  const InterruptGuard interrupt;
  request->plan.interrupted = [&] { return interrupt.interrupted(); };
  const std::shared_ptr<Policy> policy = policy_for(*request, console);
  if (policy == nullptr) return ExitCode::usage;
  Training training(request->plan, policy);
  const ExitCode code = train(*request, training, console);
  for (const std::string& note : training.notes().texts()) console.note(note);
  if (code != ExitCode::success) return code;
  if (!arguments.has(option::kQuiet)) console.print(curve_text(training.policy()));
  if (const std::uint64_t errored = policy->origin().errored; errored > 0) {
    console.note(fmt::format("{} of {} tests ended errored, and nothing was learned from them",
                             errored, policy->origin().tests));
  }
  return ExitCode::success;
}

}  // namespace jaywalk::command::learn

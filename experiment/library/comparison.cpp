// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <utility>

#include <fmt/format.h>

#include "experiment/library/library.h"
#include "experiment/run/run_comparison.h"
#include "experiment/scenario/number_list.h"
#include <jaywalk/comparison.h>

namespace jaywalk {
namespace {

ComparisonRequest request_for(const RunnableScenario& scenario, const ComparisonOptions& options) {
  ComparisonRequest request = comparison_request(scenario.prepared());
  request.options = scenario.options();
  request.seed = options.seed.value_or(scenario.seed());
  request.plan.agents = options.agents.value_or(scenario.agents());
  request.plan.tests = options.tests.value_or(scenario.tests());
  request.plan.threads = options.threads;
  request.criteria = options.rules.value_or(scenario.rules()).criteria();
  if (!options.store.empty()) {
    request.store = StoreOptions{.path = options.store, .resume = options.resume};
  }
  return request;
}

// The checks that the command makes as it reads its options.
Diagnostics obstacles(const ComparisonRequest& request, const ComparisonOptions& options) {
  Diagnostics diagnostics;
  const ExperimentPlan& plan = request.plan;
  if (plan.tests == 0 || plan.tests > kMaxTests) {
    diagnostics.error("tests", fmt::format("expected 1 to {}, found {}", kMaxTests, plan.tests));
  }
  const auto is_possible = [](std::uint32_t agents) { return agents > 0 && agents <= kMaxAgents; };
  if (plan.agents.empty() || !std::ranges::all_of(plan.agents, is_possible)) {
    diagnostics.error(
        "agents",
        fmt::format("expected one number of agents or more, each from 1 to {}", kMaxAgents));
  }
  if (options.threads == 0 || options.threads > kMaxThreads) {
    diagnostics.error("threads",
                      fmt::format("expected 1 to {}, found {}", kMaxThreads, options.threads));
  }
  if (!options.store.empty() && request.prepared->scenario().world->vehicle().own) {
    diagnostics.error(options.store, "a store cannot keep tests of a program's own AV");
  }
  if (options.resume && options.store.empty()) {
    diagnostics.error("resume", "there is no store to go on with");
  }
  return diagnostics;
}

}  // namespace

Result<ComparisonReport> compare(const RunnableScenario& scenario,
                                 const ComparisonOptions& options) {
  const ComparisonRequest request = request_for(scenario, options);
  if (Diagnostics found = obstacles(request, options); found.has_errors()) return found;
  std::atomic<bool> is_given_up = false;
  ComparisonHooks hooks;
  hooks.interrupted = [&] { return is_given_up.load(); };
  if (options.progress) {
    hooks.progress = [&](const Progress& now) {
      if (!options.progress(now.done, now.total)) is_given_up = true;
    };
  }
  const auto results = run_comparison(request, hooks);
  if (!results) return results.diagnostics();
  ComparisonReport report = report_of(results.value().comparison);
  report.is_complete = results.value().comparison.complete;
  return report;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <fmt/format.h>

#include "experiment/compare/carry_over.h"
#include "experiment/run/run_comparison.h"
#include "experiment/test_run/test_run.h"
#include "experiment/test_run/tested_vehicles.h"

namespace jaywalk {
namespace {

/// Errors that make a comparison of several AVs impossible; `option` names them.
void check_vehicles(const ComparisonRequest& request, const std::string& option,
                    Diagnostics& diagnostics) {
  if (request.prepared->scenario().experiment.feedback > 0) {
    diagnostics.error(option, "what tests cover would reach those with other AVs",
                      "experiment.feedback=0 runs them without that");
  }
  if (request.plan.order == TestOrder::chained) {
    diagnostics.error(option, "each test of this scenario needs the one before it",
                      "set world.av.carry_over=false");
  }
}

/// Errors that make a search for defects impossible.
void check_defects(const ComparisonRequest& request, Diagnostics& diagnostics) {
  const std::string option = "--defects";
  if (request.criteria.assertions.empty()) {
    diagnostics.error(option, "without assertions nothing blames an AV",
                      "--assertions names a file of them, as scenarios/assertions/crossing.yaml");
  }
  const auto& vehicle = request.prepared->world(0).spec().vehicle();
  if (vehicle.model == "constant" && !vehicle.own) {
    diagnostics.error(option, "the AV is of the model constant: no defect shows in it",
                      "set world.av.model to one that brakes (jaywalk list vehicles)");
  }
  check_vehicles(request, option, diagnostics);
}

/// Errors that make a comparison of models of the AV impossible.
void check_models(const ComparisonRequest& request, Diagnostics& diagnostics) {
  const std::string option = "--avs";
  if (!request.prepared->scenario().experiment.defects.empty()) {
    diagnostics.error(option, "models and defects cannot be compared at once",
                      "leave out one of experiment.avs and experiment.defects");
  }
  check_vehicles(request, option, diagnostics);
}

/// Errors that make it impossible to run a part of the tests by itself.
void check_shard(const ComparisonRequest& request, Diagnostics& diagnostics) {
  const std::string option = "--shard";
  if (request.prepared->scenario().experiment.feedback > 0) {
    diagnostics.error(option, "the tests of a part need what the other parts' tests cover",
                      "experiment.feedback=0 runs them without that");
  }
  if (request.plan.order == TestOrder::chained) {
    diagnostics.error(option, "each test of this scenario needs the one before it",
                      "share out behaviours and numbers of agents instead (--behaviours, "
                      "--agents), or set world.av.carry_over=false");
  }
}

/// Why some test cannot be run; empty if all can.
std::string first_obstacle(const ComparisonRequest& request) {
  for (const std::uint32_t agents : request.plan.agents) {
    for (std::uint64_t test = 0; test < request.plan.tests; ++test) {
      // Obstacles are the same for all behaviours, and only given starts can be too few.
      std::string why =
          problem(*request.prepared, {.agents = agents, .seed = request.seed, .test = test});
      if (!why.empty() || !request.prepared->scenario().world->has_given_starts()) return why;
    }
  }
  return {};
}

}  // namespace

ComparisonRequest comparison_request(std::shared_ptr<const PreparedScenario> prepared) {
  const Scenario& scenario = prepared->scenario();
  ComparisonRequest request{.seed = scenario.experiment.seed,
                            .plan = {.agents = scenario.experiment.agents,
                                     .tests = scenario.experiment.tests,
                                     .vehicles = prepared->vehicles(),
                                     .order = test_order(scenario)},
                            .criteria = {.assertions = scenario.assertions}};
  for (const PreparedBehaviour& behaviour : prepared->behaviours()) {
    request.plan.behaviours.push_back(behaviour.name);
  }
  request.prepared = std::move(prepared);
  return request;
}

ExperimentDescription describe(const ComparisonRequest& request) {
  ExperimentDescription description =
      describe(*request.prepared, request.options, request.plan, request.seed);
  add_judging(description, request.criteria.files, request.criteria.metrics);
  make_portable(description, request.prepared->scenario().files);
  description.simulator = request.simulator.value_or("");
  return description;
}

Diagnostics problems(const ComparisonRequest& request) {
  Diagnostics diagnostics;
  if (request.plan.tests > kMaxTests) {  // the scenario's
    diagnostics.error("experiment.tests",
                      fmt::format("at most {}, found {}", kMaxTests, request.plan.tests));
  }
  if (request.store && request.store->shard.count > 1) check_shard(request, diagnostics);
  if (compares_models(request.plan.vehicles)) {
    check_models(request, diagnostics);
  } else if (request.plan.vehicles.size() > 1) {
    check_defects(request, diagnostics);
  }
  if (diagnostics.has_errors()) return diagnostics;
  if (std::string why = first_obstacle(request); !why.empty()) {
    diagnostics.error(std::string(), std::move(why));
  }
  return diagnostics;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/explanation_json.h"

#include <nlohmann/json.hpp>

namespace jaywalk {
namespace {

using nlohmann::ordered_json;

std::string_view name(TriedPlan::State state) {
  switch (state) {
    case TriedPlan::State::not_matching:
      return "not matching";
    case TriedPlan::State::not_applicable:
      return "not applicable";
    case TriedPlan::State::applicable:
      return "applicable";
    case TriedPlan::State::chosen:
      return "chosen";
    case TriedPlan::State::not_tried:
      return "not tried";
  }
  return {};
}

ordered_json to_json(const AskedCondition& asked) {
  ordered_json bindings = ordered_json::object();
  for (const auto& [variable, value] : asked.bindings) bindings[variable] = value;
  ordered_json result{{"condition", asked.text},
                      {"negated", asked.negated},
                      {"held", asked.held},
                      {"bindings", std::move(bindings)}};
  if (!asked.rule.empty()) result["rule"] = asked.rule;
  if (!asked.hint.empty()) result["hint"] = asked.hint;
  return result;
}

ordered_json to_json(const TriedPlan& plan) {
  ordered_json conditions = ordered_json::array();
  for (const AskedCondition& asked : plan.asked) conditions.push_back(to_json(asked));
  ordered_json result{{"trigger", plan.trigger},
                      {"where", plan.where},
                      {"state", name(plan.state)},
                      {"conditions", std::move(conditions)}};
  const bool failed = plan.state == TriedPlan::State::not_applicable;
  if (failed && plan.failed < plan.asked.size()) result["failed"] = plan.failed;
  return result;
}

ordered_json to_json(const DrawnChoice& drawn) {
  ordered_json options = ordered_json::object();
  for (const auto& [label, probability] : drawn.options) options[label] = probability;
  return {{"policy", drawn.policy},
          {"features", drawn.features},
          {"options", std::move(options)},
          {"chosen", drawn.options[drawn.chosen].first}};
}

ordered_json failure_json(const Deliberation& deliberation) {
  const FailedFormula& failed = *deliberation.failure;
  return {{"tick", deliberation.tick}, {"agent", deliberation.agent}, {"failed", failed.formula},
          {"where", failed.where},     {"error", failed.error},       {"message", failed.message},
          {"goals", failed.goals},     {"dropped", !failed.has_plan}};
}

}  // namespace

std::string explanation_json(std::span<const Deliberation> deliberations) {
  ordered_json all = ordered_json::array();
  for (const Deliberation& deliberation : deliberations) {
    if (deliberation.failure) {
      all.push_back(failure_json(deliberation));
      continue;
    }
    ordered_json plans = ordered_json::array();
    for (const TriedPlan& plan : deliberation.plans) plans.push_back(to_json(plan));
    ordered_json beliefs = ordered_json::array();
    for (const AskedBelief& belief : deliberation.beliefs) {
      beliefs.push_back({{"belief", belief.literal}, {"origin", belief.origin}});
    }
    ordered_json entry{{"tick", deliberation.tick},
                       {"agent", deliberation.agent},
                       {"event", deliberation.event},
                       {"plans", std::move(plans)},
                       {"beliefs", std::move(beliefs)}};
    if (deliberation.drawn) entry["drawn"] = to_json(*deliberation.drawn);
    if (!deliberation.hint.empty()) entry["hint"] = deliberation.hint;
    all.push_back(std::move(entry));
  }
  return all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Explanations as text.

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/explain/explanation.h"

namespace jaywalk {
namespace {

constexpr std::size_t kShownOfRules = 8;

std::string bindings_text(const AskedCondition& asked) {
  std::string text;
  for (const auto& [name, value] : asked.bindings) {
    text += fmt::format("{}{} = {}", text.empty() ? "  with " : ", ", name, value);
  }
  return text;
}

void add_condition(std::string& out, const AskedCondition& asked, std::string_view indent,
                   bool failed) {
  out += fmt::format("{}{} {}{}{}{}\n", indent, asked.held ? "yes" : "no ",
                     asked.negated ? "within not (...): " : "", asked.text, bindings_text(asked),
                     failed ? "   <- here it fails" : "");
  if (!asked.hint.empty()) out += fmt::format("{}    {}\n", indent, asked.hint);
}

std::string_view word_for(const TriedPlan& plan) {
  switch (plan.state) {
    case TriedPlan::State::not_matching:
      return "not relevant: the trigger does not match";
    case TriedPlan::State::not_applicable:
      return "relevant, not applicable";
    case TriedPlan::State::applicable:
      return "applicable, not chosen";
    case TriedPlan::State::chosen:
      return "chosen";
    case TriedPlan::State::not_tried:
      return "not asked: a plan before it was applicable";
  }
  return {};
}

// The conditions of rules that were asked for the one at `first` - 1; the last ones are the most
// informative.
void add_rules(std::string& out, const std::vector<AskedCondition>& asked, std::size_t first,
               std::size_t last) {
  const std::size_t shown = std::max(first, last - std::min(last, kShownOfRules));
  if (shown > first) out += fmt::format("         ({} conditions before these)\n", shown - first);
  for (std::size_t i = shown; i < last; ++i) {
    if (i == shown || asked[i - 1].rule != asked[i].rule) {
      out += fmt::format("         in {}\n", asked[i].rule);
    }
    add_condition(out, asked[i], "           ", false);
  }
}

// A context that goes back asks the same conditions again and again: the last time is the most
// informative.
void add_conditions(std::string& out, const TriedPlan& plan) {
  const std::vector<AskedCondition>& asked = plan.asked;
  std::map<std::size_t, std::vector<std::size_t>> places;  // by condition of the context
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (!asked[i].in_rule) places[asked[i].number].push_back(i);
  }
  const bool failed = plan.state == TriedPlan::State::not_applicable;
  for (const auto& [number, times] : places) {
    const bool here = failed && plan.failed < asked.size() && asked[plan.failed].number == number;
    const std::size_t place = here ? plan.failed : times.back();
    add_condition(out, asked[place], "     ", here);
    if (times.size() > 1) out += fmt::format("         (asked {} times)\n", times.size());
    std::size_t last = place + 1;
    while (last < asked.size() && asked[last].in_rule) ++last;
    add_rules(out, asked, place + 1, last);
  }
}

void add_plan(std::string& out, std::size_t number, const TriedPlan& plan) {
  out += fmt::format("  {}. {}  ({})\n     {}\n", number, plan.trigger, plan.where, word_for(plan));
  add_conditions(out, plan);
}

// "step observes [3, 12]: go 0.70 (drawn), stay 0.30".
std::string drawn_text(const DrawnChoice& drawn) {
  std::vector<std::string> options;
  for (std::size_t i = 0; i < drawn.options.size(); ++i) {
    options.push_back(fmt::format("{} {:.2f}{}", drawn.options[i].first, drawn.options[i].second,
                                  i == drawn.chosen ? " (drawn)" : ""));
  }
  return fmt::format("  {} observes [{}]: {}\n", drawn.policy, fmt::join(drawn.features, ", "),
                     fmt::join(options, ", "));
}

std::string conclusion(const Deliberation& deliberation) {
  const TriedPlan* const chosen = deliberation.chosen();
  if (chosen != nullptr) {
    const auto applicable = std::count_if(
        deliberation.plans.begin(), deliberation.plans.end(),
        [](const TriedPlan& plan) { return plan.state == TriedPlan::State::applicable; });
    const std::string how = deliberation.drawn
                                ? fmt::format("drawn by its policy {}", deliberation.drawn->policy)
                            : applicable == 0 ? "the first that is applicable"
                                              : "by the agent's own choice among several";
    return fmt::format("{}  chosen: {} ({}), {}\n",
                       deliberation.drawn ? drawn_text(*deliberation.drawn) : "", chosen->trigger,
                       chosen->where, how);
  }
  const bool relevant = std::any_of(
      deliberation.plans.begin(), deliberation.plans.end(),
      [](const TriedPlan& plan) { return plan.state == TriedPlan::State::not_applicable; });
  std::string text = relevant ? "  chosen: none, no relevant plan is applicable\n"
                              : "  chosen: none, no plan is relevant\n";
  if (!deliberation.hint.empty()) text += fmt::format("  {}\n", deliberation.hint);
  return text;
}

void add_failure(std::string& out, const Deliberation& deliberation) {
  const FailedFormula& failed = *deliberation.failure;
  out += fmt::format("{}tick {}, {}: {} failed\n", out.empty() ? "" : "\n", deliberation.tick,
                     deliberation.agent, failed.formula.empty() ? "a formula" : failed.formula);
  out +=
      fmt::format("  {}{}{}\n", failed.error, failed.message.empty() ? "" : ": ", failed.message);
  if (!failed.where.empty()) out += fmt::format("  at {}\n", failed.where);
  if (!failed.goals.empty()) out += fmt::format("  goals: {}\n", failed.goals);
  if (!failed.has_plan) {
    out += "  no plan is for the failure of these goals: the intention is dropped\n";
  }
}

}  // namespace

std::string explanation_text(std::span<const Deliberation> deliberations) {
  std::string out;
  for (const Deliberation& deliberation : deliberations) {
    if (deliberation.failure) {
      add_failure(out, deliberation);
      continue;
    }
    out += fmt::format("{}tick {}, {}: {}\n", out.empty() ? "" : "\n", deliberation.tick,
                       deliberation.agent, deliberation.event);
    std::size_t number = 0;
    for (const TriedPlan& plan : deliberation.plans) add_plan(out, ++number, plan);
    out += conclusion(deliberation);
    if (!deliberation.beliefs.empty()) out += "  beliefs that were asked for:\n";
    for (const AskedBelief& belief : deliberation.beliefs) {
      out += fmt::format("     {}{}{}\n", belief.literal, belief.origin.empty() ? "" : "  ",
                         belief.origin);
    }
  }
  return out;
}

}  // namespace jaywalk

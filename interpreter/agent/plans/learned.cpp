// SPDX-License-Identifier: Apache-2.0
// Rule SelAppl where plans are options of a policy (learned_choice.h).

#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

/// The option that a number from [0, 1) draws. Rounding may leave the sum below 1; then the last
/// one that is possible is meant.
std::size_t draw_from(std::span<const double> probabilities, double number) {
  std::size_t chosen = 0;
  double sum = 0;
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    if (probabilities[i] <= 0) continue;
    chosen = i;
    sum += probabilities[i];
    if (number < sum) break;
  }
  return chosen;
}

}  // namespace

// The first plan that is applicable decides, as always. If it is an option of a policy, the other
// applicable options of that policy are found, too.
bool Agent::try_learned(const PlanList& plans, const Event& event, const ScopePtr& scope) {
  work().had_candidates = work().had_candidates || !plans.plans().empty();
  (void)literal_of(event);
  std::vector<Option> options;
  for (const Plan* const plan : plans.plans()) {
    if (options.empty() && plan->policy.is_unset()) {
      const std::span<const Value> enclosing =
          scope == nullptr ? std::span<const Value>() : scope->frame;
      if (!is_applicable(*plan, event, enclosing)) continue;
      add_intended_means(*plan, event, scope);
      return true;
    } else if (options.empty() || plan->policy.same_as(options.front().plan->policy)) {
      find_options(*plan, event, scope, options);
    }
  }
  return !options.empty() && choose_learned(options, event);
}

// A choice that cannot be made fails the goal: no other plan replaces it.
bool Agent::choose_learned(std::vector<Option>& options, const Event& event) {
  const Plan& first = *options.front().plan;
  const std::string policy = term_text(first.policy, symbols_);
  ActionError error;
  std::vector<double> features;
  if (!observe_for(first, features, error)) {
    fail_event(event, error);
    return true;
  }
  std::vector<std::string> labels;
  for (const Option& option : options) {
    labels.emplace_back(symbols_.functor(literal_parts(option.plan->label).predicate));
  }
  const LearnedChoice choice{
      .agent = *this, .policy = policy, .features = features, .options = labels};
  std::vector<double> probabilities(options.size(), 1 / static_cast<double>(options.size()));
  OptionPolicies* const policies = host_.policies();
  if (policies != nullptr) error.message = policies->weigh(choice, probabilities);
  if (!error.message.empty()) {
    error.id = "no_option";
    fail_event(event, error);
    return true;
  }
  const DrawnOption drawn{.probabilities = probabilities,
                          .chosen = draw_from(probabilities, random_.next_double())};
  if (policies != nullptr) policies->drawn(choice, drawn);
  if (observer_ != nullptr) observer_->option_drawn(*this, choice, drawn);
  intend(options[drawn.chosen], event);
  return true;
}

// The features of the first answer to observation(P, Features), evaluated. False: `error` has the
// error in it.
bool Agent::observe_for(const Plan& plan, std::vector<double>& features, ActionError& error) {
  Unifier& unifier = machine().unifier();
  const std::string policy = term_text(plan.policy, symbols_);
  Value list = heap_.variable(symbols_.symbol("Features"));
  const std::array<Value, 2> args{plan.policy, list};
  const Value query = heap_.structure(predicates::observation, args);
  const std::size_t trail = unifier.mark();
  const bool answered = guarded(error, [&] {
    const bool found = machine().solve_term(query);
    if (found) list = unifier.apply(list);
    return found;
  });
  unifier.undo(trail);
  error.id = "no_observation";
  if (!answered) {
    if (!error.message.empty()) return false;
    error.message =
        fmt::format("{} needs a rule or belief observation({}, Features)", plan_name(plan), policy);
    return false;
  }
  Value rest = deref(list);
  for (; rest.is_pair(); rest = deref(rest.pair()->tail)) {
    const Value value = deref(rest.pair()->head);
    if (!value.is_number() || !std::isfinite(value.as_number())) break;
    features.push_back(value.as_number());
  }
  if (rest.is_empty_list()) return true;
  error.message = fmt::format("observation({}, {}) is to be a list of numbers", policy,
                              brief_text(list, symbols_));
  return false;
}

}  // namespace jaywalk

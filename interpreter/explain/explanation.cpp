// SPDX-License-Identifier: Apache-2.0
#include "interpreter/explain/explanation.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/explain/near_misses.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

// The most beliefs kept of a plan, and of the rules queried for one condition of a context.
constexpr std::size_t kMostAsked = 10'000;
constexpr std::size_t kMostInRules = 200;
constexpr std::size_t kMostBeliefs = 20;  // of a predicate
constexpr std::size_t kMostText = 2000;   // of a literal, in bytes

std::string short_text(Value term, const SymbolTable& symbols) {
  std::string text = term_text(term, symbols);
  if (text.size() > kMostText) text = text.substr(0, kMostText) + "...";
  return text;
}

// A belief's source, by the first of its annotations source(Name).
std::string source_of(Value literal, const SymbolTable& symbols) {
  for (Value a = literal_parts(literal).annots; a.is_pair(); a = deref(a.pair()->tail)) {
    const Value annot = deref(a.pair()->head);
    if (annot.is_structure() && symbols.functor(annot.structure()->predicate()) == "source") {
      return term_text(annot.structure()->arg(0), symbols);
    }
  }
  return {};
}

enum class Answered { none, some };

// A condition as written, with what stands right before it.
bool holds(const ProbedCondition& condition, Answered answer) {
  return (answer == Answered::some) == (condition.nots % 2 == 0);
}

}  // namespace

const TriedPlan* Deliberation::chosen() const {
  const auto found = std::find_if(plans.begin(), plans.end(), [](const TriedPlan& plan) {
    return plan.state == TriedPlan::State::chosen;
  });
  return found == plans.end() ? nullptr : &*found;
}

ExplainingObserver::ExplainingObserver(const Probes& probes, const ProbeTexts& texts, Wanted wanted)
    : probes_(probes), texts_(texts), wanted_(std::move(wanted)) {}

bool ExplainingObserver::is_wanted(const Agent& agent) const {
  return wanted_.agent.value_or(agent.name()) == agent.name() &&
         wanted_.tick.value_or(tick_) == tick_;
}

const Goal* ExplainingObserver::context_of(const Plan& plan) {
  const std::size_t index = probes_.find(plan);
  return index == Probes::kNone ? plan.context : probes_.plans()[index].context;
}

const RuleCode& ExplainingObserver::rule_for(const RuleCode& rule) {
  const std::size_t index = probes_.find(rule);
  return index == Probes::kNone ? rule : *probes_.rules()[index].probed;
}

void ExplainingObserver::event_selected(Agent& agent, const Event& event) {
  recording_ = is_wanted(agent);
  plans_.clear();
  if (!recording_) return;
  deliberations_.push_back({.agent = agent.name(),
                            .tick = tick_,
                            .event = trigger_operator(event.op, event.kind) +
                                     short_text(event.literal, agent.symbols())});
}

TriedPlan& ExplainingObserver::entry(const Plan& plan) {
  std::vector<TriedPlan>& entries = deliberations_.back().plans;
  const auto found = std::find(plans_.begin(), plans_.end(), &plan);
  if (found != plans_.end()) return entries[static_cast<std::size_t>(found - plans_.begin())];
  plans_.push_back(&plan);
  const std::size_t index = probes_.find(plan);
  TriedPlan made;
  if (index != Probes::kNone && texts_.plans[index].source != nullptr) {
    made.trigger = texts_.plans[index].text;
  } else {
    made.trigger = trigger_operator(plan.key.op, plan.key.kind) + "...";
  }
  made.where = plan.line == 0 ? "made at run time" : fmt::format("{}:{}", plan.file, plan.line);
  entries.push_back(std::move(made));
  return entries.back();
}

void ExplainingObserver::plan_relevant(Agent&, const Plan& plan, const Event&,
                                       std::span<const Value>) {
  if (!recording_ || plan.is_standard) return;
  TriedPlan& tried = entry(plan);
  tried.asked.clear();
  current_ = static_cast<std::size_t>(&tried - deliberations_.back().plans.data());
  trying_ = true;
  in_rules_ = 0;
}

std::size_t ExplainingObserver::condition_asked(Agent& agent, std::size_t number,
                                                std::span<const Value> variables) {
  if (!trying_) return 0;
  std::vector<AskedCondition>& asked = deliberations_.back().plans[current_].asked;
  const std::size_t rule = rule_of(number);
  in_rules_ = rule == Probes::kNone ? 0 : in_rules_ + 1;
  if (asked.size() >= kMostAsked || in_rules_ > kMostInRules) return kMostAsked + 1;
  const ProbedCondition& condition = probes_.conditions()[number];
  AskedCondition made{.number = number, .negated = condition.negated};
  for (std::uint32_t i = 0; i < condition.nots; ++i) made.text += "not ";
  made.text += texts_.conditions[number].text;
  made.held = holds(condition, Answered::none);
  if (rule != Probes::kNone) {
    made.in_rule = true;
    made.rule = texts_.rules[rule].text;
  }
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const Symbol name = condition.slot_names[condition.slots[i]];
    const Value value = deref(variables[i]);
    if (name == names::unnamed || value.is_variable()) continue;
    made.bindings.emplace_back(agent.symbols().text(name), short_text(value, agent.symbols()));
  }
  asked.push_back(std::move(made));
  return asked.size();
}

void ExplainingObserver::condition_answered(Agent&, std::size_t number, std::size_t asking) {
  if (!trying_ || asking > kMostAsked) return;
  std::vector<AskedCondition>& asked = deliberations_.back().plans[current_].asked;
  if (asking > 0) {
    if (asking <= asked.size()) {
      asked[asking - 1].held = holds(probes_.conditions()[number], Answered::some);
    }
    return;
  }
  const auto latest = std::find_if(asked.rbegin(), asked.rend(), [&](const AskedCondition& each) {
    return each.number == number;
  });
  if (latest != asked.rend()) latest->held = holds(probes_.conditions()[number], Answered::some);
}

std::size_t ExplainingObserver::rule_of(std::size_t condition) const {
  const auto& rules = probes_.rules();
  const auto after = std::upper_bound(
      rules.begin(), rules.end(), condition,
      [](std::size_t number, const ProbedRule& rule) { return number < rule.first_condition; });
  if (after == rules.begin()) return Probes::kNone;
  const ProbedRule& rule = *std::prev(after);
  if (condition >= rule.first_condition + rule.conditions) return Probes::kNone;
  return static_cast<std::size_t>(&rule - rules.data());
}

// The condition of the context that came farthest is the one to look at.
void ExplainingObserver::find_failure(TriedPlan& tried) const {
  tried.failed = tried.asked.size();
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < tried.asked.size(); ++i) {
    const AskedCondition& asked = tried.asked[i];
    if (asked.in_rule || asked.is_fine() || asked.number < farthest) continue;
    farthest = asked.number;
    tried.failed = i;
  }
}

void ExplainingObserver::plan_tried(Agent& agent, const Plan&, bool applicable) {
  if (!trying_) return;
  trying_ = false;
  TriedPlan& tried = deliberations_.back().plans[current_];
  tried.state = applicable ? TriedPlan::State::applicable : TriedPlan::State::not_applicable;
  find_failure(tried);
  for (AskedCondition& asked : tried.asked) {
    const ProbedCondition& condition = probes_.conditions()[asked.number];
    if (!asked.held && !asked.negated && condition.nots == 0 && condition.asks &&
        !agent.symbols().signature(*condition.asks).dotted) {
      asked.hint = missing_belief_hint(agent, *condition.asks);
    }
  }
}

void ExplainingObserver::option_drawn(Agent&, const LearnedChoice& choice,
                                      const DrawnOption& drawn) {
  if (!recording_) return;
  DrawnChoice made{.policy = std::string(choice.policy),
                   .features = {choice.features.begin(), choice.features.end()},
                   .chosen = drawn.chosen};
  for (std::size_t i = 0; i < choice.options.size(); ++i) {
    made.options.emplace_back(choice.options[i], drawn.probabilities[i]);
  }
  deliberations_.back().drawn = std::move(made);
}

void ExplainingObserver::plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                                     const Intention&) {
  if (!recording_) return;
  recording_ = false;
  if (plan.is_standard) {  // a message that no plan of the program is for
    deliberations_.pop_back();
    return;
  }
  entry(plan).state = TriedPlan::State::chosen;
  add_candidates(agent, event);
  add_beliefs(agent);
}

void ExplainingObserver::no_plan(Agent& agent, const Event& event, bool had_candidates) {
  trying_ = false;
  if (!recording_) return;
  recording_ = false;
  add_candidates(agent, event);
  add_beliefs(agent);
  if (!had_candidates) deliberations_.back().hint = missing_plan_hint(agent, event);
}

void ExplainingObserver::formula_failed(Agent& agent, const Intention& intention,
                                        const ActionError& error) {
  if (!is_wanted(agent) || intention.is_finished()) return;
  const IntendedMeans& top = intention.top();
  FailedFormula failed{.where = formula_place(intention),
                       .error = error.id,
                       .message = error.message,
                       .goals = goal_stack_text(intention, agent.symbols())};
  if (!top.is_finished()) {
    show_with_values(agent, intention, top.step().source,
                     [&](Value formula) { failed.formula = plain_text(formula, agent.symbols()); });
  }
  failed.has_plan =
      std::any_of(intention.stack.begin(), intention.stack.end(), [&](const IntendedMeans& means) {
        return means.is_goal_addition() && means.predicate() &&
               !agent.library()
                    .candidates(trigger_key(TriggerOperator::remove, means.kind, *means.predicate(),
                                            agent.symbols()))
                    .empty();
      });
  Deliberation added{.agent = agent.name(), .tick = tick_};
  added.failure = std::move(failed);
  // The deliberation under way stays the last.
  const auto place = deliberations_.end() - (recording_ ? 1 : 0);
  deliberations_.insert(place, std::move(added));
}

// Adds all relevant plans, also those that were not tried, in the order of the program.
void ExplainingObserver::add_candidates(Agent& agent, const Event& event) {
  if (!is_literal(event.literal)) return;
  const TriggerKey key =
      trigger_key(event.op, event.kind, predicate_of(event.literal), agent.symbols());
  std::vector<TriedPlan> ordered;
  std::vector<TriedPlan>& entries = deliberations_.back().plans;
  bool chosen = false;
  for (const Plan* const plan : agent.library().candidates(key)) {
    if (plan->is_standard) continue;
    const bool is_new = std::find(plans_.begin(), plans_.end(), plan) == plans_.end();
    TriedPlan& tried = entry(*plan);
    if (is_new && chosen) tried.state = TriedPlan::State::not_tried;
    chosen = chosen || tried.state == TriedPlan::State::chosen;
    ordered.push_back(std::move(tried));
    tried.where.clear();
  }
  // The remaining plans are sub-plans, which come before the program's.
  std::erase_if(entries, [](const TriedPlan& tried) { return tried.where.empty(); });
  entries.insert(entries.end(), std::make_move_iterator(ordered.begin()),
                 std::make_move_iterator(ordered.end()));
}

void ExplainingObserver::add_beliefs(Agent& agent) {
  Deliberation& deliberation = deliberations_.back();
  std::set<Predicate> seen;
  for (const TriedPlan& plan : deliberation.plans) {
    for (const AskedCondition& asked : plan.asked) {
      const std::optional<Predicate> predicate = probes_.conditions()[asked.number].asks;
      if (!predicate || !seen.insert(*predicate).second) continue;
      const Relation* const relation = agent.beliefs().find(*predicate);
      if (relation == nullptr) continue;
      std::size_t shown = 0;
      for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
        const Row& row = relation->row(seq);
        if (row.fact.is_unset() || ++shown > kMostBeliefs) continue;
        deliberation.beliefs.push_back(
            {rounded_text(row.fact, agent.symbols(), kMostText), origin_of(agent, row.fact)});
      }
    }
  }
}

std::string ExplainingObserver::origin_of(const Agent& agent, Value fact) const {
  const auto found = origins_.find({agent.name(), short_text(fact, agent.symbols())});
  return found == origins_.end() ? std::string() : found->second;
}

void ExplainingObserver::event_posted(Agent& agent, const Event& event) {
  if (event.kind != TriggerKind::belief || event.op != TriggerOperator::add ||
      wanted_.agent.value_or(agent.name()) != agent.name() || !is_literal(event.literal)) {
    return;
  }
  const std::string source = source_of(event.literal, agent.symbols());
  const Intention* const intention = agent.executing();
  std::string origin;
  if (agent.cycles() == 0 && tick_ == 0) {
    origin = "initial";
  } else if (source == "percept") {
    origin = fmt::format("perceived in tick {}", tick_);
  } else if (source != "self" && !source.empty()) {
    origin = fmt::format("told by {} in tick {}", source, tick_);
  } else if (intention != nullptr && !intention->is_finished()) {
    const IntendedMeans& means = intention->top();
    origin = fmt::format("its own, {}:{}, in tick {}", means.plan->file,
                         means.is_finished() ? means.plan->line : means.step().place.line, tick_);
  } else {
    origin = fmt::format("its own, in tick {}", tick_);
  }
  origins_[{agent.name(), short_text(event.literal, agent.symbols())}] = std::move(origin);
}

}  // namespace jaywalk

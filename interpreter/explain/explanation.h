// SPDX-License-Identifier: Apache-2.0
#pragma once

// Why an agent did something, or did not: each of its deliberations with the relevant and
// applicable plans, the conditions up to which the other contexts held and their bindings, the
// chosen plan, and the origins of the beliefs that were asked for. Recorded while the agents run
// (agent/surroundings/observer.h), from probes that report bindings.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/agent/surroundings/observer.h"
#include "interpreter/coverage/source_coverage.h"

namespace jaywalk {

/// A condition of a context, or of a rule that the context asked.
struct AskedCondition {
  /// The probe's number.
  std::size_t number = 0;
  /// As written, with the `not` before it.
  std::string text;
  /// The formula wants it to fail: it is one of several conditions within `not (...)`.
  bool negated = false;
  /// It held as written: `not p` holds if p does not.
  bool held = false;
  /// The values that its variables had, by their names.
  std::vector<std::pair<std::string, std::string>> bindings;
  /// A condition of a rule, not of the context; and the rule's head.
  bool in_rule = false;
  std::string rule;
  /// Why it has no answer, if that is known: "nothing is believed about near/2".
  std::string hint;

  [[nodiscard]] bool is_fine() const { return held != negated; }
};

struct TriedPlan {
  enum class State {
    not_matching,    // the trigger does not match the event
    not_applicable,  // its context does not hold
    applicable,      // but another one was chosen
    chosen,
    not_tried,  // a plan before it was chosen
  };
  std::string trigger;
  /// "file:line".
  std::string where;
  State state = State::not_matching;
  /// The conditions that were asked, in order; not all conditions of rules in a very long query.
  std::vector<AskedCondition> asked;
  /// The place in `asked` of the condition on which the context failed; its size if that cannot be
  /// told.
  std::size_t failed = 0;
};

/// A choice among options of a policy (agent/surroundings/learned_choice.h).
struct DrawnChoice {
  std::string policy;
  /// The observed features.
  std::vector<double> features;
  /// The options' labels and how probable each was.
  std::vector<std::pair<std::string, double>> options;
  std::size_t chosen = 0;
};

struct AskedBelief {
  std::string literal;
  /// "perceived in tick 3", "told by p2 in tick 1", ...
  std::string origin;
};

/// A formula that failed.
struct FailedFormula {
  std::string formula;
  /// "file:line:column"; empty if it was made at run time.
  std::string where;
  /// "action_failed", and the error.
  std::string error;
  std::string message;
  /// The goals for which it was executed, the outermost first.
  std::string goals;
  /// Some plan is for the failure of one of these goals.
  bool has_plan = false;
};

struct Deliberation {
  std::string agent;
  /// From 1; 0: before the first.
  std::uint32_t tick = 0;
  /// "+!cross[source(self)]"; empty: nothing was deliberated, a formula failed.
  std::string event;
  std::optional<FailedFormula> failure;
  std::vector<TriedPlan> plans;
  /// The draw, if a policy or chance made the choice.
  std::optional<DrawnChoice> drawn;
  std::vector<AskedBelief> beliefs;
  /// For an event without a plan: a plan that the programmer may have meant.
  std::string hint;

  /// Null: nothing was chosen.
  [[nodiscard]] const TriedPlan* chosen() const;
};

class ExplainingObserver : public ReasoningObserver {
 public:
  /// The agent and the tick to record; empty: any. REQUIRES: probes with Detail::bindings.
  struct Wanted {
    std::optional<std::string> agent;
    std::optional<std::uint32_t> tick;
  };
  ExplainingObserver(const Probes& probes, const ProbeTexts& texts, Wanted wanted);

  /// Call this before each tick.
  void set_tick(std::uint32_t tick) { tick_ = tick; }
  [[nodiscard]] const std::vector<Deliberation>& deliberations() const { return deliberations_; }

  [[nodiscard]] const Goal* context_of(const Plan& plan) override;
  [[nodiscard]] const RuleCode& rule_for(const RuleCode& rule) override;
  std::size_t condition_asked(Agent& agent, std::size_t number,
                              std::span<const Value> variables) override;
  void condition_answered(Agent& agent, std::size_t number, std::size_t asking) override;
  void event_selected(Agent& agent, const Event& event) override;
  void plan_relevant(Agent& agent, const Plan& plan, const Event& event,
                     std::span<const Value> slots) override;
  void plan_tried(Agent& agent, const Plan& plan, bool applicable) override;
  void option_drawn(Agent& agent, const LearnedChoice& choice, const DrawnOption& drawn) override;
  void plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                   const Intention& intention) override;
  void no_plan(Agent& agent, const Event& event, bool had_candidates) override;
  void formula_failed(Agent& agent, const Intention& intention, const ActionError& error) override;
  void event_posted(Agent& agent, const Event& event) override;

 private:
  [[nodiscard]] bool is_wanted(const Agent& agent) const;
  void add_candidates(Agent& agent, const Event& event);
  void add_beliefs(Agent& agent);
  void find_failure(TriedPlan& plan) const;
  [[nodiscard]] std::size_t rule_of(std::size_t condition) const;
  [[nodiscard]] std::string origin_of(const Agent& agent, Value fact) const;
  TriedPlan& entry(const Plan& plan);

  const Probes& probes_;
  const ProbeTexts& texts_;
  Wanted wanted_;
  std::uint32_t tick_ = 0;
  std::vector<Deliberation> deliberations_;
  // The deliberation under way.
  bool recording_ = false;
  std::vector<const Plan*> plans_;  // those of the deliberation's entries
  std::size_t current_ = 0;         // the entry being tried
  std::size_t in_rules_ = 0;        // conditions of rules that it has asked
  bool trying_ = false;
  // The time and origin of beliefs, by agent and literal.
  std::map<std::pair<std::string, std::string>, std::string> origins_;
};

/// For people: a paragraph for each deliberation.
[[nodiscard]] std::string explanation_text(std::span<const Deliberation> deliberations);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Looks at agents as they reason: coverage and explanations are made from what observers receive
// (interpreter/coverage). A run without one pays a comparison with null for each plan that is tried
// and each formula that is executed.
//
// Observers are called between the steps of the reasoning cycle, on the thread that runs the
// system. They may read the agent; they must not change it. Values are good until they return.

#include <cstddef>
#include <span>
#include <vector>

#include "interpreter/agent/circumstance/circumstance.h"
#include "interpreter/agent/surroundings/learned_choice.h"
#include "interpreter/logic/code/code.h"

namespace jaywalk {

class Agent;
struct ActionError;

class ReasoningObserver {
 public:
  virtual ~ReasoningObserver() = default;

  /// Whether the query that is under way is to end as if it had hit a limit. Asked now and then.
  [[nodiscard]] virtual bool interrupted() { return false; }

  /// Whether it looks at the literals of events, which then are made for it. False: those of the
  /// events that it is given may be unset, and event_selected and event_posted say nothing to it.
  [[nodiscard]] virtual bool wants_events() const { return true; }

  /// The formula to solve instead of a plan's context, or the rule to use instead of a rule: the
  /// same formula, perhaps with goals between its parts that report how far the query comes. It
  /// must outlive the run.
  [[nodiscard]] virtual const Goal* context_of(const Plan& plan) { return plan.context; }
  [[nodiscard]] virtual const RuleCode& rule_for(const RuleCode& rule) { return rule; }
  /// Told by such goals (coverage/probes.h): a condition, by its number, is asked, with the values
  /// of its variables. What is returned names this asking; of a context it is of no meaning.
  virtual std::size_t condition_asked(Agent& /*agent*/, std::size_t /*number*/,
                                      std::span<const Value> /*variables*/) {
    return 0;
  }
  /// The condition has an answer, perhaps not its first; 0: to its latest asking.
  virtual void condition_answered(Agent& /*agent*/, std::size_t /*number*/,
                                  std::size_t /*asking*/) {}

  /// An event was selected (rule SelEv), and a plan is looked for.
  virtual void event_selected(Agent& /*agent*/, const Event& /*event*/) {}
  /// A plan's trigger has matched: it is relevant (rule RelPl), and its context is asked next.
  virtual void plan_relevant(Agent& /*agent*/, const Plan& /*plan*/, const Event& /*event*/,
                             std::span<const Value> /*slots*/) {}
  /// Whether the context held (rule ApplPl).
  virtual void plan_tried(Agent& /*agent*/, const Plan& /*plan*/, bool /*applicable*/) {}
  /// Several plans were options of a policy, and one of them was drawn
  /// (agent/surroundings/learned_choice.h).
  virtual void option_drawn(Agent& /*agent*/, const LearnedChoice& /*choice*/,
                            const DrawnOption& /*drawn*/) {}
  /// The plan was chosen and becomes intended means (rules SelAppl and AddIM).
  virtual void plan_chosen(Agent& /*agent*/, const Plan& /*plan*/, const Event& /*event*/,
                           const Intention& /*intention*/) {}
  /// No plan was chosen for the event.
  virtual void no_plan(Agent& /*agent*/, const Event& /*event*/, bool /*had_candidates*/) {}
  /// A formula is executed (rule ExecInt).
  virtual void formula_executes(Agent& /*agent*/, const Intention& /*intention*/,
                                const Step& /*step*/) {}
  /// The intention's current formula has failed.
  virtual void formula_failed(Agent& /*agent*/, const Intention& /*intention*/,
                              const ActionError& /*error*/) {}
  /// Something happened: a belief came or went, a goal was posted. Told before it is known whether
  /// any plan is for it.
  virtual void event_posted(Agent& /*agent*/, const Event& /*event*/) {}
};

/// Several observers that stand where one is expected: each receives every call, in the order in
/// which they were added. REQUIRES: one at most gives contexts and rules of its own.
class Observers final : public ReasoningObserver {
 public:
  void add(ReasoningObserver& observer) { all_.push_back(&observer); }
  /// The observer for agents: null if there is none, the only one if there is one.
  [[nodiscard]] ReasoningObserver* get() {
    if (all_.size() > 1) return this;
    return all_.empty() ? nullptr : all_.front();
  }

  [[nodiscard]] bool interrupted() override;
  [[nodiscard]] bool wants_events() const override;
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
  void formula_executes(Agent& agent, const Intention& intention, const Step& step) override;
  void formula_failed(Agent& agent, const Intention& intention, const ActionError& error) override;
  void event_posted(Agent& agent, const Event& event) override;

 private:
  std::vector<ReasoningObserver*> all_;
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Compiled plans: triggers, contexts and bodies over one frame of slots, and the library in which
// an agent looks for the plans that are relevant for an event. A plan of a Program never changes;
// plans made at run time are owned by the agent's own copy of the library.

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "interpreter/logic/code/code.h"
#include "interpreter/program/event_code.h"
#include "interpreter/program/step_place.h"
#include "interpreter/program/trigger.h"
#include "interpreter/support/containers/flat_index.h"
#include "interpreter/term/heap.h"

namespace jaywalk {

struct Plan;
class PlanLibrary;

struct Body;

/// One formula of a plan body.
struct Step {
  enum class Kind : std::uint8_t {
#define JAYWALK_BODY_STEP(id, name, meaning) id,
#include "interpreter/logic/code/instructions.def"
  };

  Kind kind = Kind::wrong;
  /// The formula that comes after it: behind the last one of a loop's body the loop itself, behind
  /// that of a branch what follows the statement; null: the plan is done.
  const Step* next = nullptr;
  /// The formula without its operator; a template.
  Value term;
  const Goal* goal = nullptr;
  const Body* first = nullptr;
  const Body* second = nullptr;
  std::vector<const Body*> branches;
  std::vector<const Goal*> conjuncts;
  StepPlace place;
  /// The formula as a term of form step, for programs as data.
  Value source;
  /// The decoded literal of a goal or a change of belief; else null.
  const EventCode* event = nullptr;
  /// For a variable: its operator.
  Kind variable_kind = Kind::action;
};

struct Body {
  std::vector<Step> steps;

  /// Its first step; the step after it if it is empty.
  [[nodiscard]] const Step* begin(const Step* next) const {
    return steps.empty() ? next : steps.data();
  }
};

/// Owns compiled bodies and formulas, of a plan or of a body that was data at run time.
struct BodyCode {
  std::deque<Body> bodies;
  FormulaCode formulas;
  std::vector<std::unique_ptr<EventCode>> events;
  const Body* entry = nullptr;

  /// Shows each formula the one that comes after it; `after` comes after all.
  void link(const Step* after);
  [[nodiscard]] bool has(const Step& step) const;

  template <class Visit>
  void visit_terms(Visit&& visit) {
    formulas.visit_terms(visit);
    for (Body& body : bodies) {
      for (Step& step : body.steps) {
        visit(step.term);
        visit(step.source);
      }
    }
  }
};

/// The rough size of a plan or rule made at run time, with its code, in bytes.
inline constexpr std::size_t kPlanBytes = 2048;

struct Plan {
  /// A literal with the label's annotations; unset if the plan has no label.
  Value label;
  TriggerKey key;
  /// The trigger is a variable: it is relevant for all events of its kind.
  bool any_predicate = false;
  Value trigger;  // the literal or variable; a template
  /// argument_key of the trigger's first argument; 0: it may match any, or there is none.
  std::uint64_t first_key = 0;
  Value first_argument;  // the same if it is a number or atom; else unset
  const Goal* context = nullptr;
  const Goal* goal_condition = nullptr;
  bool has_goal_condition = false;
  PlanHead head;
  /// Its means need no more than a frame: it is not atomic, and has neither a goal condition nor
  /// sub-plans.
  bool is_simple = false;
  BodyCode code;
  std::uint32_t slot_count = 0;
  /// So many first ones are of variables that the plan has in its text, the others of rules that
  /// are unfolded in its context.
  std::uint32_t own_slots = 0;
  std::vector<Symbol> slot_names;
  bool atomic = false;
  bool all_unifs = false;
  /// The policy that it is an option of: the atom P of its label's annotation learned(P); unset:
  /// none.
  Value policy;
  /// It belongs to every agent (the plans for messages), not to the program.
  bool is_standard = false;
  /// In a sub-plan: which slots have the value of which slot of the enclosing plan.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> inherited;
  /// Sub-plans of AgentSpeak(ER); null if there are none.
  std::unique_ptr<PlanLibrary> subplans;
  /// The plan as a term of form plan, for programs as data; its variables are slots.
  Value source;
  std::string file;
  std::uint32_t line = 0;

  template <class Visit>
  void visit_terms(Visit&& visit);
};

/// The plans for one key, in order. Where they are many, those whose trigger has a given first
/// argument are found without a look at the others.
class PlanList {
 public:
  void add(const Plan& plan);
  [[nodiscard]] const std::vector<const Plan*>& plans() const { return plans_; }
  /// There is no index: it is as well to look at all of them.
  [[nodiscard]] bool is_short() const { return is_short_; }
  /// Some of the plans are options of a policy.
  [[nodiscard]] bool has_learned() const { return has_learned_; }

  /// Calls `is_it(plan)` for the plans that may match a first argument with this argument_key (0:
  /// any plan), in order, until it returns true for one; null if it never does.
  template <class IsIt>
  const Plan* find(std::uint64_t first_key, IsIt is_it) const;

 private:
  static constexpr std::size_t kUnindexedPlans = 8;
  using Places = std::vector<std::uint32_t>;  // in plans_, ascending

  std::vector<const Plan*> plans_;
  // Only of long lists.
  std::unordered_map<std::uint64_t, Places> by_first_key_;
  Places wild_;  // those that may match any first argument
  bool has_learned_ = false;
  bool is_short_ = true;
};

/// Plans in order, and by the events that they are relevant for.
class PlanLibrary {
 public:
  PlanLibrary() = default;

  void add(std::shared_ptr<const Plan> plan);
  void add_first(std::shared_ptr<const Plan> plan);
  void remove(const Plan& plan);

  [[nodiscard]] const std::vector<std::shared_ptr<const Plan>>& plans() const { return plans_; }
  /// The plans whose trigger might match, in order; empty if there are none.
  [[nodiscard]] const std::vector<const Plan*>& candidates(const TriggerKey& key) const {
    return list(key).plans();
  }
  [[nodiscard]] const PlanList& list(const TriggerKey& key) const {
    const std::uint32_t found = index_.find(packed(key));
    return found == FlatIndex<std::uint64_t>::kNone ? any_[kind_index(key)] : lists_[found];
  }
  /// Plans for goal states, `^!g`, exist.
  [[nodiscard]] bool has_goal_state_plans() const { return goal_state_plans_ > 0; }
  /// There are plans that are options of a policy.
  [[nodiscard]] bool has_learned_plans() const { return learned_plans_ > 0; }
  /// There are plans for changes of belief.
  [[nodiscard]] bool has_belief_plans() const { return belief_plans_ > 0; }
  /// There are plans for messages, `+!kqml_received(...)`, beside the standard ones.
  [[nodiscard]] bool has_own_message_plans() const { return message_plans_ > 0; }

 private:
  static std::uint64_t packed(const TriggerKey& key) {
    return static_cast<std::uint64_t>(key.predicate) * 16 + static_cast<std::uint64_t>(key.op) * 4 +
           static_cast<std::uint64_t>(key.kind);
  }
  static std::size_t kind_index(const TriggerKey& key) {
    return static_cast<std::size_t>(key.op) * 3 + static_cast<std::size_t>(key.kind);
  }
  void rebuild();
  void insert(const Plan& plan);

  std::vector<std::shared_ptr<const Plan>> plans_;
  FlatIndex<std::uint64_t> index_;  // into lists_, by packed key
  std::deque<PlanList> lists_;
  std::vector<TriggerKey> keys_;  // of the lists
  // Plans with variable triggers, by kind of event; they are in the lists of all keys too.
  std::array<PlanList, 9> any_;
  std::size_t goal_state_plans_ = 0;
  std::size_t message_plans_ = 0;
  std::size_t belief_plans_ = 0;
  std::size_t learned_plans_ = 0;
};

/// Shows the formulas of a plan the lists of plans for their events. REQUIRES: the library changes
/// no more, and outlives the plan.
void link(Plan& plan, const PlanLibrary& library);

template <class IsIt>
const Plan* PlanList::find(std::uint64_t first_key, IsIt is_it) const {
  if (first_key == 0 || plans_.size() <= kUnindexedPlans) {
    for (const Plan* const plan : plans_) {
      const bool may_match = first_key == 0 || plan->first_key == 0 || plan->first_key == first_key;
      if (may_match && is_it(*plan)) return plan;
    }
    return nullptr;
  }
  static const Places kNone;
  const auto found = by_first_key_.find(first_key);
  const Places& same = found == by_first_key_.end() ? kNone : found->second;
  auto next_same = same.begin();
  auto next_wild = wild_.begin();
  while (next_same != same.end() || next_wild != wild_.end()) {
    const bool take_same =
        next_wild == wild_.end() || (next_same != same.end() && *next_same < *next_wild);
    const Plan* const plan = plans_[take_same ? *next_same++ : *next_wild++];
    if (is_it(*plan)) return plan;
  }
  return nullptr;
}

template <class Visit>
void Plan::visit_terms(Visit&& visit) {
  visit(label);
  visit(trigger);
  visit(source);
  head.code.visit_terms(visit);
  code.visit_terms(visit);
}

}  // namespace jaywalk

#pragma once

// Compiled plans: triggers, contexts and bodies over one frame of slots, and the library in which
// an agent looks for the plans that are relevant for an event. A plan of a Program never changes;
// plans made at run time are owned by the agent's own copy of the library.

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "interpreter/logic/code.h"
#include "interpreter/term/heap.h"

namespace jaywalk {

struct Plan;
class PlanLibrary;

enum class TriggerOperator : std::uint8_t { add, remove, goal_state };  // + - ^
enum class TriggerKind : std::uint8_t { belief, achieve, test };        // (none) ! ?

/// What an event is about, as far as plans can be looked up by it: Jason's trigger indicator, in
/// which strong negation does not count.
struct TriggerKey {
  TriggerOperator op = TriggerOperator::add;
  TriggerKind kind = TriggerKind::belief;
  Predicate predicate{};

  friend bool operator==(const TriggerKey&, const TriggerKey&) = default;
};

struct Body;

/// One formula of a plan body.
struct Step {
  enum class Kind : std::uint8_t {
    action,             // a(1): for the environment
    internal_action,    // .print(1): goal
    constraint,         // X > 1: goal
    achieve,            // !g
    achieve_new_focus,  // !!g
    test,               // ?q: goal
    add,
    add_new_focus,
    add_begin,
    add_end,  // +b ++b +<b +>b
    remove,
    remove_new_focus,
    replace,       // -b --b -+b
    variable,      // X, with any operator: what it is bound to decides
    if_statement,  // goal is the condition; first, second the branches (second may be null)
    while_loop,    // goal, first
    for_loop,      // goal, first
    fork_and,
    fork_or,  // branches
    join,     // the end of a branch, never written
    wrong,    // a formula that cannot be executed: fails
  };

  Kind kind = Kind::wrong;
  /// The formula without its operator; a template.
  Value term;
  const Goal* goal = nullptr;
  const Body* first = nullptr;
  const Body* second = nullptr;
  std::vector<const Body*> branches;
  std::uint32_t line = 0;
  /// The formula as a term of form step, for programs as data.
  Value source;
  /// Of variable: its operator.
  Kind variable_kind = Kind::action;
};

struct Body {
  std::vector<Step> steps;
};

/// Owns compiled bodies and formulas, of a plan or of a body that was data at run time.
struct BodyCode {
  std::deque<Body> bodies;
  FormulaCode formulas;
  const Body* entry = nullptr;

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

struct Plan {
  /// A literal with the label's annotations; unset if the plan has no label.
  Value label;
  TriggerKey key;
  /// The trigger is a variable: it is relevant for all events of its kind.
  bool any_predicate = false;
  Value trigger;  // the literal or variable; a template
  const Goal* context = nullptr;
  const Goal* goal_condition = nullptr;
  bool has_goal_condition = false;
  BodyCode code;
  std::uint32_t slot_count = 0;
  std::vector<Symbol> slot_names;
  bool atomic = false;
  bool all_unifs = false;
  /// It belongs to every agent (the plans for messages), not to the program.
  bool is_standard = false;
  /// Of a sub-plan: which slots have the value of which slot of the enclosing plan.
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

/// Plans in order, and by what they are relevant for.
class PlanLibrary {
 public:
  PlanLibrary() = default;

  void add(std::shared_ptr<const Plan> plan);
  void add_first(std::shared_ptr<const Plan> plan);
  void remove(const Plan& plan);

  [[nodiscard]] const std::vector<std::shared_ptr<const Plan>>& plans() const { return plans_; }
  /// The plans whose trigger might match, in order; empty if there are none.
  [[nodiscard]] const std::vector<const Plan*>& candidates(const TriggerKey& key) const;
  /// Plans for goal states, `^!g`, exist.
  [[nodiscard]] bool has_goal_state_plans() const { return goal_state_plans_ > 0; }

 private:
  struct KeyHash {
    std::size_t operator()(const TriggerKey& key) const {
      return (static_cast<std::size_t>(key.predicate) * 16 + static_cast<std::size_t>(key.op) * 4 +
              static_cast<std::size_t>(key.kind)) *
                 0x9E3779B97F4A7C15U >>
             7U;
    }
  };
  static std::size_t kind_index(const TriggerKey& key) {
    return static_cast<std::size_t>(key.op) * 3 + static_cast<std::size_t>(key.kind);
  }
  void rebuild();
  void insert(const Plan& plan);

  std::vector<std::shared_ptr<const Plan>> plans_;
  std::unordered_map<TriggerKey, std::vector<const Plan*>, KeyHash> by_key_;
  // Plans with variable triggers, by kind of event; they are in the lists of all keys too.
  std::vector<const Plan*> any_[9];
  std::size_t goal_state_plans_ = 0;
};

template <class Visit>
void Plan::visit_terms(Visit&& visit) {
  visit(label);
  visit(trigger);
  visit(source);
  code.visit_terms(visit);
}

}  // namespace jaywalk

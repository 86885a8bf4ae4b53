// SPDX-License-Identifier: Apache-2.0
#pragma once

// Customises an agent by the functions that Jason lets an agent class override. Each is optional;
// one that is not set costs nothing, and the agent behaves by default. They are called between the
// steps of the reasoning cycle, on the thread that runs the system. Values that they see are valid
// until they return; they must not run the agent.
//
// The choice of an agent should depend on its arguments alone (and its own random stream,
// `Agent::random`), so that a run can be repeated.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interpreter/agent/circumstance/circumstance.h"
#include "interpreter/logic/beliefs/belief_base.h"

namespace jaywalk {

class Agent;

/// A plan that is applicable to an event, with one solution of its context. A plan with the
/// annotation `all_unifs` is an option for each solution.
struct Option {
  const Plan* plan = nullptr;
  /// The value of each of the plan's variables, `plan->slot_names`; unset: it has none yet.
  std::vector<Value> values;
  /// Further bindings if it is chosen: variables of the event and their values.
  std::vector<std::pair<Value, Value>> bindings;
  ScopePtr scope;
};

/// A change of belief that an agent is about to make, for its belief revision function.
class BeliefRevision {
 public:
  enum class Kind { add, remove };

  [[nodiscard]] Agent& agent() const { return agent_; }
  [[nodiscard]] Kind kind() const { return kind_; }
  /// The belief with its source; of a removal perhaps a pattern with variables.
  [[nodiscard]] Value literal() const { return literal_; }
  /// The intention that asks for the change; null: a message, an initial belief, an internal
  /// action.
  [[nodiscard]] const Intention* intention() const { return intention_; }

  /// Makes the change as it was asked for, as an agent without a function of its own would. False:
  /// it changed nothing.
  bool accept();
  /// Adds a change besides the requested one, or instead. Each change is an event of its own; the
  /// intention that requested the change waits for the first one. REQUIRES: is_literal(literal).
  bool add(Value literal);
  bool remove(Value literal);

 private:
  friend class Agent;
  BeliefRevision(Agent& agent, Kind kind, Value literal, Place place, Intention* focus)
      : agent_(agent),
        kind_(kind),
        literal_(literal),
        place_(place),
        intention_(focus),
        focus_(focus) {}
  [[nodiscard]] bool changed(bool something);

  Agent& agent_;
  Kind kind_;
  Value literal_;
  Place place_;
  Intention* intention_;
  Intention* focus_;  // until the first change
  bool changed_ = false;
};

/// Functions for any number of agents; they live as long as the system.
struct Customisation {
  /// SelEv: the place in the queue of the event to be handled in this cycle, the oldest first;
  /// nothing: none in this cycle. Not asked while an atomic intention exists.
  /// REQUIRES: less than `events.size()`; so do the other selection functions.
  std::function<std::optional<std::size_t>(Agent& agent, const Ring<Event>& events)> select_event;
  /// SelAppl: selects the option to intend, of at least one, in the order of the plans; nothing:
  /// the event is handled as if no plan were applicable. With it, the contexts of all relevant
  /// plans are solved, not only up to the first that holds.
  std::function<std::optional<std::size_t>(Agent& agent, const Event& event,
                                           std::span<const Option> options)>
      select_option;
  /// SelInt: which intention executes its next formula, of at least one; nothing: none in this
  /// cycle. Not asked while an atomic intention exists.
  std::function<std::optional<std::size_t>(Agent& agent, const Ring<Intention*>& ready)>
      select_intention;
  /// Belief revision, Jason's brf: accepts or changes each addition or removal of a belief, but for
  /// percepts. A change that it does not accept is not made.
  std::function<void(BeliefRevision& revision)> revise_beliefs;
  /// Social acceptance, Jason's socAcc: whether to process a message. Answers to questions
  /// of the agent's own are always accepted.
  std::function<bool(Agent& agent, const Message& message)> accepts_message;
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Goals as wholes: looked for, suspended and ended from outside, with all the means that serve
// them; goals with deadlines, and goal conditions of AgentSpeak(ER).

#include <cstddef>
#include <optional>
#include <vector>

#include "interpreter/agent/circumstance/circumstance.h"

namespace jaywalk {

class Agent;
struct ActionError;

/// An agent's goals. A view, for internal actions and the reasoning cycle: it holds no data.
class Goals {
 public:
  enum class End { succeed, fail };
  explicit Goals(Agent& agent) : agent_(agent) {}

  /// Whether a goal, `+!goal`, is in the intention's stack; its bindings stay on the trail.
  [[nodiscard]] bool has(const Intention& intention, Value goal);
  /// Which intentions have the goal on their stack, in the order in which Jason looks at them.
  [[nodiscard]] std::vector<Intention*> intentions_with(Value goal);
  [[nodiscard]] std::vector<Intention*> all_intentions();
  /// Ends the goal in every intention and event that has it, as achieved or as failed; `except` (or
  /// null) is left alone.
  void end(Value goal, End end, const Intention* except);
  /// The lowest means of an intention that has the goal, `+!goal`, as the topmost has it; its
  /// bindings stay on the trail.
  [[nodiscard]] std::optional<std::size_t> find(const Intention& intention, Value goal);
  /// Ends the means number `depth` of an intention and everything above it. A failure's event is
  /// for `failed`, or if that is unset for the goal as it was called; it has the annotations of
  /// `error`, if there is one.
  void end_means(Intention& intention, std::size_t depth, End end, Value failed = Value(),
                 const ActionError* error = nullptr);
  /// Removes events for the goal from the queues, with the intentions that wait for them.
  void drop_events(Value goal);
  void suspend(Value goal);
  void resume(Value goal);
  /// `hard_deadline(Ms)`: the goal, a literal of its own from now on, is looked at again after a
  /// time; end_late() then ends it.
  [[nodiscard]] Value watch_deadline(Value goal);
  void end_late(Value goal);
  [[nodiscard]] bool is_pursued(Value goal) const;
  /// Rule ClrSatInt: goals whose condition has come true are achieved. Those whose condition meets
  /// a limit fail.
  void check_conditions();

 private:
  [[nodiscard]] bool is_it(const Intention& intention, const IntendedMeans& means, Value goal);
  void stop_waiting(Intention& intention);
  void fail_top(Intention& intention, Value failed, const ActionError* reason);
  void fail_at_limit(Intention& intention, std::size_t depth, const ActionError& error);
  [[nodiscard]] std::vector<Intention*> intentions_to_suspend();
  template <class Queue>
  [[nodiscard]] std::vector<Event> take_events_of(Queue& queue, Value goal);

  Agent& agent_;
};

}  // namespace jaywalk

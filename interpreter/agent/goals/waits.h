// SPDX-License-Identifier: Apache-2.0
#pragma once

// Intentions that wait: for time, for an event, for a formula to hold; and work that is deferred to
// the beginning of the next deliberation.

#include "interpreter/agent/circumstance/circumstance.h"

namespace jaywalk {

class Agent;

/// The waits of an agent's intentions. A view, for internal actions and the reasoning cycle: it
/// holds no data.
class Waits {
 public:
  explicit Waits(Agent& agent) : agent_(agent) {}

  /// `.wait`: the intention goes on when a trigger or formula comes true, or time is over (`ms` <
  /// 0: never). `wait.elapsed` set: running out of time is no failure.
  void start(Intention& intention, Wait wait, double ms);
  /// Posts an event after `ms` milliseconds (`.at`).
  void schedule(Event event, double ms);
  void cancel_schedule();
  /// Why an intention waits, as `.suspended` reports it: suspend_ia, act, wait(Id)[time(Ms)], ...
  [[nodiscard]] Value reason(const Intention& intention);
  /// The action for the environment that an intention waits for; unset if it does not.
  [[nodiscard]] Value pending_action(const Intention& intention) const;
  /// An event has been added: does an intention wait for one like it? Plans for it need not exist.
  void check_event(const Event& event);
  void check_formulas();
  /// Runs the tasks deferred to the beginning of this deliberation.
  void run_tasks();

 private:
  void end(const Wait& wait, bool timed_out);

  Agent& agent_;
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// An agent's circumstance, in the words of Jason's operational semantics: events (E), intentions
// (I), pending actions and their feedback (PA, FA), the mailbox (MB).

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "interpreter/agent/circumstance/intention.h"
#include "interpreter/agent/circumstance/message.h"
#include "interpreter/support/containers/lazy.h"
#include "interpreter/support/containers/ring.h"

namespace jaywalk {

struct Event {
  TriggerOperator op = TriggerOperator::add;
  TriggerKind kind = TriggerKind::belief;
  Value literal;
  /// The intention that waits for it; null: an external event, which starts an intention.
  Intention* intention = nullptr;
  /// For a failure, `-!g`: see IntendedMeans::keeps.
  std::size_t keeps = 0;
  /// The intention's top means has been chosen for it already.
  bool has_means = false;
};

/// A `.wait` for an event or a formula, or for time alone.
struct Wait {
  std::uint64_t id = 0;  // also the token of its timer
  std::uint32_t intention = 0;
  bool has_trigger = false;
  TriggerOperator op = TriggerOperator::add;
  TriggerKind kind = TriggerKind::belief;
  Value trigger;  // a literal or a variable
  bool has_formula = false;
  Value formula;
  /// The term to unify with the time waited; unset: a timeout fails.
  Value elapsed;
  double start_ms = 0;
  double ms = -1;  // how long at most; negative: for ever
};

/// Something to be done at the beginning of the next deliberation.
struct Task {
  enum class Kind : std::uint8_t { end_wait, time_out, goal_state, deadline };
  Kind kind = Kind::end_wait;
  Wait wait;
  Event event;  // goal_state, deadline
};

/// A goal that fails if it is still there when a time is over (`!g[hard_deadline(Ms)]`).
struct GoalDeadline {
  std::uint64_t token = 0;  // of its timer
  Value goal;               // the very literal of the event: no other goal is meant
};

/// A question whose answer an intention waits for: `.send(ag, askOne, q, Answer)`.
struct PendingAsk {
  MessageId id;  // of the message; the answers reply to it
  Intention* intention = nullptr;
  Value answer;          // the call's argument, which is unified with the answer
  bool is_one = false;   // askOne: `untell` means false
  bool to_many = false;  // a list of agents was asked: a list of answers is wanted
  std::size_t awaited = 0;
  std::vector<Value> answers;
  std::uint64_t timer = 0;  // its token; 0: it waits for ever
};

/// An action that the environment is to execute.
struct PendingAction {
  Intention* intention = nullptr;
  Value literal;
  std::uint64_t number = 0;  // given when it is taken
};

struct Feedback {
  Intention* intention = nullptr;
  bool succeeded = true;
  std::string reason;
  Value literal;
};

struct Circumstance {
  Ring<Event> events;                                  // E
  Ring<Intention*> running;                            // I, those ready to run
  std::vector<std::unique_ptr<Intention>> intentions;  // owns all of them
  Intention* atomic = nullptr;          // the atomic intention, if it is ready to run
  std::unique_ptr<Event> atomic_event;  // of the atomic intention, or null
  bool atomic_suspended = false;        // there is one, and it waits
  // Parts that many agents never use.
  LazyContainer<Ring<Message>> mailbox;          // MB
  LazyContainer<std::vector<Message>> arriving;  // sent in this round, to the mailbox at its end
  LazyContainer<Ring<PendingAction>> actions;    // PA, for the environment to take, one a tick
  LazyContainer<std::vector<PendingAction>> acting;  // PA, taken, awaiting feedback
  LazyContainer<Ring<Feedback>> feedback;            // FA
  LazyContainer<std::vector<Event>> pending_events;  // PE, of suspended goals
  LazyContainer<std::vector<Wait>> waits;
  LazyContainer<std::vector<PendingAsk>> asks;
  LazyContainer<std::vector<Task>> tasks;
  LazyContainer<std::vector<std::pair<std::uint64_t, Event>>> scheduled;  // by timer (.at)
  LazyContainer<std::vector<GoalDeadline>> deadlines;
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The parts that an agent needs only while it reasons: the machine that answers its queries, and
// temporary memory. Agents of one system share a few of them, since few of a million agents reason
// at the same time: an agent borrows one when it first needs it and returns it at the end of its
// cycle.

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/agent/circumstance/circumstance.h"
#include "interpreter/logic/machine.h"

namespace jaywalk {

class Program;

/// The arguments of an event's literal, if it is one.
struct EventArguments {
  bool is_literal = false;
  bool is_open = false;  // it has variables
  Predicate predicate{};
  std::span<const Value> args;
};

/// The event of the formula that is being executed, where the next cycle can be about nothing else:
/// it does not pass through E. The literal of a goal is made on demand (Agent::literal_of).
struct NextEvent {
  Event event;
  const EventCode* code = nullptr;  // of the formula, if it makes just this event
  bool is_pending = false;
  // The goal's literal, without annotations.
  bool is_open = false;  // it has open variables
  Predicate predicate{};
  std::size_t arity = 0;
  std::array<Value, EventCode::kMostArguments> args;
};

struct Workspace {
  explicit Workspace(SymbolTable& symbols) : machine(symbols) {}

  Machine machine;
  std::vector<Value> frame;     // of the plan being tried
  bool had_candidates = false;  // there are plans for the event's trigger
  bool binds_event = false;     // its head or context has set event variables
  NextEvent next;
  std::vector<std::pair<Value, Value>> renamed;  // variables of a call, with their copies
  struct PerceptChanges {
    std::vector<BeliefBase::PerceptChange> gone;
    std::vector<BeliefBase::PerceptChange> news;
  } percept_changes;
  std::vector<std::unique_ptr<Intention>> spare_intentions;
  // Memory for an agent's terms in the first cycles of its life (term/heap.h).
  Heap::Remains nursery;
  Heap::Remains aside;

  /// Memory of queues, which an agent at rest does not need if there is nothing in them.
  void lend_queues(Circumstance& to) {
    lend(events_, to.events);
    lend(running_, to.running);
    lend(intentions_, to.intentions);
  }
  void take_back_queues(Circumstance& from) {
    lend(from.events, events_);
    lend(from.running, running_);
    lend(from.intentions, intentions_);
  }

 private:
  template <class Queue>
  static void lend(Queue& from, Queue& to) {
    if (from.empty() && to.capacity() == 0) std::swap(from, to);
  }

  Ring<Event> events_;
  Ring<Intention*> running_;
  std::vector<std::unique_ptr<Intention>> intentions_;
};

/// Memory of the queues that an agent mostly has of its own. Nothing is in them.
struct QueueRemains {
  Ring<Event> events;
  std::vector<std::unique_ptr<Intention>> intentions;
  LazyContainer<Ring<Message>> mailbox;
  LazyContainer<std::vector<Message>> arriving;
  LazyContainer<Ring<PendingAction>> actions;
  LazyContainer<std::vector<PendingAction>> acting;
  LazyContainer<Ring<Feedback>> feedback;

  void use(Circumstance& from) {
    use(from.events, events);
    use(from.intentions, intentions);
    use(from.mailbox, mailbox);
    use(from.arriving, arriving);
    use(from.actions, actions);
    use(from.acting, acting);
    use(from.feedback, feedback);
  }
  void give(Circumstance& to) {
    to.events = std::move(events);
    to.intentions = std::move(intentions);
    to.mailbox = std::move(mailbox);
    to.arriving = std::move(arriving);
    to.actions = std::move(actions);
    to.acting = std::move(acting);
    to.feedback = std::move(feedback);
  }

 private:
  template <class Queue>
  static void use(Queue& from, Queue& to) {
    constexpr std::size_t kLong = 64;
    from.clear();
    if (from.capacity() <= kLong) to = std::move(from);
  }
};

/// The memory of a finished agent, for another one with the same program. It holds none of the
/// agent's beliefs or goals.
struct AgentRemains {
  std::weak_ptr<const Program> program;
  Heap::Remains heap;
  BeliefBase::Remains beliefs;
  QueueRemains queues;
};

class WorkspacePool {
 public:
  explicit WorkspacePool(SymbolTable& symbols) : symbols_(symbols) {}

  [[nodiscard]] std::unique_ptr<Workspace> lend() {
    if (idle_.empty()) return std::make_unique<Workspace>(symbols_);
    std::unique_ptr<Workspace> lent = std::move(idle_.back());
    idle_.pop_back();
    return lent;
  }
  /// A workspace that has grown large is not kept.
  void take_back(std::unique_ptr<Workspace> workspace) {
    if (workspace->machine.has_grown()) {
      inferences_ += workspace->machine.inferences();
    } else {
      idle_.push_back(std::move(workspace));
    }
  }

  /// Inferences of all queries since the pool was made. REQUIRES: no workspace is lent.
  [[nodiscard]] std::uint64_t inferences() const {
    std::uint64_t all = inferences_;
    for (const auto& workspace : idle_) all += workspace->machine.inferences();
    return all;
  }
  /// The inferences that a query may take: the run's remainder.
  [[nodiscard]] std::uint64_t inferences_left() const { return inferences_left_; }
  void set_inferences_left(std::uint64_t left) { inferences_left_ = left; }

  /// The kept parts of an earlier agent with this program, if there are any.
  [[nodiscard]] std::optional<AgentRemains> take_remains(const Program* program);
  [[nodiscard]] bool wants_remains() const { return remains_.size() < most_remains_; }
  void keep(AgentRemains remains) { remains_.push_back(std::move(remains)); }
  /// Intentions of an agent that ends are for those that come.
  void keep(std::span<std::unique_ptr<Intention>> intentions);
  /// The agents that end from now on leave theirs, up to this number.
  void want_remains(std::size_t most) { most_remains_ = most; }

 private:
  SymbolTable& symbols_;
  std::vector<std::unique_ptr<Workspace>> idle_;
  std::uint64_t inferences_ = 0;  // of workspaces that are gone
  std::vector<AgentRemains> remains_;
  std::size_t most_remains_ = 0;
  std::uint64_t inferences_left_ = UINT64_MAX;
};

inline void WorkspacePool::keep(std::span<std::unique_ptr<Intention>> intentions) {
  if (idle_.empty()) return;
  auto& spares = idle_.back()->spare_intentions;
  for (auto& intention : intentions) {
    if (spares.size() >= most_remains_) return;
    intention->finish();
    spares.push_back(std::move(intention));
  }
}

inline std::optional<AgentRemains> WorkspacePool::take_remains(const Program* program) {
  for (auto each = remains_.rbegin(); each != remains_.rend(); ++each) {
    if (each->program.lock().get() != program) continue;
    std::optional<AgentRemains> taken = std::move(*each);
    remains_.erase(std::next(each).base());
    return taken;
  }
  return std::nullopt;
}

}  // namespace jaywalk

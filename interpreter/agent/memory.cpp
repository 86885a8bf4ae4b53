// SPDX-License-Identifier: Apache-2.0
// Counts an agent's memory. The size of terms is known at any time (term/heap.h); other memory is
// noted when it is taken, never when it is freed, and counted anew after a cycle in which enough
// was noted to make counting cheap in comparison. Formulas that need more of it ask first
// (Heap::require_room), and fail at the limit. The count depends only on the data, not on memory
// kept for later, so that it is the same in every run.

#include <algorithm>
#include <bit>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/own_parts.h"
#include "interpreter/support/grown_bytes.h"

namespace jaywalk {
namespace {

constexpr std::size_t kContainerBytes = 48;
constexpr std::size_t kPlanPlacesBytes = 768;  // its label, and where the library has it

std::size_t bytes_of(const Loop& loop) {
  std::size_t bytes = sizeof(Loop) + grown_bytes(loop.bound.size(), sizeof(Value));
  for (const Loop::Level& level : loop.levels) bytes += bytes_of(level);
  return bytes;
}

// The memory of a means outside of its intention's stack.
std::size_t other_bytes_of(const IntendedMeans& means) {
  if (!means.extras) return 0;
  const MeansExtras& extras = *means.extras;
  std::size_t bytes = sizeof(MeansExtras);
  for (const Loop& loop : extras.loops) bytes += bytes_of(loop);
  if (extras.scope != nullptr) bytes += sizeof(Scope) + extras.scope->frame.size() * sizeof(Value);
  bytes += extras.codes.size() * kPlanBytes / 2;
  return bytes;
}

template <class Container>
std::size_t bytes_of_all(const Container& container) {
  return grown_bytes(container.size(), sizeof(typename Container::value_type));
}

// Gives the memory of a queue back that was much longer once.
template <class Queue>
void let_go(Queue& queue) {
  constexpr std::size_t kMany = 4096;
  if (queue.capacity() < kMany || queue.size() > queue.capacity() / 8) return;
  Queue shorter;
  for (auto& each : queue) shorter.push_back(std::move(each));
  queue = std::move(shorter);
}

}  // namespace

std::size_t bytes_of(const Loop::Level& level) {
  return sizeof(level) + grown_bytes(level.solutions.size(), sizeof(Value)) +
         grown_bytes(level.ends.size(), sizeof(std::size_t));
}

std::size_t Intention::bytes() const {
  constexpr std::size_t kLeastValues = 8;
  // A finished intention keeps these until it is forgotten.
  std::size_t bytes = sizeof(Intention) + 2 * kContainerBytes +
                      grown_bytes(std::max<std::size_t>(stack.size(), 1), sizeof(IntendedMeans)) +
                      grown_bytes(std::max(values.size(), kLeastValues), sizeof(Value));
  for (const IntendedMeans& means : stack) bytes += other_bytes_of(means);
  return bytes;
}

std::size_t Agent::other_bytes() {
  const Circumstance& c = circumstance_;
  std::size_t bytes = sizeof(Agent) + heap_.object_bytes() + beliefs_.bytes();
  for (const auto& intention : c.intentions) bytes += intention->bytes();
  bytes += bytes_of_all(c.intentions) + bytes_of_all(c.running) + bytes_of_all(c.events) +
           bytes_of_all(c.mailbox) + bytes_of_all(c.arriving) + bytes_of_all(c.actions) +
           bytes_of_all(c.acting) + bytes_of_all(c.feedback) + bytes_of_all(c.pending_events) +
           bytes_of_all(c.waits) + bytes_of_all(c.asks) + bytes_of_all(c.tasks) +
           2 * bytes_of_all(c.scheduled) + bytes_of_all(c.deadlines);
  for (const PendingAsk& ask : c.asks) bytes += bytes_of_all(ask.answers);
  if (own_ != nullptr) bytes += own_->plans.size() * (kPlanBytes + kPlanPlacesBytes);
  return bytes;
}

void Agent::let_go_of_memory() {
  Circumstance& c = circumstance_;
  let_go(c.events);
  let_go(c.running);
  let_go(c.intentions);
  if (c.mailbox.empty()) (void)c.mailbox.take();
}

void Agent::clean_up() {
  if (heap_.wants_collection()) collect_garbage();
  if (!heap_.wants_count()) return;
  let_go_of_memory();
  heap_.set_other_bytes(other_bytes());
}

// While a plan handles a failure, it may have a little more than others.
bool Agent::handles_failure(const Intention& intention) {
  const IntendedMeans& top = intention.top();
  return top.is_goal() && top.op == TriggerOperator::remove;
}

// Whether to log a failure for lack of memory: the first four, then the 8th, 16th, 32nd and so on.
bool Agent::tells_of_memory() {
  constexpr std::uint32_t kFirst = 4;
  ++memory_failures_;
  return memory_failures_ <= kFirst || std::has_single_bit(memory_failures_);
}

}  // namespace jaywalk

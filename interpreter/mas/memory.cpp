// SPDX-License-Identifier: Apache-2.0
// The memory of all agents of a system together. Each agent's share is known after each of its
// turns; the sum is taken when a round is over, so that an agent's room in the next round does not
// depend on threads. The names that agents have made are counted then, too. Terms count once here:
// not all agents collect theirs at the same time. When no memory is left, only agents that own less
// than an eighth of an equal share get more: they have not filled it.

#include <algorithm>
#include <fstream>
#include <unistd.h>

#include "interpreter/mas/system.h"

namespace jaywalk {
namespace {

// The memory limit of the process's control group; 0: no limit.
std::uint64_t memory_of_group() {
  std::uint64_t bytes = 0;
  std::ifstream file("/sys/fs/cgroup/memory.max");
  return file >> bytes ? bytes : 0;
}

}  // namespace

std::uint64_t half_of_the_machines_memory() {
  static const std::uint64_t half = [] {
    const auto pages = static_cast<std::uint64_t>(std::max(1L, sysconf(_SC_PHYS_PAGES)));
    const auto page = static_cast<std::uint64_t>(std::max(1L, sysconf(_SC_PAGESIZE)));
    const std::uint64_t group = memory_of_group();
    return (group == 0 ? pages * page : std::min(group, pages * page)) / 2;
  }();
  return half;
}

// Names that were made since the last count: with strings, entries of tables and lists.
void Mas::Implementation::count_names() {
  constexpr std::size_t kBytesOfSymbol = 128;
  constexpr std::size_t kBytesOfPredicate = 96;
  const std::size_t predicates = symbols_.predicate_count();
  name_bytes_ += (predicates - counted_predicates_) * kBytesOfPredicate;
  counted_predicates_ = predicates;
  for (const std::size_t count = symbols_.symbol_count(); counted_symbols_ < count;
       ++counted_symbols_) {
    const auto symbol = static_cast<Symbol>(counted_symbols_);
    name_bytes_ += kBytesOfSymbol + symbols_.text(symbol).size();
  }
}

void Mas::Implementation::share_memory() {
  constexpr std::size_t kPartOfShare = 8;
  const std::size_t most = options_.max_system_bytes;
  count_names();
  const auto owned =
      name_bytes_ + static_cast<std::size_t>(std::max<std::int64_t>(0, owned_bytes_));
  if (owned > most && ++full_rounds_ >= rounds_to_sweep_) {
    sweep();
    return;
  }
  left_bytes_ = most - std::min(most, owned);
  if (left_bytes_ >= options_.max_agent_bytes) return;
  least_bytes_ = most / (kPartOfShare * std::max<std::size_t>(1, table_.living()));
}

// Much of what agents own may be garbage. Where next to nothing is, that is found out ever less
// often.
void Mas::Implementation::sweep() {
  constexpr std::uint32_t kMostRounds = 1024;
  const std::int64_t before = owned_bytes_;
  for (AgentRecord& record : table_.all()) {
    if (record.is_leaving || record.agent == nullptr) continue;
    record.agent->heap().look_again();
    record.agent->clean_up();
    note_memory(record, owned_bytes_);
  }
  const bool was_worth_it = owned_bytes_ < before - before / 16;
  rounds_to_sweep_ = was_worth_it ? 1 : std::min(2 * rounds_to_sweep_ + 1, kMostRounds);
  full_rounds_ = 0;
  share_memory();
}

void Mas::Implementation::allow_memory(AgentRecord& record) const {
  Heap& heap = record.agent->heap();
  if (left_bytes_ >= options_.max_agent_bytes && heap.limit() == options_.max_agent_bytes) return;
  const std::size_t most = std::max(heap.all_bytes() + left_bytes_, least_bytes_);
  heap.set_limit_of_all(most < options_.max_agent_bytes);
  heap.set_limit(std::min<std::size_t>(most, options_.max_agent_bytes));
}

void Mas::Implementation::note_memory(AgentRecord& record, std::int64_t& sum) {
  const Heap& heap = record.agent->heap();
  const std::size_t all = heap.bytes() + heap.other_bytes() + sizeof(Agent) + sizeof(AgentRecord);
  sum += static_cast<std::int64_t>(all) - static_cast<std::int64_t>(record.known_bytes);
  record.known_bytes = all;
}

void Mas::Implementation::release_memory(AgentRecord& record) {
  owned_bytes_ -= static_cast<std::int64_t>(record.known_bytes);
  record.known_bytes = 0;
}

// Notes whether the agent has room for messages, which may fill seven eighths of its limit.
void Mas::Implementation::look_for_room(AgentRecord& receiver) {
  constexpr std::uint32_t kMostDeliveries = 1024;
  Heap& heap = receiver.agent->heap();
  const std::size_t most = options_.max_agent_bytes - options_.max_agent_bytes / 8;
  if (heap.all_bytes() <= most) {
    receiver.is_full = false;
    receiver.look_after = 0;
    return;
  }
  if (deliveries_ < receiver.look_at) return;
  heap.look_again();
  receiver.agent->clean_up();
  receiver.is_full = heap.all_bytes() > most;
  receiver.look_after = std::min(2 * receiver.look_after + 1, kMostDeliveries);
  receiver.look_at = deliveries_ + receiver.look_after;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Rounds in which agents reason in parallel, on several threads, with the same result as one
// after another.
//
// In a round every active agent takes a turn, in the order of numbers. Agents share nothing but the
// system, so turns are independent as long as none makes requests to it. Most requests can
// wait for the end of the round: messages arrive only then anyway, timers fire later, lines are
// written for people. So a thread takes the turns of a block of agents that stand one behind
// another and puts what they ask for into the block's outbox; afterwards the outboxes are emptied,
// block after block:
//
//   agents   0 1 2 3 | 4 5 6 7 | 8 ...         threads take blocks as they come
//   outbox   [print, letter] | [timer] | ...   emptied from the left
//
// Where an agent ends the run, the turns behind it have not been taken, as it were: what they asked
// for is dropped with their outboxes, and these agents take no further turns.
//
// Agents whose turn others could notice within the round (reach.h) do not reason in parallel.
// They split the round: all before them have their turns, then they, then all behind them.
//
// An outbox may hold much: a text is longer than the term that it prints. Where they hold too much
// together, the agents that are left have their turns one after another, as the outboxes are
// emptied.
//
// Rounds of a few agents are not worth the trouble.

#include "interpreter/mas/parallel.h"

#include <algorithm>

#include "interpreter/mas/system.h"

namespace jaywalk {

bool Mas::Implementation::can_reason_in_parallel(AgentRecord& record) {
  if (record.reach_version != reaches_.version()) {
    record.reach_version = reaches_.version();
    record.is_near = record.agent != nullptr && record.agent->customisation() == nullptr &&
                     reaches_.is_near(*record.program);
  }
  return record.is_near;
}

bool Mas::Implementation::round(Turn turn) {
  const std::span<const std::uint32_t> active = table_.begin_round();
  std::uint64_t turns = 0;
  std::size_t next = 0;
  while (next < active.size() && !ended_) {
    std::size_t end = next;
    if (workers_ != nullptr && active.size() - next >= options_.fewest_parallel) {
      while (end < active.size() && can_reason_in_parallel(table_[active[end]])) ++end;
    }
    if (end - next >= options_.fewest_parallel) {
      turns += take_turns_in_parallel(active.subspan(next, end - next), turn);
      next = end;
      continue;
    }
    for (end = std::min(end + 1, active.size()); next < end && !ended_; ++next) {
      turns += take_turn(table_[active[next]], turn) ? 1 : 0;
    }
  }
  table_.end_round();
  share_memory();
  return turns > 0;
}

bool Mas::Implementation::take_turn(AgentRecord& record, Turn turn) {
  if (record.is_leaving || !record.agent->is_active()) return false;
  Agent& agent = *record.agent;
  agent.turn().texts.begin_turn(left_bytes_);
  do {
    reason(record, turn == Turn::one_cycle ? 1 : UINT64_MAX);
  } while (turn == Turn::until_idle && !has_ended(block_of(agent)) && !record.is_leaving &&
           agent.is_active() && !interrupted());
  return true;
}

std::uint64_t Mas::Implementation::take_turns_in_parallel(std::span<const std::uint32_t> numbers,
                                                          Turn turn) {
  std::uint64_t turns = 0;
  reason_in_parallel(
      numbers,
      [&](AgentRecord& record, ParallelBlock& block) {
        if (take_turn(record, turn)) ++block.outbox.turns;
      },
      [&](ParallelBlock& block) { turns += block.outbox.turns; });
  return turns;
}

void Mas::Implementation::empty(Outbox& outbox) {
  outcome_.cycles += outbox.cycles;
  owned_bytes_ += outbox.grown;
  outbox.empty([this](Outbox::Kind kind, const std::string& text) { put_out(kind, text); },
               [this](Outbox::Letter& letter) {
                 AgentRecord& receiver = table_[letter.receiver];
                 post_content(receiver, letter.message, letter.message.content);
               },
               [this](const Timer& timer) { timers_.add(timer); });
  if (outbox.end) end(std::move(*outbox.end));
}

}  // namespace jaywalk

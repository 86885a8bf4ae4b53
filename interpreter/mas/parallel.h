// SPDX-License-Identifier: Apache-2.0
#pragma once

// Distributes agents that reason in parallel to the threads (parallel.cpp).

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

#include "interpreter/mas/system.h"

namespace jaywalk {

template <class TakeTurn>
void Mas::Implementation::take_turn_in_block(AgentRecord& record, ParallelBlock& block,
                                             TakeTurn take_turn) {
  Agent& agent = *record.agent;
  agent.set_turn(block);
  take_turn(record, block);
  agent.set_turn(turn_);
}

template <class TakeTurn, class IsDone>
void Mas::Implementation::reason_in_parallel(std::span<const std::uint32_t> numbers,
                                             TakeTurn take_turn, IsDone is_done) {
  // Several blocks for each thread, so that no thread waits long for the last one.
  constexpr std::size_t kBlocksPerWorker = 8;
  // The most bytes in outboxes; beyond, no other agent begins a turn before they are emptied.
  constexpr std::size_t kMostHeld = std::size_t{16} << 20U;
  const std::size_t workers = workers_->count();
  const std::size_t size = std::max<std::size_t>(1, numbers.size() / (workers * kBlocksPerWorker));
  const std::size_t blocks = (numbers.size() + size - 1) / size;
  std::vector<std::unique_ptr<ParallelBlock>> done(blocks);
  std::atomic<std::size_t> held = 0;
  workers_->run(blocks, [&](std::size_t worker, std::size_t index) {
    done[index] = std::make_unique<ParallelBlock>(*workspaces_of_workers_[worker]);
    ParallelBlock& block = *done[index];
    block.left = numbers.subspan(index * size, std::min(size, numbers.size() - index * size));
    while (!block.left.empty() && !block.outbox.end && held < kMostHeld) {
      const std::size_t before = block.outbox.bytes();
      take_turn_in_block(table_[block.left.front()], block, take_turn);
      block.left = block.left.subspan(1);
      held += block.outbox.bytes() - before;
    }
  });
  for (std::unique_ptr<ParallelBlock>& block : done) {
    empty(block->outbox);
    is_done(*block);
    // Nobody notices that these reason later than those behind them.
    for (std::span<const std::uint32_t> left = block->left; !left.empty() && !ended_;
         left = left.subspan(1)) {
      block = std::make_unique<ParallelBlock>(*workspaces_of_workers_.front());
      take_turn_in_block(table_[left.front()], *block, take_turn);
      empty(block->outbox);
      is_done(*block);
    }
    if (ended_) break;
    block.reset();
  }
  if (options_.max_run_inferences != 0) count_inferences({});
}

}  // namespace jaywalk

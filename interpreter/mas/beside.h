#pragma once

// Distributes agents that reason in parallel to the threads (parallel.cpp).

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

#include "interpreter/mas/system.h"

namespace jaywalk {

template <class TakeTurn>
void Mas::Implementation::take_turn_beside(Resident& resident, Beside& beside, TakeTurn take_turn) {
  Agent& agent = *resident.agent;
  agent.set_turn(beside);
  take_turn(resident, beside);
  agent.set_turn(turn_);
}

template <class TakeTurn, class IsDone>
void Mas::Implementation::reason_beside(std::span<const std::uint32_t> numbers, TakeTurn take_turn,
                                        IsDone is_done) {
  // Several blocks for each thread, so that no thread waits long for the last one.
  constexpr std::size_t kBlocksPerWorker = 8;
  // The most bytes in outboxes; beyond, no other agent begins a turn before they are emptied.
  constexpr std::size_t kMostHeld = std::size_t{16} << 20U;
  const std::size_t workers = workers_->count();
  const std::size_t size = std::max<std::size_t>(1, numbers.size() / (workers * kBlocksPerWorker));
  const std::size_t blocks = (numbers.size() + size - 1) / size;
  std::vector<std::unique_ptr<Beside>> done(blocks);
  std::atomic<std::size_t> held = 0;
  workers_->run(blocks, [&](std::size_t worker, std::size_t block) {
    done[block] = std::make_unique<Beside>(*workspaces_of_workers_[worker]);
    Beside& beside = *done[block];
    beside.left = numbers.subspan(block * size, std::min(size, numbers.size() - block * size));
    while (!beside.left.empty() && !beside.outbox.end && held < kMostHeld) {
      const std::size_t before = beside.outbox.bytes();
      take_turn_beside(residents_[beside.left.front()], beside, take_turn);
      beside.left = beside.left.subspan(1);
      held += beside.outbox.bytes() - before;
    }
  });
  for (std::unique_ptr<Beside>& beside : done) {
    empty(beside->outbox);
    is_done(*beside);
    // Nobody notices that these reason later than those behind them.
    for (std::span<const std::uint32_t> left = beside->left; !left.empty() && !ended_;
         left = left.subspan(1)) {
      beside = std::make_unique<Beside>(*workspaces_of_workers_.front());
      take_turn_beside(residents_[left.front()], *beside, take_turn);
      empty(beside->outbox);
      is_done(*beside);
    }
    if (ended_) break;
    beside.reset();
  }
  if (options_.max_run_inferences != 0) count_inferences({});
}

}  // namespace jaywalk

#pragma once

// How agents that reason beside each other are given to the threads (parallel.cpp).

#include <algorithm>
#include <memory>
#include <vector>

#include "interpreter/mas/system.h"

namespace jaywalk {

template <class TakeTurn, class IsDone>
void Mas::Implementation::reason_beside(std::span<const std::uint32_t> numbers, TakeTurn take_turn,
                                        IsDone is_done) {
  // So many blocks for each thread, so that none waits long for the last one.
  constexpr std::size_t kBlocksPerWorker = 8;
  const std::size_t workers = workers_->count();
  const std::size_t size = std::max<std::size_t>(1, numbers.size() / (workers * kBlocksPerWorker));
  const std::size_t blocks = (numbers.size() + size - 1) / size;
  std::vector<std::unique_ptr<Beside>> done(blocks);
  workers_->run(blocks, [&](std::size_t worker, std::size_t block) {
    done[block] = std::make_unique<Beside>(*workspaces_of_workers_[worker]);
    Beside& beside = *done[block];
    beside_ = &beside;
    const std::size_t first = block * size;
    for (const std::uint32_t number :
         numbers.subspan(first, std::min(size, numbers.size() - first))) {
      if (beside.outbox.end) break;
      take_turn(residents_[number], beside);
    }
    beside_ = nullptr;
  });
  for (const auto& beside : done) {
    empty(beside->outbox);
    is_done(*beside);
    if (ended_) break;
  }
  if (options_.max_run_inferences != 0) count_inferences({});
}

}  // namespace jaywalk

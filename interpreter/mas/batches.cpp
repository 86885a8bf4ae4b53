// SPDX-License-Identifier: Apache-2.0
// Steps in which each agent reasons for many cycles in a row, instead of one cycle in turn.
//
// Agents take turns so that each sees what the others have done up to now. Where all of them keep
// to themselves (program/isolation.h) there is nothing to see, and taking turns among a million
// agents only means that each cycle begins with memory that has long left every cache. So in one
// round each agent does the cycles of many steps, and the result is that of the steps one after
// another:
//
//   step      1    2    3             round
//   agent 0   c1   c2   c3     as     c1 c2 c3
//   agent 1   c1   c2                 c1 c2
//
// What such agents can make known are warnings. These are held back and written in the order of the
// steps. Time passes after the same number of steps, and a run that comes near a limit goes on step
// by step, so that it ends where it would have ended.

#include <algorithm>
#include <iterator>

#include "interpreter/mas/parallel.h"
#include "interpreter/mas/system.h"
#include "interpreter/program/isolation.h"

namespace jaywalk {

void Mas::Implementation::check_isolation(const Program& program) {
  if (!all_keep_to_themselves_ || isolated_program_ == &program) return;
  isolated_program_ = &program;
  all_keep_to_themselves_ = keeps_to_itself(program);
}

bool Mas::Implementation::can_run_batch(std::uint64_t most) const {
  const bool is_near_limit = options_.max_cycles != 0 && steps_ + most >= options_.max_cycles;
  return most > 1 && all_keep_to_themselves_ && !options_.realtime && !is_near_limit &&
         options_.observer == nullptr;
}

// Up to `most` cycles of every active agent; the result is how many the longest took. On several
// threads what is logged comes in the same order: block after block, and then by step.
std::uint64_t Mas::Implementation::run_batch(std::uint64_t most) {
  batch_.longest = 0;
  const std::span<const std::uint32_t> active = table_.begin_round();
  if (workers_ != nullptr && active.size() >= options_.fewest_parallel) {
    run_batch_in_parallel(active, most);
  } else {
    for (const std::uint32_t number : active) {
      if (ended_) break;
      reason_in_batch(table_[number], most, batch_);
    }
  }
  table_.end_round();
  share_memory();
  if (!batch_.lines.empty()) write_held_log();
  return batch_.longest;
}

void Mas::Implementation::run_batch_in_parallel(std::span<const std::uint32_t> numbers,
                                                std::uint64_t most) {
  reason_in_parallel(
      numbers,
      [&](AgentRecord& record, ParallelBlock& block) {
        reason_in_batch(record, most, block.batch);
      },
      [&](ParallelBlock& block) {
        batch_.longest = std::max(batch_.longest, block.batch.longest);
        std::move(block.batch.lines.begin(), block.batch.lines.end(),
                  std::back_inserter(batch_.lines));
      });
}

void Mas::Implementation::reason_in_batch(AgentRecord& record, std::uint64_t most, Batch& batch) {
  if (record.is_leaving || !record.agent->is_active()) return;
  batch.agent = record.agent.get();
  batch.since = batch.agent->cycles();
  record.agent->turn().texts.begin_turn(left_bytes_);
  reason(record, most);
  batch.longest = std::max(batch.longest, batch.agent->cycles() - batch.since);
  batch.agent = nullptr;
}

// In the order in which it would have been written step by step.
void Mas::Implementation::write_held_log() {
  std::stable_sort(batch_.lines.begin(), batch_.lines.end(),
                   [](const Batch::Line& a, const Batch::Line& b) { return a.step < b.step; });
  for (const Batch::Line& line : batch_.lines) options_.log(line.text);
  batch_.lines.clear();
}

}  // namespace jaywalk

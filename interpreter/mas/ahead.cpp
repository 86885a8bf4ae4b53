// Steps in which each agent reasons for many cycles in a row, instead of one cycle in turn.
//
// Agents take turns so that each sees what the others have done up to now. Where all of them keep
// to themselves (program/solitary.h) there is nothing to see, and taking turns among a million
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

#include "interpreter/mas/beside.h"
#include "interpreter/mas/system.h"
#include "interpreter/program/solitary.h"

namespace jaywalk {

void Mas::Implementation::look_whether_solitary(const Program& program) {
  if (!all_keep_to_themselves_ || known_solitary_ == &program) return;
  known_solitary_ = &program;
  all_keep_to_themselves_ = keeps_to_itself(program);
}

bool Mas::Implementation::can_run_ahead(std::uint64_t most) const {
  const bool is_near_limit = options_.max_cycles != 0 && steps_ + most >= options_.max_cycles;
  return most > 1 && all_keep_to_themselves_ && !options_.realtime && !is_near_limit &&
         options_.observer == nullptr;
}

// Up to `most` cycles of every active agent; the result is how many the longest took. On several
// threads what is logged comes in the same order: block after block, and then by step.
std::uint64_t Mas::Implementation::run_ahead(std::uint64_t most) {
  ahead_.longest = 0;
  const std::span<const std::uint32_t> active = residents_.begin_round();
  if (workers_ != nullptr && active.size() >= options_.fewest_beside) {
    run_ahead_beside(active, most);
  } else {
    for (const std::uint32_t number : active) {
      if (ended_) break;
      reason_ahead(residents_[number], most, ahead_);
    }
  }
  residents_.end_round();
  share_memory();
  if (!ahead_.lines.empty()) write_held_log();
  return ahead_.longest;
}

void Mas::Implementation::run_ahead_beside(std::span<const std::uint32_t> numbers,
                                           std::uint64_t most) {
  reason_beside(
      numbers,
      [&](Resident& resident, Beside& beside) { reason_ahead(resident, most, beside.ahead); },
      [&](Beside& beside) {
        ahead_.longest = std::max(ahead_.longest, beside.ahead.longest);
        std::move(beside.ahead.lines.begin(), beside.ahead.lines.end(),
                  std::back_inserter(ahead_.lines));
      });
}

void Mas::Implementation::reason_ahead(Resident& resident, std::uint64_t most, Ahead& ahead) {
  if (resident.is_leaving || !resident.agent->is_active()) return;
  ahead.agent = resident.agent.get();
  ahead.since = ahead.agent->cycles();
  resident.agent->turn().texts.begin_turn(left_bytes_);
  reason(resident, most);
  ahead.longest = std::max(ahead.longest, ahead.agent->cycles() - ahead.since);
  ahead.agent = nullptr;
}

// In the order in which it would have been written step by step.
void Mas::Implementation::write_held_log() {
  std::stable_sort(ahead_.lines.begin(), ahead_.lines.end(),
                   [](const Ahead::Line& a, const Ahead::Line& b) { return a.step < b.step; });
  for (const Ahead::Line& line : ahead_.lines) options_.log(line.text);
  ahead_.lines.clear();
}

}  // namespace jaywalk

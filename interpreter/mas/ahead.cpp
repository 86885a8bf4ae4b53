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
  return most > 1 && all_keep_to_themselves_ && lanes_ == nullptr && !options_.realtime &&
         !is_near_limit && options_.observer == nullptr;
}

// Up to `most` cycles of every active agent; the result is how many the longest took.
std::uint64_t Mas::Implementation::run_ahead(std::uint64_t most) {
  std::uint64_t longest = 0;
  for (const std::uint32_t number : residents_.begin_round()) {
    Resident& resident = residents_[number];
    if (ended_) break;
    if (resident.is_leaving || !resident.agent->is_active()) continue;
    ahead_ = resident.agent.get();
    ahead_since_ = ahead_->cycles();
    const std::uint64_t before = outcome_.cycles;
    reason(resident, most);
    longest = std::max(longest, outcome_.cycles - before);
  }
  ahead_ = nullptr;
  residents_.end_round();
  if (!held_log_.empty()) write_held_log();
  return longest;
}

// In the order in which it would have been written step by step.
void Mas::Implementation::write_held_log() {
  std::stable_sort(held_log_.begin(), held_log_.end(),
                   [](const HeldLine& a, const HeldLine& b) { return a.step < b.step; });
  for (const HeldLine& line : held_log_) options_.log(line.text);
  held_log_.clear();
}

}  // namespace jaywalk

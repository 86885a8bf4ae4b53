#include "interpreter/program/program.h"

#include <algorithm>

namespace jaywalk {

bool Program::can_start_later() const {
  constexpr std::size_t kMostBeliefs = 1000;
  return !goals_.empty() && beliefs_.size() <= kMostBeliefs &&
         std::all_of(goals_.begin(), goals_.end(),
                     [](const Goal& goal) { return goal.literal.is_closed(); });
}

}  // namespace jaywalk

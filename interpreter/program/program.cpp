// SPDX-License-Identifier: Apache-2.0
#include "interpreter/program/program.h"

#include <algorithm>

namespace jaywalk {

bool Program::can_start_later() const {
  constexpr std::size_t kMostBeliefs = 1000;
  return !goals_.empty() && beliefs_.size() <= kMostBeliefs &&
         std::all_of(goals_.begin(), goals_.end(),
                     [](const Goal& goal) { return goal.literal.is_closed(); });
}

SourcePtr Program::find_source(std::string_view file) const {
  const auto found = std::find_if(sources_.begin(), sources_.end(),
                                  [&](const SourcePtr& source) { return source->name() == file; });
  return found == sources_.end() ? nullptr : *found;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "interpreter/mas/constants.h"

#include <algorithm>

#include "interpreter/program/rule_folder.h"

namespace jaywalk {

void Constants::learn(const Environment& environment, SymbolTable& symbols) {
  constexpr std::size_t kMostPrograms = 64;  // more are not likely to be run again
  if (followed_.size() > kMostPrograms) followed_.clear();
  said_.begin_look();
  environment.constants(said_);
  said_.end_look();
  if (percepts_ != nullptr && said_.news().empty() && said_.gone_size() == 0) return;
  followed_.clear();
  std::vector<ConstantPercepts::Percept> percepts;
  for (std::size_t i = 0; i < said_.size(); ++i) {
    percepts.push_back({said_.predicate(i), said_.args(i)});
  }
  percepts_ = std::make_unique<ConstantPercepts>(percepts, names_, symbols);
}

KnownToAll Constants::known_to_agents_of(const std::shared_ptr<const Program>& program,
                                         SymbolTable& symbols) {
  if (percepts_->is_empty()) return {};
  auto known = std::ranges::find(followed_, program, &Followed::program);
  if (known == followed_.end()) {
    followed_.push_back({program, fold_rules(*program, *percepts_, symbols)});
    known = followed_.end() - 1;
  }
  return {.percepts = percepts_.get(), .rules = known->rules};
}

}  // namespace jaywalk

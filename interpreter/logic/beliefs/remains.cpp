// SPDX-License-Identifier: Apache-2.0
// The parts of a belief base that the next agent reuses: relations with room for rows.

#include "interpreter/logic/beliefs/belief_base.h"

namespace jaywalk {

void Relation::reset() {
  exists = false;
  is_folded_in = false;
  is_folded_ = false;
  rows_ = &kNoRows;
  shared_ = nullptr;
  rules_ = 0;
  first_seq_ = 0;
  holes_ = 0;
  table_ = nullptr;
  if (own_ == nullptr) return;
  constexpr std::size_t kMostRowsKept = 16;
  if (own_->rows.capacity() <= kMostRowsKept) {
    own_->rows.clear();
  } else {
    own_->rows = {};
  }
  own_->indexes.reset();
  own_->table.reset();
  own_->rules.clear();
  own_->percepts = {};
  rows_ = &own_->rows;
}

BeliefBase::Remains BeliefBase::leave_remains() {
  constexpr std::size_t kMostRelations = 256;  // more were made of names that may not come again
  Remains remains;
  if (known_.size() > kMostRelations) return remains;
  for (Relation* const relation : relations_) relation->reset();
  relations_.clear();
  perceived_.clear();
  remains.relations_ = std::move(relations_);
  remains.perceived_ = std::move(perceived_);
  remains.known_ = std::move(known_);
  remains.by_predicate_ = std::move(by_predicate_);
  return remains;
}

}  // namespace jaywalk

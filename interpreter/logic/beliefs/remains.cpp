// What is left of a belief base for the next agent: relations with room for rows.

#include "interpreter/logic/beliefs/belief_base.h"

namespace jaywalk {

void Relation::reset() {
  exists = false;
  constexpr std::size_t kMostRowsKept = 16;
  if (own_.capacity() <= kMostRowsKept) {
    own_.clear();
  } else {
    own_ = {};
  }
  rows_ = &own_;
  shared_ = nullptr;
  rules_ = 0;
  first_seq_ = 0;
  holes_ = 0;
  forget_rule_table();
  rules_owned_.clear();
  indexes_.reset();
  percepts = 0;
  has_percepts = false;
  perceived_since = 0;
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

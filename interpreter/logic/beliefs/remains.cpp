// What is left of a belief base for the next agent with the same program: relations with room for
// rows, and where nothing but the program's rules has been in a relation, these rules.

#include "interpreter/logic/beliefs/belief_base.h"

namespace jaywalk {

void Relation::reset(Rules rules) {
  exists = false;
  // Whatever changes the rows forgets the table.
  has_kept_rules_ = rules == Rules::kept && table_ != nullptr && own_table_ == nullptr;
  if (has_kept_rules_) return;
  constexpr std::size_t kMostRowsKept = 16;
  if (rows_.capacity() <= kMostRowsKept) {
    rows_.clear();
  } else {
    rows_ = {};
  }
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

BeliefBase::Remains BeliefBase::leave_remains(Relation::Rules rules) {
  constexpr std::size_t kMostRelations = 256;  // more were made of names that may not come again
  Remains remains;
  if (known_.size() > kMostRelations) return remains;
  for (Relation* const relation : relations_) relation->reset(rules);
  relations_.clear();
  perceived_.clear();
  remains.relations_ = std::move(relations_);
  remains.perceived_ = std::move(perceived_);
  remains.known_ = std::move(known_);
  remains.by_predicate_ = std::move(by_predicate_);
  return remains;
}

void BeliefBase::bring_into_being(Relation& relation) {
  relation.exists = true;
  relations_.push_back(&relation);
}

void BeliefBase::begin_with_rule(const RuleCode& rule) {
  const std::uint32_t place =
      by_predicate_.find(static_cast<std::uint32_t>(literal_parts(rule.head).predicate));
  Relation* const known = place == FlatIndex<std::uint32_t>::kNone ? nullptr : known_[place].get();
  if (known == nullptr || !known->has_kept_rules()) {
    add_rule(rule, Place::front);
  } else if (!known->exists) {
    bring_into_being(*known);
  }
}

}  // namespace jaywalk

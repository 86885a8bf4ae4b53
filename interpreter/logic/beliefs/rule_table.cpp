// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/beliefs/rule_table.h"

#include <utility>

namespace jaywalk {
namespace {

// An atom with annotations unifies with the bare atom, so structures and atoms count as one kind.
bool may_be_equal(Value::Kind a, Value::Kind b) {
  const auto is_name = [](Value::Kind kind) {
    return kind == Value::Kind::atom || kind == Value::Kind::structure;
  };
  return a == b || (is_name(a) && is_name(b));
}

bool may_match(const RuleTable::Candidate& candidate, Value::Kind kind) {
  if (candidate.key == 0 || kind == Value::Kind::variable) return true;
  return may_be_equal(candidate.rule->head.structure()->arg(0).kind(), kind);
}

}  // namespace

RuleTable::RuleTable(std::vector<Candidate> candidates) : candidates_(std::move(candidates)) {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    std::size_t found = 0;
    for (const Candidate& candidate : candidates_) {
      if (!may_match(candidate, static_cast<Value::Kind>(kind))) continue;
      only_[kind] = ++found == 1 ? candidate.rule : nullptr;
    }
  }
}

}  // namespace jaywalk

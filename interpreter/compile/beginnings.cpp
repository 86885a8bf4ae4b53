// SPDX-License-Identifier: Apache-2.0
#include "interpreter/compile/beginnings.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "interpreter/logic/beliefs/belief_base.h"
#include "interpreter/program/plan_compiler.h"

namespace jaywalk {
namespace {

bool is_heard_of(const Program& program, Predicate predicate, SymbolTable& symbols) {
  const TriggerKey key = trigger_key(TriggerOperator::add, TriggerKind::belief, predicate, symbols);
  return !program.library().candidates(key).empty();
}

const RuleTable* table_of(const Program& program, Predicate predicate) {
  const auto& tables = program.rule_tables();
  const auto found =
      std::ranges::find(tables, predicate, [](const auto& each) { return each.first; });
  return found == tables.end() ? nullptr : &found->second;
}

// The beliefs of one predicate as a relation has them.
std::unique_ptr<const SharedRows> rows_of(const Program& program,
                                          const Program::Beginning& beginning,
                                          BeliefBase& beliefs) {
  bool has_facts = false;
  for (const std::uint32_t each : beginning.beliefs) {
    const Program::Belief& belief = program.beliefs()[each];
    has_facts = has_facts || belief.rule == nullptr;
    if (belief.rule != nullptr) {
      beliefs.add_rule(*belief.rule, Place::front);
    } else {
      (void)beliefs.add(belief.fact);
    }
  }
  const Relation& relation = *beliefs.find(beginning.predicate);
  Ring<Row> rows;
  for (std::int64_t seq = relation.first_seq(); seq < relation.end_seq(); ++seq) {
    rows.push_back(relation.row(seq));
  }
  return std::make_unique<const SharedRows>(
      std::move(rows), has_facts ? nullptr : table_of(program, beginning.predicate));
}

}  // namespace

std::vector<Program::Beginning> beginnings_of(const Program& program, Heap& constants,
                                              SymbolTable& symbols) {
  struct Group {
    std::size_t number = 0;
    bool is_heard_of = false;
  };
  std::vector<Program::Beginning> made;
  std::unordered_map<Predicate, Group> groups;
  const Group* last_heard_of = nullptr;
  for (std::size_t i = program.beliefs().size(); i > 0; --i) {
    const Predicate predicate = program.beliefs()[i - 1].predicate;
    const auto [known, is_new] = groups.try_emplace(predicate);
    Group& group = known->second;
    if (is_new) group.is_heard_of = is_heard_of(program, predicate, symbols);
    // A new group, since events must come in the order of all facts, regardless of their predicate.
    if (is_new || (group.is_heard_of && last_heard_of != &group)) {
      group.number = made.size();
      made.push_back({.predicate = predicate, .rows = nullptr, .beliefs = {}});
    }
    if (group.is_heard_of) last_heard_of = &group;
    made[group.number].beliefs.push_back(static_cast<std::uint32_t>(i - 1));
  }
  BeliefBase beliefs(constants, symbols);
  for (Program::Beginning& each : made) {
    if (!groups.at(each.predicate).is_heard_of) each.rows = rows_of(program, each, beliefs);
  }
  return made;
}

}  // namespace jaywalk

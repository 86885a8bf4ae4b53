// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/beliefs/constant_percepts.h"

#include <algorithm>
#include <utility>

#include "interpreter/logic/beliefs/belief_base.h"

namespace jaywalk {
namespace {

bool is_lasting(const ConstantPercepts::Percept& percept, std::uint32_t names) {
  return static_cast<std::uint32_t>(percept.predicate) < names &&
         std::ranges::all_of(percept.args, [&](Value arg) {
           return !arg.is_atom() || static_cast<std::uint32_t>(arg.atom_id()) < names;
         });
}

Ring<Row> always_seen(const Relation& perceived) {
  Ring<Row> rows;
  for (std::int64_t seq = perceived.first_seq(); seq < perceived.end_seq(); ++seq) {
    rows.push_back(perceived.row(seq));
    rows.back().percept_generation = SharedRows::kAlwaysSeen;
  }
  return rows;
}

}  // namespace

// The rows are those of an agent that perceives them and believes nothing else.
ConstantPercepts::ConstantPercepts(std::span<const Percept> said, std::uint32_t names,
                                   SymbolTable& symbols) {
  BeliefBase beliefs(heap_, symbols);
  beliefs.begin_percepts();
  std::vector<Predicate> left_out;
  for (const Percept& each : said) {
    BeliefBase::PerceptChange news;
    const bool is_new = beliefs.perceive(each.predicate, each.args, news);
    if (!is_new || !is_lasting(each, names)) left_out.push_back(each.predicate);
  }
  for (const Relation* const each : beliefs.relations()) {
    if (std::ranges::find(left_out, each->predicate()) != left_out.end()) continue;
    by_predicate_.insert(static_cast<std::uint32_t>(each->predicate()),
                         static_cast<std::uint32_t>(rows_.size()));
    rows_.push_back(std::make_unique<const SharedRows>(always_seen(*each), nullptr));
  }
}

}  // namespace jaywalk

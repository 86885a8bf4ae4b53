// SPDX-License-Identifier: Apache-2.0
// Belief update, Jason's buf. Every percept is a row that bears the number of the update that last
// saw it, its generation. There are two ways to bring the percepts up to date:
//
// - by all of them: each is looked up and gets the new generation; rows of an older one go;
// - by the differences to the last update: only what is new is looked up, and what may have gone.
//   Something that has only changed its place in the list is both: it has the new generation by the
//   time it is missed, and stays.
//
// The second way is open as long as the rows are what the last update left (the agent may have
// deleted some, and then they come back) and nothing was perceived twice: a list with a literal in
// two places could lose it in one of them. Each literal that is perceived again must thus be missed
// as well, or it stands somewhere else, too, and the next update is one by all percepts.
//
// Constant percepts are shared in the first update, with events as for any, and then are neither
// looked up nor missed. Where an agent changes something of them, or they are perceived anew after
// all, their relation becomes the agent's own and is as any other.
//
// Both ways make the same changes in the same order: what goes, by relation in the order in which
// they came to have percepts, and by row; then what comes, in the order of perception.

#include <algorithm>
#include <tuple>

#include "interpreter/logic/beliefs/belief_base.h"
#include "interpreter/logic/beliefs/constant_percepts.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/transfer.h"

namespace jaywalk {
namespace {

// Whether it has no percept any more, and so is not among the relations that have some.
bool leave_perceived(Relation& relation) {
  Relation::Percepts& percepts = relation.percepts();
  if (percepts.rows == 0) percepts.since = 0;
  return percepts.rows == 0;
}

}  // namespace

void BeliefBase::begin_percepts() {
  if (generation_ != 0) constants_ = nullptr;
  ++generation_;
  knows_percepts_ = true;
  seen_again_ = 0;
}

Value BeliefBase::percept_annotations(Value annotations) {
  if (annotations.is_empty_list()) return source_percept();
  return union_of(heap_, transfer(annotations, heap_), source_percept(), symbols_);
}

// The arguments are ground, so the literal is closed.
Value BeliefBase::percept(Predicate predicate, std::span<const Value> args, Value annotations) {
  Structure* const made = heap_.blank_literal(predicate, args.size(), annotations);
  Value* const cells = made->args();
  for (std::size_t i = 0; i < args.size(); ++i) {
    cells[i] = args[i].is_number() || args[i].is_atom() ? args[i] : transfer(args[i], heap_);
  }
  return heap_.literal_of(made, true);
}

// The order of rows cannot change, and no plan is triggered by it.
bool BeliefBase::change_percept(Predicate predicate, std::span<const Value> old_args,
                                std::span<const Value> args) {
  Relation* const rel = find(predicate);
  if (rel == nullptr || rel->is_shared() || rel->is_indexed()) return false;
  const Row* const lone = rel->lone_fact();
  if (lone == nullptr || lone->percept_generation == 0) return false;
  const LiteralParts old = literal_parts(lone->fact);
  const auto same = [](Value a, Value b) { return a.same_as(b); };
  const auto equal = [](Value a, Value b) {
    return a.is_number() && b.is_number() ? a.as_number() == b.as_number() : equal_terms(a, b);
  };
  if (!old.annots.same_as(source_percept()) ||
      !std::equal(old.args.begin(), old.args.end(), old_args.begin(), old_args.end(), same) ||
      std::equal(old.args.begin(), old.args.end(), args.begin(), args.end(), equal)) {
    return false;
  }
  Row& row = rel->own_row(rel->first_seq());
  row.fact = percept(predicate, args, source_percept());
  row.key = args.empty() ? 0 : argument_key(args[0]);
  row.percept_generation = generation_;
  return true;
}

// Adds a percept that the environment declares constant, unless there are beliefs of its predicate.
bool BeliefBase::perceive_constant(Relation& rel, std::span<const Value> args,
                                   PerceptChange& change) {
  if (!rel.is_shared() && rel.size() == 0) {
    const SharedRows* const rows = constants_->find(rel.predicate());
    if (rows == nullptr) return false;
    rel.share(*rows);
  }
  if (!rel.is_shared() || !rel.shared()->are_percepts()) return false;
  const auto known = rel.find(args);
  if (!known) return false;
  change = {rel.row(*known).fact, true};
  return true;
}

bool BeliefBase::perceive(Predicate predicate, std::span<const Value> args, PerceptChange& change,
                          Value annotations) {
  Relation& rel = relation(predicate);
  if (constants_ != nullptr && perceive_constant(rel, args, change)) return true;
  make_own(rel);
  Relation::Hash hash = 0;
  if (const auto known = rel.find(args, hash)) {
    Row& row = rel.own_row(*known);
    if (row.percept_generation == generation_) knows_percepts_ = false;  // twice
    const bool perceived = row.percept_generation != 0;
    row.percept_generation = generation_;
    if (perceived) {
      ++seen_again_;
      return false;
    }
    const Value added = percept_annotations(annotations);
    const Value annots = union_of(heap_, literal_parts(row.fact).annots, added, symbols_);
    row.fact = with_annotations(heap_, row.fact, annots);
    change = {with_annotations(heap_, row.fact, added), true};
  } else {
    const Value literal = percept(predicate, args, percept_annotations(annotations));
    rel.add_front({.fact = literal,
                   .rule = nullptr,
                   .key = args.empty() ? 0 : argument_key(args[0]),
                   .percept_generation = generation_},
                  hash);
    change = {literal, true};
  }
  note_percepts(rel, 1);
  return true;
}

// So many more rows of it are percepts.
void BeliefBase::note_percepts(Relation& rel, std::uint32_t rows) {
  Relation::Percepts& percepts = rel.percepts();
  percepts.rows += rows;
  if (percepts.since != 0) return;
  percepts.since = ++last_perceived_;
  perceived_.push_back(&rel);
}

void BeliefBase::end_percepts(std::vector<PerceptChange>& changes) {
  const bool knows_percepts = knows_percepts_;
  std::erase_if(perceived_, [&](Relation* rel) {
    for (std::int64_t seq = rel->first_seq(); seq < rel->end_seq(); ++seq) {
      const std::uint32_t generation = rel->row(seq).percept_generation;
      if (generation != 0 && generation != generation_) remove_percept(*rel, seq, changes);
    }
    return leave_perceived(*rel);
  });
  knows_percepts_ = knows_percepts;
}

void BeliefBase::miss(Predicate predicate, std::span<const Value> args) {
  Relation* const rel = find(predicate);
  if (rel == nullptr) return;
  make_own(*rel);
  const auto known = rel->find(args);
  if (!known) return;
  if (rel->row(*known).percept_generation == generation_) {
    --seen_again_;
  } else {
    missed_.emplace_back(rel, *known);
  }
}

void BeliefBase::end_missed(std::vector<PerceptChange>& changes) {
  const bool knows_percepts = knows_percepts_ && seen_again_ == 0;
  const auto place = [](const auto& missed) {
    return std::tuple(missed.first->percepts().since, missed.second);
  };
  std::sort(missed_.begin(), missed_.end(),
            [&](const auto& a, const auto& b) { return place(a) < place(b); });
  bool is_some_empty = false;
  for (const auto& [rel, seq] : missed_) {
    remove_percept(*rel, seq, changes);
    is_some_empty = is_some_empty || rel->percepts().rows == 0;
  }
  missed_.clear();
  if (is_some_empty) {
    std::erase_if(perceived_, [](Relation* rel) { return leave_perceived(*rel); });
  }
  knows_percepts_ = knows_percepts;
}

// The row stays if the belief has other sources.
void BeliefBase::remove_percept(Relation& rel, std::int64_t seq,
                                std::vector<PerceptChange>& changes) {
  Row& row = rel.own_row(seq);
  no_percept_any_more(rel, row);
  if (literal_parts(row.fact).annots.same_as(source_percept())) {
    changes.push_back({row.fact, false});
    erase(rel, seq);
    return;
  }
  changes.push_back({with_annotations(heap_, row.fact, source_percept()), false});
  remove_annotations(rel, seq, source_percept(), false);
}

void BeliefBase::no_percept_any_more(Relation& rel, Row& row) {
  if (row.percept_generation == 0) return;
  row.percept_generation = 0;
  --rel.percepts().rows;
  knows_percepts_ = false;
}

}  // namespace jaywalk

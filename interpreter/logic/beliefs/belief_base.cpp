// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/beliefs/belief_base.h"

#include "interpreter/logic/beliefs/folded_rules.h"
#include "interpreter/support/grown_bytes.h"
#include "interpreter/term/compare.h"

namespace jaywalk {
namespace {

bool has_percept_source(Value annots) {
  const Value percept = source_percept().pair()->head;
  for (annots = deref(annots); annots.is_pair(); annots = deref(annots.pair()->tail)) {
    const Value annot = deref(annots.pair()->head);
    if (annot.same_as(percept) || equal_terms(annot, percept)) return true;
  }
  return false;
}

}  // namespace

Relation& BeliefBase::relation(Predicate predicate) {
  const auto key = static_cast<std::uint32_t>(predicate);
  std::uint32_t place = by_predicate_.find(key);
  if (place == FlatIndex<std::uint32_t>::kNone) {
    place = static_cast<std::uint32_t>(known_.size());
    known_.push_back(std::make_unique<Relation>(predicate));
    by_predicate_.insert(key, place);
  }
  Relation& relation = *known_[place];
  if (!relation.exists) {
    relation.exists = true;
    relations_.push_back(&relation);
  }
  return relation;
}

bool BeliefBase::share(Predicate predicate, const SharedRows& rows) {
  if (find(predicate) != nullptr) return false;
  relation(predicate).share(rows);
  return true;
}

// Before something of its rows is changed.
void BeliefBase::make_own(Relation& relation) {
  if (!relation.is_shared()) return;
  if (relation.is_folded_in) unfold_rules();
  const bool are_percepts = relation.shared()->are_percepts();
  relation.own_rows();
  if (are_percepts) note_percepts(relation, static_cast<std::uint32_t>(relation.size()));
  heap_.note_other_bytes(relation.size() * Relation::kRowBytes);
}

void BeliefBase::fold(const FoldedRules& rules) {
  for (const auto& [predicate, rows] : rules.needs) {
    const Relation* const needed = find(predicate);
    if (needed == nullptr || needed->shared() != rows) return;
  }
  for (const auto& need : rules.needs) find(need.predicate)->is_folded_in = true;
  find(rules.predicate)->fold(rules.table);
}

// Facts that folded rules depend on change. That is so rare that all rules are evaluated again.
void BeliefBase::unfold_rules() {
  for (Relation* const each : relations_) {
    if (each->is_folded()) each->unfold();
    each->is_folded_in = false;
  }
}

std::optional<Value> BeliefBase::add(Value literal, Place place) {
  const LiteralParts parts = literal_parts(literal);
  Relation& rel = relation(parts.predicate);
  Relation::Hash hash = 0;
  const std::optional<std::int64_t> known = rel.find(parts.args, hash);
  if (!known) {
    make_own(rel);
    const Row row{.fact = literal, .key = parts.args.empty() ? 0 : argument_key(parts.args[0])};
    place == Place::front ? rel.add_front(row, hash) : rel.add_back(row, hash);
    heap_.protect();
    return literal;
  }
  const Value old = literal_parts(rel.row(*known).fact).annots;
  std::vector<Value> news;
  for (Value rest = deref(parts.annots); rest.is_pair(); rest = deref(rest.pair()->tail)) {
    const Value annot = deref(rest.pair()->head);
    bool present = false;
    for (Value o = old; o.is_pair() && !present; o = o.pair()->tail) {
      present = equal_terms(o.pair()->head, annot);
    }
    if (!present) news.push_back(annot);
  }
  if (news.empty()) return std::nullopt;
  const Value added = heap_.list(news);
  make_own(rel);
  Row& row = rel.own_row(*known);
  row.fact = with_annotations(heap_, row.fact, union_of(heap_, old, added, symbols_));
  heap_.protect();
  return with_annotations(heap_, literal, added);
}

void BeliefBase::add_rule(const RuleCode& rule, Place place) {
  const LiteralParts head = literal_parts(rule.head);
  Relation& rel = relation(head.predicate);
  make_own(rel);
  const Row row{
      .fact = Value(), .rule = &rule, .key = head.args.empty() ? 0 : argument_key(head.args[0])};
  place == Place::front ? rel.add_front(row) : rel.add_back(row);
}

void BeliefBase::add_rule(std::unique_ptr<RuleCode> rule, Place place) {
  const RuleCode& code = *rule;
  relation(literal_parts(code.head).predicate).own_rule(std::move(rule));
  add_rule(code, place);
}

void BeliefBase::erase(Relation& rel, std::int64_t seq) {
  make_own(rel);
  no_percept_any_more(rel, rel.own_row(seq));
  rel.erase(seq);
  with_holes_.push_back(&rel);
}

// Takes annotations away; the belief goes when no source is left.
bool BeliefBase::remove_annotations(Relation& rel, std::int64_t seq, Value annots, bool exact) {
  const Value known = literal_parts(rel.row(seq).fact).annots;
  if (annots.same_as(source_self()) && annots.same_as(known)) {
    erase(rel, seq);
    return true;
  }
  std::vector<Value> kept;
  std::size_t removed = 0;
  for (Value o = known; o.is_pair(); o = o.pair()->tail) {
    bool goes = false;
    for (Value a = deref(annots); a.is_pair() && !goes; a = deref(a.pair()->tail)) {
      goes = equal_terms(a.pair()->head, o.pair()->head);
    }
    if (goes) {
      ++removed;
    } else {
      kept.push_back(o.pair()->head);
    }
  }
  if (exact) {
    std::size_t wanted = 0;
    for (Value a = deref(annots); a.is_pair(); a = deref(a.pair()->tail)) ++wanted;
    if (removed < wanted) return false;
  }
  const Value rest = heap_.list(kept);
  if (!has_source(rest)) {
    erase(rel, seq);
    return true;
  }
  make_own(rel);
  Row& row = rel.own_row(seq);
  if (!has_percept_source(rest)) no_percept_any_more(rel, row);
  row.fact = with_annotations(heap_, row.fact, rest);
  heap_.protect();
  return exact && removed > 0;
}

bool BeliefBase::remove(Value literal, Unifier& unifier) {
  const LiteralParts parts = literal_parts(literal);
  Relation* const rel = find(parts.predicate);
  if (rel == nullptr) return false;
  const auto known = rel->find(parts.args);
  if (known && remove_annotations(*rel, *known, parts.annots, true)) return true;
  return !is_ground(literal) && remove_like(literal, unifier);
}

namespace {

// Whether `annots` have a source that is not among those given.
bool has_other_source(Value annots, Value given) {
  for (Value a = deref(annots); a.is_pair(); a = deref(a.pair()->tail)) {
    const Value annot = deref(a.pair()->head);
    if (!is_form(annot, Form::literal) || predicate_of(annot) != predicates::source) continue;
    bool is_given = false;
    for (Value g = deref(given); g.is_pair() && !is_given; g = deref(g.pair()->tail)) {
      is_given = equal_terms(g.pair()->head, annot);
    }
    if (!is_given) return true;
  }
  return false;
}

}  // namespace

bool BeliefBase::remove_like(Value literal, Unifier& unifier) {
  const LiteralParts parts = literal_parts(literal);
  Relation* const rel = find(parts.predicate);
  if (rel == nullptr) return false;
  const std::size_t trail = unifier.mark();
  Relation::Cursor cursor = rel->open(parts.args);
  std::int64_t seq = 0;
  while (const Row* row = rel->advance(cursor, seq, parts.args.data())) {
    if (row->rule != nullptr) {
      ScratchSlots slots(unifier, row->rule->slot_count);
      const Value head = unifier.instantiate(row->rule->head, slots.data());
      if (!unifier.unify(literal, head)) continue;
      const bool goes = !has_other_source(literal_parts(head).annots, unifier.apply(parts.annots));
      if (goes) erase(*rel, seq);
      if (!goes) unifier.undo(trail);
      return goes;
    }
    if (!unifier.unify(literal, row->fact)) continue;
    if (remove_annotations(*rel, seq, unifier.apply(parts.annots), false)) return true;
    unifier.undo(trail);
    return false;
  }
  return false;
}

void BeliefBase::set_namespace_property(NamespaceProperty property) {
  for (NamespaceProperty& known : namespace_properties_) {
    if (known.ns == property.ns && known.key.same_as(property.key)) {
      known.value = property.value;
      return;
    }
  }
  namespace_properties_.push_back(property);
}

void BeliefBase::compact() {
  for (Relation* const rel : with_holes_) rel->compact();
  with_holes_.clear();
}

std::size_t BeliefBase::bytes() const {
  std::size_t bytes = grown_bytes(namespace_properties_.size(), sizeof(NamespaceProperty));
  for (const Relation* const relation : relations_) bytes += relation->bytes();
  return bytes;
}

}  // namespace jaywalk

#include "interpreter/logic/belief_base.h"

#include <algorithm>
#include <bit>

#include "interpreter/term/compare.h"

namespace jaywalk {
namespace {

constexpr std::uint64_t mix(std::uint64_t word) {
  word = (word ^ word >> 31U) * 0x9E3779B97F4A7C15U;
  return (word ^ word >> 29U) | 1U;
}

// 0 if the arguments are not ground.
std::uint64_t hash_args(std::span<const Value> args) {
  std::uint64_t hash = 0x9E3779B9;
  for (const Value arg : args) {
    const std::uint64_t part = hash_term(arg);
    if (part == 0) return 0;
    hash = mix(hash * 31 + part);
  }
  return hash | 1U;
}

bool equal_args(std::span<const Value> a, std::span<const Value> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].same_as(b[i]) && !equal_terms(a[i], b[i])) return false;
  }
  return true;
}

bool has_percept_source(Value annots) {
  const Value percept = source_percept().pair()->head;
  for (annots = deref(annots); annots.is_pair(); annots = deref(annots.pair()->tail)) {
    const Value annot = deref(annots.pair()->head);
    if (annot.same_as(percept) || equal_terms(annot, percept)) return true;
  }
  return false;
}

}  // namespace

std::uint64_t argument_key(Value argument) {
  argument = deref(argument);
  switch (argument.kind()) {
    case Value::Kind::number:
      return mix(std::bit_cast<std::uint64_t>(argument.as_number() + 0.0));
    case Value::Kind::atom:
      return mix(static_cast<std::uint64_t>(argument.atom_id()) << 3U | 2U);
    case Value::Kind::text:
      return mix(std::hash<std::string_view>{}(argument.text()->view()));
    case Value::Kind::pair:
      return 3;
    case Value::Kind::special:
      return argument.is_empty_list() ? 5 : 0;
    case Value::Kind::structure: {
      const Structure& s = *argument.structure();
      if (s.form() != Form::literal) return 0;
      // An atom with annotations still unifies with the bare atom.
      const auto id = static_cast<std::uint64_t>(s.predicate());
      return mix(s.arity == 0 ? id << 3U | 2U : id << 3U | 4U);
    }
    default:
      return 0;
  }
}

Relation::Cursor Relation::open(std::span<const Value> args) {
  Cursor cursor;
  cursor.next = end_seq();
  if (args.empty()) return cursor;
  cursor.key = argument_key(args[0]);
  if (rows_.size() <= kUnindexedRows) return cursor;
  static const std::vector<std::int64_t> kNone;
  std::size_t best = static_cast<std::size_t>(-1);
  for (std::size_t i = 0; i < args.size(); ++i) {
    const std::uint64_t key = i == 0 ? cursor.key : argument_key(args[i]);
    if (key == 0) continue;
    const ArgumentIndex& index = index_of(i);
    const auto found = index.rows.find(key);
    const std::vector<std::int64_t>& listed = found == index.rows.end() ? kNone : found->second;
    const std::size_t count = listed.size() + index.wild.size();
    if (count >= best) continue;
    best = count;
    cursor.indexed = true;
    cursor.listed = &listed;
    cursor.wild = &index.wild;
    cursor.listed_left = listed.size();
    cursor.wild_left = index.wild.size();
    if (count <= 1) break;
  }
  return cursor;
}

const Row* Relation::advance(Cursor& cursor, std::int64_t& seq) const {
  for (;;) {
    if (cursor.indexed) {
      const std::int64_t listed =
          cursor.listed_left > 0 ? (*cursor.listed)[cursor.listed_left - 1] : INT64_MIN;
      const std::int64_t wild =
          cursor.wild_left > 0 ? (*cursor.wild)[cursor.wild_left - 1] : INT64_MIN;
      if (listed == INT64_MIN && wild == INT64_MIN) return nullptr;
      seq = std::max(listed, wild);
      --(listed > wild ? cursor.listed_left : cursor.wild_left);
    } else {
      if (cursor.next <= first_seq_) return nullptr;
      seq = --cursor.next;
    }
    const Row& candidate = row(seq);
    if (candidate.is_hole()) continue;
    if (candidate.key != 0 && cursor.key != 0 && candidate.key != cursor.key) continue;
    return &candidate;
  }
}

Relation::ArgumentIndex& Relation::index_of(std::size_t argument) {
  if (indexes_.size() <= argument) indexes_.resize(argument + 1);
  if (indexes_[argument] == nullptr) {
    indexes_[argument] = std::make_unique<ArgumentIndex>();
    for (std::int64_t seq = first_seq_; seq < end_seq(); ++seq) {
      const Row& r = row(seq);
      if (r.is_hole()) continue;
      const Value literal = r.rule != nullptr ? r.rule->head : r.fact;
      const std::uint64_t key = argument_key(literal.structure()->arg(argument));
      (key == 0 ? indexes_[argument]->wild : indexes_[argument]->rows[key]).push_back(seq);
    }
  }
  return *indexes_[argument];
}

void Relation::insert_in_indexes(std::int64_t seq, bool at_back) {
  const Row& r = row(seq);
  const Value literal = r.rule != nullptr ? r.rule->head : r.fact;
  if (facts_ != nullptr && r.rule == nullptr) {
    facts_->emplace(hash_args(literal_parts(literal).args), seq);
  }
  for (std::size_t i = 0; i < indexes_.size(); ++i) {
    if (indexes_[i] == nullptr) continue;
    const std::uint64_t key = argument_key(literal.structure()->arg(i));
    auto& list = key == 0 ? indexes_[i]->wild : indexes_[i]->rows[key];
    list.insert(at_back ? list.begin() : list.end(), seq);
  }
}

std::int64_t Relation::add_front(Row added) {
  if (added.rule != nullptr) rules_.push_back(added.rule);
  rows_.push_back(added);
  insert_in_indexes(end_seq() - 1, false);
  return end_seq() - 1;
}

std::int64_t Relation::add_back(Row added) {
  if (added.rule != nullptr) rules_.push_back(added.rule);
  rows_.push_front(added);
  --first_seq_;
  insert_in_indexes(first_seq_, true);
  return first_seq_;
}

void Relation::erase(std::int64_t seq) {
  Row& r = row(seq);
  if (facts_ != nullptr && r.rule == nullptr) {
    const auto [first, last] = facts_->equal_range(hash_args(literal_parts(r.fact).args));
    const auto found = std::find_if(first, last, [&](const auto& e) { return e.second == seq; });
    if (found != last) facts_->erase(found);
  }
  if (!indexes_.empty()) erased_.emplace_back(seq, r.rule != nullptr ? r.rule->head : r.fact);
  if (r.rule != nullptr) std::erase(rules_, r.rule);
  r = Row{};
  ++holes_;
}

std::optional<std::int64_t> Relation::find(std::span<const Value> args) {
  if (args.empty() || rows_.size() <= kUnindexedRows) {
    const std::uint64_t key = args.empty() ? 0 : argument_key(args[0]);
    for (std::int64_t seq = end_seq() - 1; seq >= first_seq_; --seq) {
      const Row& r = row(seq);
      if (r.fact.is_unset() || (key != 0 && r.key != key)) continue;
      if (equal_args(args, literal_parts(r.fact).args)) return seq;
    }
    return std::nullopt;
  }
  if (facts_ == nullptr) {
    facts_ = std::make_unique<std::unordered_multimap<std::uint64_t, std::int64_t>>();
    for (std::int64_t seq = first_seq_; seq < end_seq(); ++seq) {
      const Row& r = row(seq);
      if (!r.fact.is_unset()) facts_->emplace(hash_args(literal_parts(r.fact).args), seq);
    }
  }
  const auto [first, last] = facts_->equal_range(hash_args(args));
  for (auto entry = first; entry != last; ++entry) {
    if (equal_args(args, literal_parts(row(entry->second).fact).args)) return entry->second;
  }
  return std::nullopt;
}

// Takes the erased rows out of the indexes: their numbers may be given to other rows.
void Relation::forget_erased() {
  for (const auto& [seq, literal] : erased_) {
    for (std::size_t i = 0; i < indexes_.size(); ++i) {
      if (indexes_[i] == nullptr) continue;
      const std::uint64_t key = argument_key(literal.structure()->arg(i));
      auto& list = key == 0 ? indexes_[i]->wild : indexes_[i]->rows[key];
      const auto found = std::lower_bound(list.begin(), list.end(), seq);
      if (found != list.end() && *found == seq) list.erase(found);
      if (key != 0 && list.empty()) indexes_[i]->rows.erase(key);
    }
  }
  erased_.clear();
}

void Relation::compact() {
  while (!rows_.empty() && rows_.front().is_hole()) {
    rows_.pop_front();
    ++first_seq_;
    --holes_;
  }
  while (!rows_.empty() && rows_.back().is_hole()) {
    rows_.pop_back();
    --holes_;
  }
  // Indexes name rows by number: holes inside are worth closing only when they prevail.
  if (holes_ * 2 <= rows_.size()) {
    forget_erased();
    return;
  }
  std::erase_if(rows_, [](const Row& r) { return r.is_hole(); });
  holes_ = 0;
  facts_.reset();
  indexes_.clear();
  erased_.clear();
}

Relation& BeliefBase::relation(Predicate predicate) {
  Relation*& known = by_predicate_[predicate];
  if (known == nullptr) {
    relations_.push_back(std::make_unique<Relation>(predicate));
    known = relations_.back().get();
  }
  return *known;
}

Relation* BeliefBase::find(Predicate predicate) {
  const auto found = by_predicate_.find(predicate);
  return found == by_predicate_.end() ? nullptr : found->second;
}

const Relation* BeliefBase::find(Predicate predicate) const {
  const auto found = by_predicate_.find(predicate);
  return found == by_predicate_.end() ? nullptr : found->second;
}

std::optional<Value> BeliefBase::add(Value literal, Place place) {
  const LiteralParts parts = literal_parts(literal);
  Relation& rel = relation(parts.predicate);
  const std::optional<std::int64_t> known = rel.find(parts.args);
  if (!known) {
    const Row row{.fact = literal, .key = parts.args.empty() ? 0 : argument_key(parts.args[0])};
    place == Place::front ? rel.add_front(row) : rel.add_back(row);
    heap_.protect();
    return literal;
  }
  Row& row = rel.row(*known);
  const Value old = literal_parts(row.fact).annots;
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
  row.fact = with_annotations(heap_, row.fact, union_of(heap_, old, added, symbols_));
  heap_.protect();
  return with_annotations(heap_, literal, added);
}

void BeliefBase::add_rule(const RuleCode& rule, Place place) {
  const LiteralParts head = literal_parts(rule.head);
  Relation& rel = relation(head.predicate);
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
  rel.erase(seq);
  with_holes_.push_back(&rel);
}

// Takes annotations away; the belief goes when no source is left.
bool BeliefBase::remove_annotations(Relation& rel, std::int64_t seq, Value annots, bool exact) {
  Row& row = rel.row(seq);
  std::vector<Value> kept;
  std::size_t removed = 0;
  for (Value o = literal_parts(row.fact).annots; o.is_pair(); o = o.pair()->tail) {
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
  if (has_source(rest)) {
    if (!has_percept_source(rest)) row.percept_generation = 0;
    row.fact = with_annotations(heap_, row.fact, rest);
    heap_.protect();
    return exact && removed > 0;
  }
  erase(rel, seq);
  return true;
}

bool BeliefBase::remove(Value literal, Unifier& unifier) {
  const LiteralParts parts = literal_parts(literal);
  Relation* const rel = find(parts.predicate);
  if (rel == nullptr) return false;
  if (const auto known = rel->find(parts.args)) {
    return remove_annotations(*rel, *known, parts.annots, true);
  }
  if (is_ground(literal)) return false;
  Relation::Cursor cursor = rel->open(parts.args);
  std::int64_t seq = 0;
  while (const Row* row = rel->advance(cursor, seq)) {
    if (row->rule != nullptr) {
      ScratchSlots slots(unifier, row->rule->slot_count);
      const Value head = unifier.instantiate(row->rule->head, slots.data());
      if (!unifier.unify(literal, head)) continue;
      erase(*rel, seq);
      return true;
    }
    if (unifier.unify(literal, row->fact)) {
      return remove_annotations(*rel, seq, unifier.apply(literal_parts(literal).annots), false);
    }
  }
  return false;
}

bool BeliefBase::perceive(Predicate predicate, std::span<const Value> args, PerceptChange& change) {
  Relation& rel = relation(predicate);
  if (const auto known = rel.find(args)) {
    Row& row = rel.row(*known);
    const bool perceived = row.percept_generation != 0;
    row.percept_generation = generation_;
    if (perceived) return false;
    const Value annots =
        union_of(heap_, literal_parts(row.fact).annots, source_percept(), symbols_);
    row.fact = with_annotations(heap_, row.fact, annots);
    change = {with_annotations(heap_, row.fact, source_percept()), true};
  } else {
    const Value literal = heap_.structure(predicate, args, source_percept());
    rel.add_front({.fact = literal,
                   .rule = nullptr,
                   .key = args.empty() ? 0 : argument_key(args[0]),
                   .percept_generation = generation_});
    change = {literal, true};
  }
  if (!rel.has_percepts) {
    rel.has_percepts = true;
    perceived_.push_back(&rel);
  }
  return true;
}

void BeliefBase::end_percepts(std::vector<PerceptChange>& changes) {
  std::erase_if(perceived_, [&](Relation* rel) {
    rel->has_percepts = false;
    for (std::int64_t seq = rel->first_seq(); seq < rel->end_seq(); ++seq) {
      Row& row = rel->row(seq);
      if (row.percept_generation == 0) continue;
      if (row.percept_generation == generation_) {
        rel->has_percepts = true;
        continue;
      }
      row.percept_generation = 0;
      changes.push_back({with_annotations(heap_, row.fact, source_percept()), false});
      remove_annotations(*rel, seq, source_percept(), false);
    }
    return !rel->has_percepts;
  });
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

}  // namespace jaywalk

#include "interpreter/logic/beliefs/belief_base.h"

#include <algorithm>

#include "interpreter/support/grown_bytes.h"
#include "interpreter/term/compare.h"

namespace jaywalk {
namespace {

// Not 0. What is not ground counts as one and the same.
Relation::Hash hash_args(std::span<const Value> args) {
  std::uint64_t hash = 0x9E3779B9;
  for (const Value arg : args) {
    const Value value = deref(arg);
    const bool is_simple = value.is_number() || value.is_atom();
    hash = (hash ^ hash >> 29U) + (is_simple ? argument_key(value) : hash_term(value));
    hash *= 0x9E3779B97F4A7C15U;
  }
  return mix_key(hash);
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

// Numbers and atoms are equal if their bits are; what else is equal to them has other bits.
RowIndex::Bits telling_bits(Value value) {
  value = deref(value);
  if (value.is_number()) return Value::number(value.as_number() + 0.0).bits();
  return value.is_atom() ? value.bits() : RowIndex::kVarious;
}

}  // namespace

std::optional<std::size_t> Relation::count(std::size_t argument, Value value) {
  value = deref(value);
  const RowIndex::Bits bits = telling_bits(value);
  if (rules_ > 0 || rows_->size() <= kUnindexedRows || bits == RowIndex::kVarious) {
    return std::nullopt;
  }
  const RowIndex& index = index_of(argument);
  return index.count(0) == 0 ? index.count(argument_key(value), bits) : std::nullopt;
}

std::uint32_t argument_key_of_cell(Value argument) {
  if (argument.is_text()) return mix_key(std::hash<std::string_view>{}(argument.text()->view()));
  if (!is_form(argument, Form::literal)) return 0;
  // An atom with annotations still unifies with the bare atom.
  const Structure& s = *argument.structure();
  const auto id = static_cast<std::uint64_t>(s.predicate());
  return mix_key(s.arity == 0 ? id << 3U | 2U : id << 3U | 4U);
}

// By the bound argument that fewest rows share.
void Relation::open_indexed(Cursor& cursor, std::span<const Value> args) {
  std::size_t best = static_cast<std::size_t>(-1);
  for (std::size_t i = 0; i < args.size(); ++i) {
    const std::uint32_t key = i == 0 ? cursor.key : argument_key(args[i]);
    if (key == 0) continue;
    RowIndex& index = index_of(i);
    const std::size_t count = index.count(key) + index.count(0);
    if (count >= best) continue;
    best = count;
    cursor.index = &index;
    cursor.key = key;
    if (count <= 1) break;
  }
  if (cursor.index == nullptr) return;
  cursor.same = older(*cursor.index, cursor.key, RowIndex::kNone);
  cursor.wild = older(*cursor.index, 0, RowIndex::kNone);
  cursor.seq = std::max(cursor.same, cursor.wild);
}

void Relation::move_on_indexed(Cursor& cursor) const {
  if (cursor.seq == cursor.same) {
    cursor.same = older(*cursor.index, cursor.key, cursor.same);
  } else {
    cursor.wild = older(*cursor.index, 0, cursor.wild);
  }
  cursor.seq = std::max(cursor.same, cursor.wild);
}

// The next row of a key below `seq` (kNone: the newest) that is no hole. The holes on the way are
// taken out of the chain, so that each is met once.
std::int64_t Relation::older(RowIndex& index, std::uint32_t key, std::int64_t seq) const {
  const std::int64_t next = seq == RowIndex::kNone ? index.newest(key) : index.older(seq);
  std::int64_t found = next;
  while (found >= first_seq_ && row(found).is_hole()) found = index.older(found);
  if (found < first_seq_) found = RowIndex::kNone;
  // A walk that began when the rows were shared goes on in their index, which stays as it is.
  const bool is_own = indexes_ != nullptr && indexes_->has(index);
  if (found != next && next >= first_seq_ && is_own) index.skip(key, seq, found);
  return found;
}

std::unique_ptr<HashIndex> make_fact_index(const Ring<Row>& rows, std::int64_t first) {
  auto index = std::make_unique<HashIndex>(first);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Value fact = rows[i].fact;
    if (fact.is_unset()) continue;
    index->add(hash_args(literal_parts(fact).args), first + static_cast<std::int64_t>(i));
  }
  return index;
}

std::unique_ptr<RowIndex> make_row_index(const Ring<Row>& rows, std::int64_t first,
                                         std::size_t argument) {
  auto index = std::make_unique<RowIndex>(first);
  for (const Row& row : rows) {
    if (row.is_hole()) {
      index->add_newest(RowIndex::kHoleKey);
    } else {
      const Value value = row.literal().structure()->arg(argument);
      index->add_newest(argument_key(value), telling_bits(value));
    }
  }
  return index;
}

HashIndex& Relation::facts() {
  if (shared_ != nullptr) return shared_->facts();
  if (indexes_ == nullptr) indexes_ = std::make_unique<Indexes>();
  if (indexes_->facts == nullptr) indexes_->facts = make_fact_index(own_, first_seq_);
  return *indexes_->facts;
}

RowIndex& Relation::index_of(std::size_t argument) {
  if (shared_ != nullptr) return shared_->index_of(argument);
  if (indexes_ == nullptr) indexes_ = std::make_unique<Indexes>();
  auto& arguments = indexes_->arguments;
  if (arguments.size() <= argument) arguments.resize(argument + 1);
  if (arguments[argument] == nullptr) {
    arguments[argument] = make_row_index(own_, first_seq_, argument);
  }
  return *arguments[argument];
}

void Relation::share(const SharedRows& rows) {
  shared_ = &rows;
  rows_ = &rows.rows();
  rules_ = rows.rules();
  table_ = rows.rule_table();
  first_seq_ = 0;
}

void Relation::own_rows() {
  if (shared_ == nullptr) return;
  for (const Row& row : shared_->rows()) own_.push_back(row);
  rows_ = &own_;
  shared_ = nullptr;
}

void Relation::insert_in_indexes(const Row& r, std::int64_t seq, End end, Hash hash) {
  if (indexes_->facts != nullptr && !r.fact.is_unset()) {
    indexes_->facts->add(hash != 0 ? hash : hash_args(literal_parts(r.fact).args), seq);
  }
  for (std::size_t i = 0; i < indexes_->arguments.size(); ++i) {
    RowIndex* const index = indexes_->arguments[i].get();
    if (index == nullptr) continue;
    const Value value = r.literal().structure()->arg(i);
    const std::uint32_t key = argument_key(value);
    const RowIndex::Bits bits = telling_bits(value);
    end == End::oldest ? index->add_oldest(key, bits) : index->add_newest(key, bits);
  }
}

const RuleTable* Relation::make_rule_table() {
  if (rules_ != rows_->size() || rules_ > RuleTable::kMostRules) return nullptr;
  std::vector<RuleTable::Candidate> candidates;
  for (std::int64_t seq = end_seq() - 1; seq >= first_seq_; --seq) {
    const Row& r = row(seq);
    candidates.push_back({r.key, r.rule->head_code.has_tests(), r.rule});
  }
  own_table_ = std::make_unique<RuleTable>(std::move(candidates));
  table_ = own_table_.get();
  return table_;
}

void Relation::share_rule_table(const RuleTable& table) {
  const std::span<const RuleTable::Candidate> candidates = table.candidates();
  if (table_ == &table || candidates.size() != rows_->size()) return;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (row(end_seq() - 1 - static_cast<std::int64_t>(i)).rule != candidates[i].rule) return;
  }
  forget_rule_table();
  table_ = &table;
}

std::int64_t Relation::add_front(Row added, Hash hash) {
  if (added.rule != nullptr) ++rules_;
  forget_rule_table();
  if (indexes_ != nullptr) insert_in_indexes(added, end_seq(), End::newest, hash);
  own_.push_back(added);
  return end_seq() - 1;
}

std::int64_t Relation::add_back(Row added, Hash hash) {
  if (added.rule != nullptr) ++rules_;
  forget_rule_table();
  if (indexes_ != nullptr) insert_in_indexes(added, first_seq_ - 1, End::oldest, hash);
  own_.push_front(added);
  --first_seq_;
  return first_seq_;
}

void Relation::erase(std::int64_t seq) {
  Row& r = own_row(seq);
  if (indexes_ != nullptr) {
    indexes_->visit_arguments([seq](RowIndex& index) { index.erase(seq); });
    if (indexes_->facts != nullptr && !r.fact.is_unset()) {
      indexes_->facts->erase(hash_args(literal_parts(r.fact).args), seq);
    }
  }
  if (r.rule != nullptr) --rules_;
  forget_rule_table();
  r = Row{};
  ++holes_;
}

std::optional<std::int64_t> Relation::find(std::span<const Value> args, Hash& hash) {
  if (rows_->empty()) return std::nullopt;
  if (args.empty() || rows_->size() <= kUnindexedRows) {
    const std::uint32_t key = args.empty() ? 0 : argument_key(args[0]);
    for (std::int64_t seq = end_seq() - 1; seq >= first_seq_; --seq) {
      const Row& r = row(seq);
      if (r.fact.is_unset() || (key != 0 && r.key != key)) continue;
      if (equal_args(args, literal_parts(r.fact).args)) return seq;
    }
    return std::nullopt;
  }
  HashIndex& index = facts();
  hash = hash_args(args);
  const std::int64_t seq = index.find(hash, [&](std::int64_t candidate) {
    return equal_args(args, literal_parts(row(candidate).fact).args);
  });
  return seq == HashIndex::kNone ? std::nullopt : std::optional(seq);
}

void Relation::compact() {
  // Rows of an index know the older ones by number, so there these must not be given to others.
  while (indexes_ == nullptr && !rows_->empty() && own_.front().is_hole()) {
    own_.pop_front();
    ++first_seq_;
    --holes_;
  }
  while (!rows_->empty() && own_.back().is_hole()) {
    if (indexes_ != nullptr) {
      indexes_->visit_arguments([](RowIndex& index) { index.drop_newest(); });
    }
    own_.pop_back();
    --holes_;
  }
  // Indexes name rows by number: holes inside are worth closing only when they prevail.
  if (holes_ * 2 <= rows_->size()) return;
  erase_if(own_, [](const Row& r) { return r.is_hole(); });
  holes_ = 0;
  indexes_.reset();
}

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
  relation.own_rows();
  heap_.note_beside(relation.size() * Relation::kRowBytes);
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
  if (annots.same_as(source_self()) && annots.same_as(literal_parts(rel.row(seq).fact).annots)) {
    erase(rel, seq);
    return true;
  }
  make_own(rel);
  Row& row = rel.own_row(seq);
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
    if (!has_percept_source(rest)) no_percept_any_more(rel, row);
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
  while (const Row* row = rel->advance(cursor, seq, parts.args.data())) {
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

std::size_t Relation::bytes() const {
  constexpr std::size_t kRuleBytes = 1024;
  std::size_t indexes = 0;
  if (indexes_ != nullptr) {
    indexes = indexes_->facts == nullptr ? 0 : 1;
    indexes_->visit_arguments([&](const RowIndex&) { ++indexes; });
  }
  return sizeof(Relation) + grown_bytes(own_.size(), sizeof(Row) + indexes * kIndexedRowBytes) +
         rules_owned_.size() * kRuleBytes;
}

std::size_t BeliefBase::bytes() const {
  std::size_t bytes = grown_bytes(namespace_properties_.size(), sizeof(NamespaceProperty));
  for (const Relation* const relation : relations_) bytes += relation->bytes();
  return bytes;
}

}  // namespace jaywalk

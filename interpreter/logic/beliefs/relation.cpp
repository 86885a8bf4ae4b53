// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/beliefs/relation.h"

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
  const bool is_own = is_indexed() && own_->indexes->has(index);
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

// Queries see the shared rows until own_rows() has copied them.
Relation::Own& Relation::make_own_part() {
  own_ = std::make_unique<Own>();
  if (shared_ == nullptr) rows_ = &own_->rows;
  return *own_;
}

Relation::Indexes& Relation::indexes() {
  if (own().indexes == nullptr) own_->indexes = std::make_unique<Indexes>();
  return *own_->indexes;
}

HashIndex& Relation::facts() {
  if (shared_ != nullptr) return shared_->facts();
  auto& facts = indexes().facts;
  if (facts == nullptr) facts = make_fact_index(own_->rows, first_seq_);
  return *facts;
}

RowIndex& Relation::index_of(std::size_t argument) {
  if (shared_ != nullptr) return shared_->index_of(argument);
  auto& arguments = indexes().arguments;
  if (arguments.size() <= argument) arguments.resize(argument + 1);
  if (arguments[argument] == nullptr) {
    arguments[argument] = make_row_index(own_->rows, first_seq_, argument);
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
  for (const Row& row : shared_->rows()) own().rows.push_back(row);
  rows_ = &own().rows;
  shared_ = nullptr;
}

void Relation::insert_in_indexes(const Row& r, std::int64_t seq, End end, Hash hash) {
  Indexes& all = *own_->indexes;
  if (all.facts != nullptr && !r.fact.is_unset()) {
    all.facts->add(hash != 0 ? hash : hash_args(literal_parts(r.fact).args), seq);
  }
  for (std::size_t i = 0; i < all.arguments.size(); ++i) {
    RowIndex* const index = all.arguments[i].get();
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
  own().table = std::make_unique<RuleTable>(std::move(candidates));
  table_ = own_->table.get();
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
  if (is_indexed()) insert_in_indexes(added, end_seq(), End::newest, hash);
  own().rows.push_back(added);
  return end_seq() - 1;
}

std::int64_t Relation::add_back(Row added, Hash hash) {
  if (added.rule != nullptr) ++rules_;
  forget_rule_table();
  if (is_indexed()) insert_in_indexes(added, first_seq_ - 1, End::oldest, hash);
  own().rows.push_front(added);
  --first_seq_;
  return first_seq_;
}

void Relation::erase(std::int64_t seq) {
  Row& r = own_row(seq);
  if (is_indexed()) {
    own_->indexes->visit_arguments([seq](RowIndex& index) { index.erase(seq); });
    if (own_->indexes->facts != nullptr && !r.fact.is_unset()) {
      own_->indexes->facts->erase(hash_args(literal_parts(r.fact).args), seq);
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
  if (holes_ == 0) return;
  Ring<Row>& rows = own_->rows;
  std::unique_ptr<Indexes>& indexes = own_->indexes;
  // Rows of an index know the older ones by number, so there these must not be given to others.
  while (indexes == nullptr && !rows.empty() && rows.front().is_hole()) {
    rows.pop_front();
    ++first_seq_;
    --holes_;
  }
  while (!rows.empty() && rows.back().is_hole()) {
    if (indexes != nullptr) {
      indexes->visit_arguments([](RowIndex& index) { index.drop_newest(); });
    }
    rows.pop_back();
    --holes_;
  }
  // Indexes name rows by number: holes inside are worth closing only when they prevail.
  if (std::size_t{holes_} * 2 <= rows.size()) return;
  erase_if(rows, [](const Row& r) { return r.is_hole(); });
  holes_ = 0;
  indexes.reset();
}

std::size_t Relation::bytes() const {
  constexpr std::size_t kRuleBytes = 1024;
  if (own_ == nullptr) return sizeof(Relation);
  std::size_t indexes = 0;
  if (own_->indexes != nullptr) {
    indexes = own_->indexes->facts == nullptr ? 0 : 1;
    own_->indexes->visit_arguments([&](const RowIndex&) { ++indexes; });
  }
  return sizeof(Relation) + sizeof(Own) +
         grown_bytes(own_->rows.size(), sizeof(Row) + indexes * kIndexedRowBytes) +
         own_->rules.size() * kRuleBytes;
}

}  // namespace jaywalk

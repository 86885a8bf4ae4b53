// SPDX-License-Identifier: Apache-2.0
#pragma once

// An agent's beliefs of one predicate: facts and rules, in Jason's observable order.
//
//   rows:   [ oldest at the end of the order ... newest, asked first ]
//   seq:      first_seq                          first_seq + size - 1
//
// New beliefs are asked first, so a query walks the rows from the last to the first. Removed rows
// leave holes, which are closed when no query runs (compact). Relations with more than a few rows
// get hash indexes, each built when first needed: one over whole facts (hash_index.h, to add and
// remove), one for each argument that is bound in some query (row_index.h). What a program begins
// with its agents share, rows and indexes, until they change something of it (shared_rows.h): such
// a relation has nothing of its own.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/logic/beliefs/row.h"
#include "interpreter/logic/beliefs/row_index.h"
#include "interpreter/logic/beliefs/rule_table.h"
#include "interpreter/logic/beliefs/shared_rows.h"
#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/support/containers/hash_index.h"
#include "interpreter/support/containers/lazy.h"

namespace jaywalk {

class Relation {
 public:
  explicit Relation(Predicate predicate) : predicate_(predicate) {}

  [[nodiscard]] Predicate predicate() const { return predicate_; }
  [[nodiscard]] std::size_t size() const { return rows_->size() - holes_; }
  [[nodiscard]] bool has_rules() const { return rules_ > 0; }
  [[nodiscard]] std::int64_t first_seq() const { return first_seq_; }
  [[nodiscard]] std::int64_t end_seq() const {
    return first_seq_ + static_cast<std::int64_t>(rows_->size());
  }
  [[nodiscard]] const Row& row(std::int64_t seq) const {
    return (*rows_)[static_cast<std::size_t>(seq - first_seq_)];
  }
  /// A row that may be changed. REQUIRES: the rows are its own.
  [[nodiscard]] Row& own_row(std::int64_t seq) {
    return own_->rows[static_cast<std::size_t>(seq - first_seq_)];
  }

  /// Its rows are not its own, but the agents' of a program or system.
  [[nodiscard]] bool is_shared() const { return shared_ != nullptr; }
  [[nodiscard]] const SharedRows* shared() const { return shared_; }
  /// REQUIRES: it has no rows; the shared ones outlive it.
  void share(const SharedRows& rows);
  /// They become its own, to be changed, with the same numbers.
  void own_rows();

  /// A walk over the rows that may match arguments, newest first. Rows added after its start are
  /// not seen; removed ones are skipped.
  class Cursor {
   public:
    /// Rows are left, as far as none of them is removed before it is its turn.
    [[nodiscard]] bool has_more() const { return seq != RowIndex::kNone; }

   private:
    friend class Relation;
    std::int64_t seq = RowIndex::kNone;   // the candidate whose turn it is
    std::uint32_t key = 0;                // of the first argument; with an index, of its argument
    RowIndex* index = nullptr;            // null: all rows are looked at
    std::int64_t same = RowIndex::kNone;  // with an index: the next row of that key,
    std::int64_t wild = RowIndex::kNone;  // and the next of those that may match any key
  };
  [[nodiscard]] [[gnu::always_inline]] inline Cursor open(std::span<const Value> args);
  /// The candidate whose turn it is, or null at the end. `seq` receives its place. Rules that
  /// cannot match the arguments (null: any), and facts that evidently do not, are no candidates.
  [[nodiscard]] [[gnu::always_inline]] const Row* advance(Cursor& cursor, std::int64_t& seq,
                                                          const Value* args) const {
    while (cursor.seq != RowIndex::kNone) {
      seq = cursor.seq;
      move_on(cursor, args);
      const Row& candidate = row(seq);
      if (!candidate.is_hole()) return &candidate;
    }
    return nullptr;
  }

  /// The only row, if it is a fact; else null.
  [[nodiscard]] const Row* lone_fact() const {
    return rows_->size() == 1 && holes_ == 0 && rules_ == 0 ? &rows_->front() : nullptr;
  }
  [[nodiscard]] bool is_indexed() const { return own_ != nullptr && own_->indexes != nullptr; }
  [[nodiscard]] bool has_few_facts() const {
    return rules_ == 0 && rows_->size() <= kUnindexedRows;
  }
  /// All rows, newest first, if they are a few rules and nothing else; else null.
  [[nodiscard]] const RuleTable* rule_table() {
    return table_ != nullptr || rules_ == 0 ? table_ : make_rule_table();
  }
  /// Uses a table that was made for the rules of a program, if the rows are these rules.
  void share_rule_table(const RuleTable& table);
  /// Takes the table of its rules with their answers, or again the one without.
  /// REQUIRES: the rows are shared.
  void fold(const RuleTable& table) {
    table_ = &table;
    is_folded_ = true;
  }
  void unfold() {
    table_ = shared_->rule_table();
    is_folded_ = false;
  }
  /// The table has answers.
  [[nodiscard]] bool is_folded() const { return is_folded_; }
  /// A cursor whose next candidate is a rule.
  [[nodiscard]] static Cursor cursor_at(std::int64_t seq, std::uint32_t key) {
    Cursor cursor;
    cursor.seq = seq;
    cursor.key = key;
    return cursor;
  }

  /// The hash that find() computed, to be passed on to add_*(); 0 if unknown.
  using Hash = std::uint32_t;
  std::int64_t add_front(Row row, Hash hash = 0);  // asked first
  std::int64_t add_back(Row row, Hash hash = 0);   // asked last
  void erase(std::int64_t seq);
  /// The fact with the same arguments, annotations ignored.
  [[nodiscard]] std::optional<std::int64_t> find(std::span<const Value> args, Hash& hash);
  [[nodiscard]] std::optional<std::int64_t> find(std::span<const Value> args) {
    Hash hash = 0;
    return find(args, hash);
  }
  /// How many facts have this value as an argument, if that is known without a look at each. A
  /// relation of facts alone may know it of numbers and atoms.
  [[nodiscard]] std::optional<std::size_t> count(std::size_t argument, Value value);
  void compact();
  /// Kept by belief update (belief_update.cpp).
  struct Percepts {
    std::uint32_t rows = 0;  // that are percepts
    /// When the relation last went from no percepts to some, counted over all relations; 0: it is
    /// not in BeliefBase::perceived_.
    std::uint64_t since = 0;
  };
  /// REQUIRES: it has had rows of its own.
  [[nodiscard]] Percepts& percepts() { return own_->percepts; }

  /// It is among the belief base's relations; otherwise it only keeps its memory.
  bool exists = false;
  /// Answers of rules hold only as long as its rows are the shared ones.
  bool is_folded_in = false;
  /// Memory without terms, roughly.
  [[nodiscard]] std::size_t bytes() const;
  /// The memory of a row and its place in an index, including old and new memory while they grow.
  static constexpr std::size_t kIndexedRowBytes = 24;
  static constexpr std::size_t kRowBytes = 2 * (sizeof(Row) + kIndexedRowBytes);
  /// Becomes as new but for memory for a few rows.
  void reset();

  void own_rule(std::unique_ptr<RuleCode> rule) { own().rules.push_back(std::move(rule)); }
  template <class Visit>
  void visit_terms(Visit&& visit) {
    if (own_ == nullptr) return;
    for (Row& row : own_->rows) visit(row.fact);
    for (auto& rule : own_->rules) rule->visit_terms(visit);
  }

 private:
  static constexpr std::size_t kUnindexedRows = RuleTable::kMostRules;
  struct Indexes {
    std::unique_ptr<HashIndex> facts;
    std::vector<std::unique_ptr<RowIndex>> arguments;
    [[nodiscard]] bool has(const RowIndex& index) const {
      return std::any_of(arguments.begin(), arguments.end(),
                         [&](const auto& each) { return each.get() == &index; });
    }
    template <class Visit>
    void visit_arguments(Visit visit_index) {
      for (const auto& index : arguments) {
        if (index != nullptr) visit_index(*index);
      }
    }
  };

  // Allocated with the first row, rule or index that the relation does not share.
  struct Own {
    Ring<Row> rows;
    std::unique_ptr<Indexes> indexes;
    std::unique_ptr<RuleTable> table;
    LazyContainer<std::vector<std::unique_ptr<RuleCode>>> rules;
    Percepts percepts;
  };
  inline static const Ring<Row> kNoRows;

  [[nodiscard]] Own& own() { return own_ != nullptr ? *own_ : make_own_part(); }
  Own& make_own_part();
  [[nodiscard]] Indexes& indexes();
  void open_indexed(Cursor& cursor, std::span<const Value> args);
  [[gnu::always_inline]] void move_on(Cursor& cursor, const Value* args) const {
    if (cursor.index == nullptr) {
      cursor.seq = next_unindexed(cursor.seq, cursor.key, args);
    } else {
      move_on_indexed(cursor);
    }
  }
  // The next candidate below a row.
  [[nodiscard]] [[gnu::always_inline]] std::int64_t next_unindexed(std::int64_t seq,
                                                                   std::uint32_t key,
                                                                   const Value* args) const {
    while (--seq >= first_seq_) {
      const Row& candidate = row(seq);
      if (candidate.key != 0 && key != 0 && candidate.key != key) continue;
      if (candidate.rule != nullptr ? args == nullptr || !candidate.rule->head_code.rejects(args)
                                    : may_match(candidate.fact, args)) {
        return seq;
      }
    }
    return RowIndex::kNone;
  }
  // Whether a fact may match, by the arguments after the first.
  [[nodiscard]] [[gnu::always_inline]] static bool may_match(Value fact, const Value* args) {
    if (!fact.is_structure() || args == nullptr) return !fact.is_unset();
    const std::span<const Value> known = fact.structure()->arg_span();
    for (std::size_t i = 1; i < known.size(); ++i) {
      if (evidently_differ(deref(args[i]), known[i])) return false;
    }
    return true;
  }
  void move_on_indexed(Cursor& cursor) const;
  [[nodiscard]] std::int64_t older(RowIndex& index, std::uint32_t key, std::int64_t seq) const;
  [[nodiscard]] const RuleTable* make_rule_table();
  void forget_rule_table() {
    table_ = nullptr;
    if (own_ != nullptr) own_->table.reset();
  }
  [[nodiscard]] HashIndex& facts();
  [[nodiscard]] RowIndex& index_of(std::size_t argument);
  enum class End { newest, oldest };
  void insert_in_indexes(const Row& row, std::int64_t seq, End end, Hash hash);

  bool is_folded_ = false;  // whether table_ has answers; each query reads it
  Predicate predicate_;
  std::uint32_t rules_ = 0;
  std::uint32_t holes_ = 0;
  const Ring<Row>* rows_ = &kNoRows;
  const SharedRows* shared_ = nullptr;  // null: the rows are its own
  std::int64_t first_seq_ = 0;
  const RuleTable* table_ = nullptr;  // null: there is none, or it is not made yet
  std::unique_ptr<Own> own_;
};

Relation::Cursor Relation::open(std::span<const Value> args) {
  Cursor cursor;
  if (!args.empty()) {
    cursor.key = argument_key(args[0]);
    if (rows_->size() > kUnindexedRows) {
      open_indexed(cursor, args);
      if (cursor.index != nullptr) return cursor;
    }
  }
  cursor.seq = next_unindexed(end_seq(), cursor.key, args.data());
  return cursor;
}

}  // namespace jaywalk

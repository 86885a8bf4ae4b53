#pragma once

// What an agent believes: facts and rules, in Jason's observable order. One Relation for each
// predicate indicator.
//
//   rows:   [ oldest at the end of the order ... newest, asked first ]
//   seq:      first_seq                          first_seq + size - 1
//
// New beliefs are asked first, so a query walks the rows from the last to the first. Removed rows
// leave holes, which are closed when no query runs (compact). Relations with more than a few rows
// get hash indexes, each built when first needed: one over whole facts (hash_index.h, to add and
// remove), one for each argument that is bound in some query (row_index.h). What a program begins
// with its agents share, rows and indexes, until they change something of it (shared_rows.h).

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
#include "interpreter/support/containers/flat_index.h"
#include "interpreter/support/containers/hash_index.h"

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
  /// To be changed. REQUIRES: the rows are its own.
  [[nodiscard]] Row& own_row(std::int64_t seq) {
    return own_[static_cast<std::size_t>(seq - first_seq_)];
  }

  /// Its rows are what the agents of a program begin with, and not its own.
  [[nodiscard]] bool is_shared() const { return shared_ != nullptr; }
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
  [[nodiscard]] bool is_indexed() const { return indexes_ != nullptr; }
  [[nodiscard]] bool has_few_facts() const {
    return rules_ == 0 && rows_->size() <= kUnindexedRows;
  }
  /// All rows, newest first, if they are a few rules and nothing else; else null.
  [[nodiscard]] const RuleTable* rule_table() {
    return table_ != nullptr || rules_ == 0 ? table_ : make_rule_table();
  }
  /// The same table, made for the rules of a program. Taken if these are what the rows are.
  void share_rule_table(const RuleTable& table);
  /// A cursor whose next candidate is a rule.
  [[nodiscard]] static Cursor cursor_at(std::int64_t seq, std::uint32_t key) {
    Cursor cursor;
    cursor.seq = seq;
    cursor.key = key;
    return cursor;
  }

  /// What find() has learned of arguments, for who adds them: their hash, or 0.
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
  /// Kept by belief update (belief_update.cpp): how many rows are percepts; whether the relation is
  /// among those that have some, and since when in the order of becoming so.
  std::size_t percepts = 0;
  bool has_percepts = false;
  std::uint64_t perceived_since = 0;

  /// It is among the belief base's relations; otherwise it only keeps its memory.
  bool exists = false;
  /// Memory without terms, roughly.
  [[nodiscard]] std::size_t bytes() const;
  /// What a row of many takes with its place in an index, old and new memory while they grow.
  static constexpr std::size_t kIndexedRowBytes = 24;
  static constexpr std::size_t kRowBytes = 2 * (sizeof(Row) + kIndexedRowBytes);
  /// Becomes as new but for memory for a few rows.
  void reset();

  void own_rule(std::unique_ptr<RuleCode> rule) { rules_owned_.push_back(std::move(rule)); }
  template <class Visit>
  void visit_terms(Visit&& visit) {
    for (Row& row : own_) visit(row.fact);
    for (auto& rule : rules_owned_) rule->visit_terms(visit);
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
  // Of a row without a rule, beside the first argument.
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
    own_table_.reset();
  }
  [[nodiscard]] HashIndex& facts();
  [[nodiscard]] RowIndex& index_of(std::size_t argument);
  enum class End { newest, oldest };
  void insert_in_indexes(const Row& row, std::int64_t seq, End end, Hash hash);

  Predicate predicate_;
  std::uint32_t rules_ = 0;
  Ring<Row> own_;
  const Ring<Row>* rows_ = &own_;
  const SharedRows* shared_ = nullptr;  // null: the rows are its own
  std::int64_t first_seq_ = 0;
  std::size_t holes_ = 0;
  const RuleTable* table_ = nullptr;  // null: there is none, or it is not made yet
  std::unique_ptr<RuleTable> own_table_;
  std::vector<std::unique_ptr<RuleCode>> rules_owned_;
  std::unique_ptr<Indexes> indexes_;
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

enum class Place { front, back };

/// Something known of a namespace, `.namespace_set_prop(ns, key, Value)`.
struct NamespaceProperty {
  Symbol ns;
  Value key;
  Value value;
};

class BeliefBase {
 public:
  BeliefBase(Heap& heap, SymbolTable& symbols) : heap_(heap), symbols_(symbols) {}

  /// Memory of a destroyed belief base, for one that has not been used yet: relations without rows,
  /// which do not exist until something is believed.
  class Remains {
    friend class BeliefBase;
    std::vector<std::unique_ptr<Relation>> known_;
    FlatIndex<std::uint32_t> by_predicate_;
    std::vector<Relation*> relations_;  // these have room, and nothing in it
    std::vector<Relation*> perceived_;
  };
  /// Ends the belief base's life.
  [[nodiscard]] Remains leave_remains();
  void use(Remains remains) {
    known_ = std::move(remains.known_);
    by_predicate_ = std::move(remains.by_predicate_);
    relations_ = std::move(remains.relations_);
    perceived_ = std::move(remains.perceived_);
  }

  /// Adds a literal with its annotations. The result is what is new: the literal with the
  /// annotations that it did not have; nothing if it was believed with all of them.
  std::optional<Value> add(Value literal, Place place = Place::front);
  /// Rules are added without looking for an equal one. Static rules belong to a program.
  void add_rule(const RuleCode& rule, Place place);
  void add_rule(std::unique_ptr<RuleCode> rule, Place place);
  /// Room for so many predicates, of which something will be believed.
  void expect(std::size_t predicates) {
    known_.reserve(predicates);
    relations_.reserve(predicates);
  }
  /// Believes what the agents of a program begin with, of a predicate of which nothing is believed;
  /// false, and nothing: something is. The rows outlive the belief base.
  [[nodiscard]] bool share(Predicate predicate, const SharedRows& rows);
  /// Rules that have been added are those of a table, which outlives them.
  void share_rule_table(Predicate predicate, const RuleTable& table) {
    if (Relation* const known = find(predicate)) known->share_rule_table(table);
  }

  /// Jason's deletion. True: something changed. If the literal was not ground, `unifier` has the
  /// bindings of the belief that was found.
  bool remove(Value literal, Unifier& unifier);
  /// Removes a row whatever its sources.
  void erase(Relation& relation, std::int64_t seq);

  [[nodiscard, gnu::always_inline]] Relation* find(Predicate predicate) {
    const std::uint32_t place = by_predicate_.find(static_cast<std::uint32_t>(predicate));
    if (place == FlatIndex<std::uint32_t>::kNone) return nullptr;
    Relation* const known = known_[place].get();
    return known->exists ? known : nullptr;
  }
  [[nodiscard]] const Relation* find(Predicate predicate) const {
    return const_cast<BeliefBase*>(this)->find(predicate);
  }
  /// Relations in the order in which they came to be.
  [[nodiscard]] const std::vector<Relation*>& relations() const { return relations_; }

  // Belief update (belief_update.cpp): what was perceived and is not any more goes, what is new
  // comes.
  struct PerceptChange {
    Value literal;
    bool added = false;
  };
  void begin_percepts();
  /// A percept of the last update that has got other arguments, if it is the only belief of its
  /// predicate. False: nothing has been done.
  [[nodiscard]] bool change_percept(Predicate predicate, std::span<const Value> old_args,
                                    std::span<const Value> args);
  /// True and `change` set if it is news.
  bool perceive(Predicate predicate, std::span<const Value> args, PerceptChange& change);
  /// Removes the percepts not seen since begin_percepts.
  void end_percepts(std::vector<PerceptChange>& changes);

  /// The percepts believed are those of the last update, each perceived once. Then it is enough to
  /// perceive those that are new and to miss those that may have gone.
  [[nodiscard]] bool knows_percepts() const { return knows_percepts_; }
  void miss(Predicate predicate, std::span<const Value> args);
  /// Removes what was missed and not perceived, in the order in which end_percepts does it.
  void end_missed(std::vector<PerceptChange>& changes);

  /// Memory without terms, roughly.
  [[nodiscard]] std::size_t bytes() const;
  /// Closes the holes. REQUIRES: no cursor is in use.
  void compact();
  template <class Visit>
  void visit_terms(Visit&& visit) {
    for (Relation* const relation : relations_) relation->visit_terms(visit);
    for (NamespaceProperty& property : namespace_properties_) visit(property.value);
  }

  /// In the order in which they were first set.
  [[nodiscard]] const std::vector<NamespaceProperty>& namespace_properties() const {
    return namespace_properties_;
  }
  /// The key is an atom.
  void set_namespace_property(NamespaceProperty property);

 private:
  Relation& relation(Predicate predicate);
  void make_own(Relation& relation);
  bool remove_annotations(Relation& relation, std::int64_t seq, Value annots, bool exact);
  void no_percept_any_more(Relation& relation, Row& row);
  void remove_percept(Relation& relation, std::int64_t seq, std::vector<PerceptChange>& changes);
  [[nodiscard]] Value percept(Predicate predicate, std::span<const Value> args);

  Heap& heap_;
  SymbolTable& symbols_;
  std::vector<std::unique_ptr<Relation>> known_;
  FlatIndex<std::uint32_t> by_predicate_;  // into known_
  std::vector<Relation*> relations_;       // those that exist
  std::vector<Relation*> with_holes_;
  std::vector<Relation*> perceived_;  // in the order of perceived_since
  std::uint64_t last_perceived_ = 0;
  std::uint32_t generation_ = 0;
  bool knows_percepts_ = true;
  std::vector<std::pair<Relation*, std::int64_t>> missed_;
  std::size_t seen_again_ = 0;  // in this update, what had been perceived before
  std::vector<NamespaceProperty> namespace_properties_;
};

}  // namespace jaywalk

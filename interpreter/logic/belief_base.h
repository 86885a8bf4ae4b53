#pragma once

// What an agent believes: facts and rules, in Jason's observable order. One Relation for each
// predicate indicator.
//
//   rows:   [ oldest at the end of the order ... newest, asked first ]
//   seq:      first_seq                          first_seq + size - 1
//
// New beliefs are asked first, so a query walks the rows from the last to the first. Removed rows
// leave holes, which are closed when no query runs (compact). Relations with more than a few rows
// get hash indexes, each built when first needed: one over whole facts (to add and remove), one for
// each argument that is bound in some query.

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "interpreter/logic/code.h"
#include "interpreter/logic/unifier.h"

namespace jaywalk {

/// A number that equal bound arguments share; 0 for arguments that can only be unified.
[[nodiscard]] std::uint64_t argument_key(Value argument);

struct Row {
  /// A literal with annotations; unset in rows of rules and holes.
  Value fact;
  const RuleCode* rule = nullptr;
  /// argument_key of the first argument.
  std::uint64_t key = 0;
  /// The belief update that last saw this percept.
  std::uint32_t percept_generation = 0;

  [[nodiscard]] bool is_hole() const { return fact.is_unset() && rule == nullptr; }
};

class Relation {
 public:
  explicit Relation(Predicate predicate) : predicate_(predicate) {}

  [[nodiscard]] Predicate predicate() const { return predicate_; }
  [[nodiscard]] std::size_t size() const { return rows_.size() - holes_; }
  [[nodiscard]] bool has_rules() const { return !rules_.empty(); }
  [[nodiscard]] std::int64_t first_seq() const { return first_seq_; }
  [[nodiscard]] std::int64_t end_seq() const {
    return first_seq_ + static_cast<std::int64_t>(rows_.size());
  }
  [[nodiscard]] const Row& row(std::int64_t seq) const {
    return rows_[static_cast<std::size_t>(seq - first_seq_)];
  }
  [[nodiscard]] Row& row(std::int64_t seq) {
    return rows_[static_cast<std::size_t>(seq - first_seq_)];
  }

  /// A walk over the rows that may match arguments, newest first. Rows added after its start are
  /// not seen; removed ones are skipped.
  struct Cursor {
    std::int64_t next = 0;  // without an index: rows below this one are to come
    const std::vector<std::int64_t>* listed = nullptr;  // with an index: the rows of one key,
    const std::vector<std::int64_t>* wild = nullptr;    // and those that may match any key
    std::size_t listed_left = 0;
    std::size_t wild_left = 0;
    std::uint64_t key = 0;  // of the first argument
    bool indexed = false;
  };
  [[nodiscard]] Cursor open(std::span<const Value> args);
  /// The next candidate, or null at the end. `seq` receives its place.
  [[nodiscard]] const Row* advance(Cursor& cursor, std::int64_t& seq) const;

  std::int64_t add_front(Row row);  // asked first
  std::int64_t add_back(Row row);   // asked last
  void erase(std::int64_t seq);
  /// The fact with the same arguments, annotations ignored.
  [[nodiscard]] std::optional<std::int64_t> find(std::span<const Value> args);
  void compact();
  /// Some row was perceived; kept by the belief base.
  bool has_percepts = false;

  void own_rule(std::unique_ptr<RuleCode> rule) { rules_owned_.push_back(std::move(rule)); }
  template <class Visit>
  void visit_terms(Visit&& visit) {
    for (Row& row : rows_) visit(row.fact);
    for (auto& rule : rules_owned_) rule->visit_terms(visit);
    for (auto& [seq, literal] : erased_) visit(literal);
  }

 private:
  struct ArgumentIndex {
    std::unordered_map<std::uint64_t, std::vector<std::int64_t>> rows;  // ascending
    std::vector<std::int64_t> wild;                                     // ascending
  };
  static constexpr std::size_t kUnindexedRows = 8;

  void insert_in_indexes(std::int64_t seq, bool at_back);
  void forget_erased();
  ArgumentIndex& index_of(std::size_t argument);

  Predicate predicate_;
  std::deque<Row> rows_;
  std::int64_t first_seq_ = 0;
  std::size_t holes_ = 0;
  std::vector<const RuleCode*> rules_;
  std::vector<std::unique_ptr<RuleCode>> rules_owned_;
  std::unique_ptr<std::unordered_multimap<std::uint64_t, std::int64_t>> facts_;
  std::vector<std::unique_ptr<ArgumentIndex>> indexes_;
  // Rows erased since compact(), with their literals: the indexes still name them, since a cursor
  // may be on its way through them.
  std::vector<std::pair<std::int64_t, Value>> erased_;
};

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

  /// Adds a literal with its annotations. The result is what is new: the literal with the
  /// annotations that it did not have; nothing if it was believed with all of them.
  std::optional<Value> add(Value literal, Place place = Place::front);
  /// Rules are added without looking for an equal one. Static rules belong to a program.
  void add_rule(const RuleCode& rule, Place place);
  void add_rule(std::unique_ptr<RuleCode> rule, Place place);

  /// Jason's deletion. True: something changed. If the literal was not ground, `unifier` has the
  /// bindings of the belief that was found.
  bool remove(Value literal, Unifier& unifier);
  /// Removes a row whatever its sources.
  void erase(Relation& relation, std::int64_t seq);

  [[nodiscard]] Relation* find(Predicate predicate);
  [[nodiscard]] const Relation* find(Predicate predicate) const;
  /// Relations in the order in which they came to be.
  [[nodiscard]] const std::vector<std::unique_ptr<Relation>>& relations() const {
    return relations_;
  }

  /// Belief update: what was perceived and is not any more goes, what is new comes.
  struct PerceptChange {
    Value literal;
    bool added = false;
  };
  void begin_percepts() { ++generation_; }
  /// True and `change` set if it is news.
  bool perceive(Predicate predicate, std::span<const Value> args, PerceptChange& change);
  /// Removes the percepts not seen since begin_percepts.
  void end_percepts(std::vector<PerceptChange>& changes);

  /// Closes the holes. REQUIRES: no cursor is in use.
  void compact();
  template <class Visit>
  void visit_terms(Visit&& visit) {
    for (const auto& relation : relations_) relation->visit_terms(visit);
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
  bool remove_annotations(Relation& relation, std::int64_t seq, Value annots, bool exact);

  Heap& heap_;
  SymbolTable& symbols_;
  std::vector<std::unique_ptr<Relation>> relations_;
  std::unordered_map<Predicate, Relation*> by_predicate_;
  std::vector<Relation*> with_holes_;
  std::vector<Relation*> perceived_;
  std::uint32_t generation_ = 0;
  std::vector<NamespaceProperty> namespace_properties_;
};

}  // namespace jaywalk

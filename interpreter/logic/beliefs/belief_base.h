// SPDX-License-Identifier: Apache-2.0
#pragma once

// An agent's beliefs, in Jason's observable order: one Relation for each predicate indicator.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/logic/beliefs/relation.h"
#include "interpreter/support/containers/flat_index.h"

namespace jaywalk {

class ConstantPercepts;
struct FoldedRules;

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

  /// Adds a literal with its annotations. Returns the new part: the literal with the annotations
  /// that it did not have; nothing if it was believed with all of them.
  std::optional<Value> add(Value literal, Place place = Place::front);
  /// Rules are added without looking for an equal one. Static rules belong to a program.
  void add_rule(const RuleCode& rule, Place place);
  void add_rule(std::unique_ptr<RuleCode> rule, Place place);
  /// Reserves room for a number of predicates.
  void expect(std::size_t predicates) {
    known_.reserve(predicates);
    relations_.reserve(predicates);
  }
  /// Shares the initial beliefs of a program for a predicate without beliefs. Returns false, and
  /// does nothing, if there are some. The rows outlive the belief base.
  [[nodiscard]] bool share(Predicate predicate, const SharedRows& rows);
  /// Rules that have been added are those of a table, which outlives them.
  void share_rule_table(Predicate predicate, const RuleTable& table) {
    if (Relation* const known = find(predicate)) known->share_rule_table(table);
  }

  /// From now on queries to these rules give their stored answers, until a fact that they depend on
  /// changes. Does nothing if the agent has other facts already. The rules outlive the belief base.
  void fold(const FoldedRules& rules);

  /// Jason's deletion: first tries the fact with exactly these arguments and all annotations, then,
  /// unless the literal is ground, the first belief that unifies. True: the deletion is an event,
  /// and `unifier` has the bindings. False: nothing is bound.
  bool remove(Value literal, Unifier& unifier);
  /// Like remove(), but of the first belief or rule that unifies, even if the literal is ground.
  bool remove_like(Value literal, Unifier& unifier);
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

  // Belief update (belief_update.cpp): removes percepts that are no longer perceived, adds new
  // ones.
  struct PerceptChange {
    Value literal;
    bool added = false;
  };
  void begin_percepts();
  /// In the first update, percepts that are constant are shared. They outlive the belief base.
  /// REQUIRES: nothing has been perceived.
  void share_constants(const ConstantPercepts& constants) { constants_ = &constants; }
  /// A percept of the last update that has got other arguments, if it is the only belief of its
  /// predicate. False: nothing has been done.
  [[nodiscard]] bool change_percept(Predicate predicate, std::span<const Value> old_args,
                                    std::span<const Value> args);
  /// True and `change` set if it is news.
  bool perceive(Predicate predicate, std::span<const Value> args, PerceptChange& change,
                Value annotations = Value::empty_list());
  /// Removes the percepts not seen since begin_percepts.
  void end_percepts(std::vector<PerceptChange>& changes);

  /// The percepts believed are those of the last update, each perceived once. Then it is enough to
  /// perceive those that are new and to miss those that may have gone.
  [[nodiscard]] bool knows_percepts() const { return knows_percepts_; }
  void miss(Predicate predicate, std::span<const Value> args);
  /// Removes rows that were missed and not perceived again, in the order of end_percepts().
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
  void unfold_rules();
  [[nodiscard]] bool perceive_constant(Relation& relation, std::span<const Value> args,
                                       PerceptChange& change);
  void note_percepts(Relation& relation, std::uint32_t rows);
  bool remove_annotations(Relation& relation, std::int64_t seq, Value annots, bool exact);
  void no_percept_any_more(Relation& relation, Row& row);
  void remove_percept(Relation& relation, std::int64_t seq, std::vector<PerceptChange>& changes);
  [[nodiscard]] Value percept(Predicate predicate, std::span<const Value> args, Value annotations);
  /// Those that the environment gives, and source(percept).
  [[nodiscard]] Value percept_annotations(Value annotations);

  Heap& heap_;
  SymbolTable& symbols_;
  std::vector<std::unique_ptr<Relation>> known_;
  FlatIndex<std::uint32_t> by_predicate_;  // into known_
  std::vector<Relation*> relations_;       // those that exist
  std::vector<Relation*> with_holes_;
  std::vector<Relation*> perceived_;  // in the order of Relation::Percepts::since
  std::uint64_t last_perceived_ = 0;
  std::uint32_t generation_ = 0;
  bool knows_percepts_ = true;
  std::vector<std::pair<Relation*, std::int64_t>> missed_;
  const ConstantPercepts* constants_ = nullptr;  // of the first update
  std::size_t seen_again_ = 0;                   // in this update, what had been perceived before
  std::vector<NamespaceProperty> namespace_properties_;
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// A model of a belief base: a plain list of ground literals, newest first, with the rules of
// Jason's DefaultBeliefBase, Agent.brf and Unifier.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace jaywalk::test {

struct Term {
  enum class Kind { number, text, literal, list, variable };

  Kind kind = Kind::literal;
  /// A literal's functor (with `~`), a variable's name (unnamed ones begin with `_`), a number, a
  /// text with its quotes; empty for lists.
  std::string name;
  std::vector<Term> args;    // a literal's arguments or a list's elements
  std::vector<Term> annots;  // in Jason's order
  std::string rest;          // the variable after `|` in a list or in annotations
};

[[nodiscard]] std::string text(const Term& term);
[[nodiscard]] bool is_ground(const Term& term);
[[nodiscard]] bool has_source(const std::vector<Term>& annots);

using Bindings = std::map<std::string, Term>;

[[nodiscard]] Term applied(const Term& term, const Bindings& bindings);
/// The annotations in Jason's order, without duplicates.
[[nodiscard]] std::vector<Term> annotation_set(std::vector<Term> annots);

class BeliefList {
 public:
  enum class Place { front, back };
  struct Removal {
    Term event;
    Bindings bindings;
  };

  /// Returns the event: the literal with its new annotations. Without new ones there is no event.
  std::optional<Term> add(Term literal, Place place);
  /// Returns nothing if there is no event; annotations may be removed nevertheless.
  std::optional<Removal> remove(Term pattern);
  /// Removes the first belief with the literal's predicate and annotations; returns the event.
  std::optional<Term> remove_for(const Term& literal);
  /// Removes all beliefs that unify; returns the events.
  std::vector<Term> abolish(const Term& pattern);
  /// All answers to a query, in order.
  [[nodiscard]] std::vector<Bindings> answers(const Term& query) const;
  /// Whether some fact has exactly these arguments and all of these annotations.
  [[nodiscard]] bool has_exactly(const Term& pattern) const;

  [[nodiscard]] const std::vector<Term>& all() const { return beliefs_; }

 private:
  [[nodiscard]] std::size_t find(const Term& literal) const;
  bool take_annotations(std::size_t place, const std::vector<Term>& annots);

  std::vector<Term> beliefs_;
};

}  // namespace jaywalk::test

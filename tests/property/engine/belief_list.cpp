// SPDX-License-Identifier: Apache-2.0
#include "tests/property/engine/belief_list.h"

#include <algorithm>
#include <utility>

namespace jaywalk::test {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool same(const Term& a, const Term& b) { return text(a) == text(b); }

bool contains(const std::vector<Term>& terms, const Term& wanted) {
  return std::any_of(terms.begin(), terms.end(),
                     [&](const Term& each) { return same(each, wanted); });
}

bool same_predicate(const Term& a, const Term& b) {
  return a.kind == b.kind && a.name == b.name && a.args.size() == b.args.size();
}

std::string joined(const std::vector<Term>& terms, const std::string& rest) {
  std::string all;
  for (const Term& term : terms) all += (all.empty() ? "" : ",") + text(term);
  return rest.empty() ? all : all + "|" + (rest.front() == '_' ? "_" : rest);
}

// Sort key: numbers, then texts, literals by functor and arguments, and variables.
std::string order_of(const Term& term) {
  std::string key{static_cast<char>('0' + static_cast<int>(term.kind))};
  key += term.name + " ";
  for (const Term& arg : term.args) key += order_of(arg);
  return key;
}

Term list_of(std::vector<Term> elements) {
  return {.kind = Term::Kind::list, .args = std::move(elements)};
}

bool unify(const Term& pattern, const Term& known, Bindings& bindings);

// Each annotation of the pattern takes the next known one that unifies. A variable starts over.
bool unify_annotations(const Term& pattern, std::vector<Term> known, Bindings& bindings) {
  const Term wanted = applied(pattern, bindings);
  std::size_t next = 0;
  for (const Term& annot : wanted.annots) {
    if (annot.kind == Term::Kind::variable) next = 0;
    while (next < known.size()) {
      Bindings tried = bindings;
      if (unify(annot, known[next], tried)) {
        bindings = std::move(tried);
        break;
      }
      ++next;
    }
    if (next == known.size()) return false;
    known.erase(known.begin() + static_cast<std::ptrdiff_t>(next));
  }
  if (!wanted.rest.empty()) bindings[wanted.rest] = list_of(std::move(known));
  return true;
}

bool unify_list(const Term& pattern, const Term& known, Bindings& bindings) {
  const std::size_t count = pattern.args.size();
  if (known.args.size() < count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!unify(pattern.args[i], known.args[i], bindings)) return false;
  }
  const auto first = known.args.begin() + static_cast<std::ptrdiff_t>(count);
  std::vector<Term> left(first, known.args.end());
  if (pattern.rest.empty()) return left.empty();
  return unify({.kind = Term::Kind::variable, .name = pattern.rest}, list_of(std::move(left)),
               bindings);
}

// REQUIRES: `known` is ground.
bool unify(const Term& pattern, const Term& known, Bindings& bindings) {
  if (pattern.kind == Term::Kind::variable) {
    const auto [bound, is_new] = bindings.try_emplace(pattern.name, known);
    return is_new || unify(Term(bound->second), known, bindings);
  }
  if (pattern.kind != known.kind) return false;
  if (pattern.kind == Term::Kind::list) return unify_list(pattern, known, bindings);
  if (!same_predicate(pattern, known)) return false;
  for (std::size_t i = 0; i < pattern.args.size(); ++i) {
    if (!unify(pattern.args[i], known.args[i], bindings)) return false;
  }
  return unify_annotations(pattern, known.annots, bindings);
}

// Advances to the next combination of places below `count` in lexicographic order.
bool choose_next(std::vector<std::size_t>& places, std::size_t count) {
  std::size_t i = places.size();
  while (i > 0 && places[i - 1] == count - places.size() + i - 1) --i;
  if (i == 0) return false;
  ++places[i - 1];
  for (; i < places.size(); ++i) places[i] = places[i - 1] + 1;
  return true;
}

Term with_own_source(Term literal) {
  if (has_source(literal.annots)) return literal;
  literal.annots.push_back({.name = "source", .args = {{.name = "self"}}});
  literal.annots = annotation_set(std::move(literal.annots));
  return literal;
}

}  // namespace

std::string text(const Term& term) {
  switch (term.kind) {
    case Term::Kind::number:
    case Term::Kind::text:
      return term.name;
    case Term::Kind::variable:
      return term.name.front() == '_' ? "_" : term.name;
    case Term::Kind::list:
      return "[" + joined(term.args, term.rest) + "]";
    case Term::Kind::literal:
      break;
  }
  std::string all = term.name;
  if (!term.args.empty()) all += "(" + joined(term.args, "") + ")";
  const bool is_annotated = !term.annots.empty() || !term.rest.empty();
  return is_annotated ? all + "[" + joined(term.annots, term.rest) + "]" : all;
}

bool is_ground(const Term& term) {
  return term.kind != Term::Kind::variable && term.rest.empty() &&
         std::all_of(term.args.begin(), term.args.end(), is_ground) &&
         std::all_of(term.annots.begin(), term.annots.end(), is_ground);
}

bool has_source(const std::vector<Term>& annots) {
  return std::any_of(annots.begin(), annots.end(),
                     [](const Term& annot) { return annot.name == "source"; });
}

Term applied(const Term& term, const Bindings& bindings) {
  if (term.kind == Term::Kind::variable) {
    const auto bound = bindings.find(term.name);
    return bound == bindings.end() ? term : bound->second;
  }
  Term made = term;
  for (Term& arg : made.args) arg = applied(arg, bindings);
  for (Term& annot : made.annots) annot = applied(annot, bindings);
  if (const auto bound = bindings.find(term.rest); bound != bindings.end()) {
    std::vector<Term>& grown = term.kind == Term::Kind::list ? made.args : made.annots;
    grown.insert(grown.end(), bound->second.args.begin(), bound->second.args.end());
    made.rest.clear();
  }
  made.annots = annotation_set(std::move(made.annots));
  return made;
}

std::vector<Term> annotation_set(std::vector<Term> annots) {
  std::stable_sort(annots.begin(), annots.end(),
                   [](const Term& a, const Term& b) { return order_of(a) < order_of(b); });
  annots.erase(std::unique(annots.begin(), annots.end(), same), annots.end());
  return annots;
}

std::size_t BeliefList::find(const Term& literal) const {
  for (std::size_t i = 0; i < beliefs_.size(); ++i) {
    const bool all_same =
        same_predicate(literal, beliefs_[i]) &&
        std::equal(literal.args.begin(), literal.args.end(), beliefs_[i].args.begin(), same);
    if (all_same) return i;
  }
  return kNone;
}

std::optional<Term> BeliefList::add(Term literal, Place place) {
  literal = with_own_source(std::move(literal));
  const std::size_t known = find(literal);
  if (known == kNone) {
    beliefs_.insert(place == Place::front ? beliefs_.begin() : beliefs_.end(), literal);
    return literal;
  }
  std::vector<Term>& annots = beliefs_[known].annots;
  std::erase_if(literal.annots, [&](const Term& annot) { return contains(annots, annot); });
  if (literal.annots.empty()) return std::nullopt;
  annots.insert(annots.end(), literal.annots.begin(), literal.annots.end());
  annots = annotation_set(std::move(annots));
  return literal;
}

// True: the belief had no other source and is removed.
bool BeliefList::take_annotations(std::size_t place, const std::vector<Term>& annots) {
  std::vector<Term>& known = beliefs_[place].annots;
  std::erase_if(known, [&](const Term& annot) { return contains(annots, annot); });
  if (has_source(known)) return false;
  beliefs_.erase(beliefs_.begin() + static_cast<std::ptrdiff_t>(place));
  return true;
}

bool BeliefList::has_exactly(const Term& pattern) const {
  const Term wanted = with_own_source(pattern);
  const std::size_t known = find(wanted);
  return known != kNone &&
         std::all_of(wanted.annots.begin(), wanted.annots.end(),
                     [&](const Term& annot) { return contains(beliefs_[known].annots, annot); });
}

std::optional<BeliefList::Removal> BeliefList::remove(Term pattern) {
  pattern = with_own_source(std::move(pattern));
  if (has_exactly(pattern)) {
    take_annotations(find(pattern), pattern.annots);
    return Removal{pattern, {}};
  }
  if (is_ground(pattern)) return std::nullopt;
  for (std::size_t i = 0; i < beliefs_.size(); ++i) {
    Bindings bindings;
    if (!unify(pattern, beliefs_[i], bindings)) continue;
    const Term removed = applied(pattern, bindings);
    if (!take_annotations(i, removed.annots)) return std::nullopt;
    return Removal{removed, bindings};
  }
  return std::nullopt;
}

std::optional<Term> BeliefList::remove_for(const Term& literal) {
  Term pattern = literal;
  for (std::size_t i = 0; i < pattern.args.size(); ++i) {
    pattern.args[i] = {.kind = Term::Kind::variable, .name = "_any" + std::to_string(i)};
  }
  const auto removed = remove(std::move(pattern));
  return removed ? std::optional(removed->event) : std::nullopt;
}

std::vector<Term> BeliefList::abolish(const Term& pattern) {
  std::vector<Term> events;
  std::erase_if(beliefs_, [&](const Term& belief) {
    Bindings bindings;
    if (!unify(pattern, belief, bindings)) return false;
    events.push_back(belief);
    events.back().annots.clear();
    return true;
  });
  return events;
}

std::vector<Bindings> BeliefList::answers(const Term& query) const {
  std::vector<Bindings> found;
  for (const Term& belief : beliefs_) {
    if (!same_predicate(query, belief) || belief.annots.size() < query.annots.size()) continue;
    // Every subset of the right size may be an answer. An open set takes all annotations at once.
    const bool takes_all = !query.rest.empty() || query.annots.empty();
    std::vector<std::size_t> places(takes_all ? belief.annots.size() : query.annots.size());
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
    do {
      Term chosen = belief;
      chosen.annots.clear();
      for (const std::size_t place : places) chosen.annots.push_back(belief.annots[place]);
      Bindings bindings;
      if (unify(query, chosen, bindings)) found.push_back(std::move(bindings));
    } while (choose_next(places, belief.annots.size()));
  }
  return found;
}

}  // namespace jaywalk::test

// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/rule_unfolder.h"

#include <algorithm>

#include "interpreter/logic/unifier/unifier.h"

namespace jaywalk {
namespace {

constexpr std::size_t kDeepest = 8;     // rules within rules
constexpr std::size_t kMostSlots = 64;  // of a frame

// Whether rules may replace a query with these arguments: a slot's value is known only later.
bool are_usual(std::span<const Value> args) {
  return std::ranges::all_of(args, [](Value arg) {
    return arg.is_slot() || (arg.is_closed() && !Unifier::is_of_other_namespace(arg));
  });
}

// Variables, each once: they can be replaced by any argument.
bool are_variables(std::span<const Value> head) {
  for (std::size_t i = 0; i < head.size(); ++i) {
    const auto is_same = [&](Value other) { return other.same_as(head[i]); };
    if (!head[i].is_slot() || std::ranges::any_of(head.first(i), is_same)) return false;
  }
  return true;
}

// A term without variables of other namespaces and programs as data.
bool is_usual_term(Value term) {
  for (; term.is_pair(); term = term.pair()->tail) {
    if (!is_usual_term(term.pair()->head)) return false;
  }
  if (!term.is_structure() || term.is_closed()) return true;
  const Structure& s = *term.structure();
  return s.form() <= Form::function && !s.is_annotated() &&
         std::ranges::all_of(s.arg_span(), is_usual_term);
}

}  // namespace

const RuleTable* RuleUnfolder::table_of(Predicate predicate) const {
  const auto found =
      std::ranges::find(tables_, predicate, [](const auto& row) { return row.first; });
  return found == tables_.end() ? nullptr : &found->second;
}

// Conjunctions, disjunctions and negations of queries, comparisons and unifications.
bool RuleUnfolder::is_usual(Value formula) const {
  if (formula.is_atom()) {
    const Predicate atom = formula.atom_id();
    return atom != predicates::truth && atom != predicates::falsity &&
           !symbols_.signature(atom).dotted;
  }
  if (!formula.is_structure()) return false;
  const Structure& s = *formula.structure();
  switch (s.form()) {
    case Form::logical:
      return std::ranges::all_of(s.arg_span(), [this](Value part) { return is_usual(part); });
    case Form::literal:
      return !s.is_annotated() && !symbols_.signature(s.predicate()).dotted &&
             std::ranges::all_of(s.arg_span(), is_usual_term);
    case Form::relation:
      return s.predicate() != predicates::univ && std::ranges::all_of(s.arg_span(), is_usual_term);
    default:
      return false;
  }
}

// The term with replacements for the rule's variables; those without one get a slot.
Value RuleUnfolder::replaced(Value term, std::span<const Symbol> names, Slots& slots) {
  if (term.is_slot()) {
    Value& known = slots[term.slot_index()];
    if (known.is_unset()) {
      known = Value::slot(static_cast<std::uint32_t>(slot_names_.size()));
      slot_names_.push_back(names[term.slot_index()]);
    }
    return known;
  }
  if (term.is_pair()) {
    const Value head = replaced(term.pair()->head, names, slots);
    return heap_.pair(head, replaced(term.pair()->tail, names, slots));
  }
  if (!term.is_structure() || term.is_closed()) return term;
  const Structure& s = *term.structure();
  std::vector<Value> args;
  for (const Value arg : s.arg_span()) args.push_back(replaced(arg, names, slots));
  return heap_.structure(s.predicate(), args, Value::empty_list(), s.form());
}

std::optional<RuleUnfolder::Unfolded> RuleUnfolder::enter(Predicate predicate,
                                                          std::span<const Value> args) {
  const RuleTable* const table = table_of(predicate);
  if (table == nullptr || table->candidates().size() != 1 || entered_.size() == kDeepest ||
      std::ranges::count(entered_, predicate) > 0 || !are_usual(args)) {
    return std::nullopt;
  }
  const RuleCode& rule = *table->candidates().front().rule;
  const Structure& source = *rule.source.structure();
  const Value head = deref(source.arg(0));
  const std::span<const Value> parameters =
      head.is_structure() ? head.structure()->arg_span() : std::span<const Value>();
  const Value body = deref(source.arg(1));
  if (!are_variables(parameters) || !is_usual(body) ||
      slot_names_.size() + rule.slot_count > kMostSlots) {
    return std::nullopt;
  }
  Slots slots(rule.slot_count);
  for (std::size_t i = 0; i < parameters.size(); ++i) slots[parameters[i].slot_index()] = args[i];
  entered_.push_back(predicate);
  has_unfolded_ = true;
  return Unfolded{replaced(body, rule.slot_names, slots), table};
}

}  // namespace jaywalk

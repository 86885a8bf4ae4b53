// SPDX-License-Identifier: Apache-2.0
// Queries that are slower than those over bare literals: with annotations, where each subset of a
// fact's annotations is an answer; variables, which stand for any belief or for a formula.

#include "interpreter/logic/formula_compiler.h"
#include "interpreter/logic/machine_inline.h"

namespace jaywalk {
namespace {

constexpr std::size_t kMaxTemporaryCode = 1'000'000;

// The facts and answers of rules for a query that is a free variable.
class ListedSolutions : public Solutions {
 public:
  ListedSolutions(Value pattern, std::vector<Value> found)
      : pattern_(pattern), found_(std::move(found)) {}

  bool next(ActionCall& call) override {
    while (next_ < found_.size()) {
      if (call.unifier().unify(pattern_, call.unifier().fresh_copy(found_[next_++]))) return true;
    }
    return false;
  }

 private:
  Value pattern_;
  std::vector<Value> found_;
  std::size_t next_ = 0;
};

std::size_t list_length(Value list) {
  std::size_t length = 0;
  for (list = deref(list); list.is_pair(); list = deref(list.pair()->tail)) ++length;
  return length;
}

// The `ordinal`-th subset of `wanted` out of `count` in lexicographic order; empty at the end.
std::vector<std::size_t> subset(std::size_t count, std::size_t wanted, std::size_t ordinal) {
  std::vector<std::size_t> chosen(wanted);
  for (std::size_t i = 0; i < wanted; ++i) chosen[i] = i;
  for (; ordinal > 0; --ordinal) {
    std::size_t i = wanted;
    while (i > 0 && chosen[i - 1] == count - wanted + i - 1) --i;
    if (i == 0) return {};
    ++chosen[i - 1];
    for (; i < wanted; ++i) chosen[i] = chosen[i - 1] + 1;
  }
  return chosen;
}

}  // namespace

bool Machine::slow_query(const Goal& goal, Value literal) {
  if (!is_literal(literal)) return enter_term(literal, goal);
  const LiteralParts parts = literal_parts(literal);
  Relation* const relation = beliefs_->find(parts.predicate);
  if (relation == nullptr) return false;
  return try_annotated({relation, relation->open(parts.args), 0, kNextRow, literal}, goal);
}

// Facts with each subset of their annotations that is as large as the query's; rules by their head.
bool Machine::try_annotated(AnnotatedQuery query, const Goal& goal) {
  const LiteralParts parts = literal_parts(query.literal);
  for (;;) {
    if (query.combination == kNextRow) {
      if (query.relation->advance(query.cursor, query.seq, parts.args.data()) == nullptr) {
        return false;
      }
      query.combination = 0;
    }
    const Row& row = query.relation->row(query.seq);
    ChoicePoint& choice = push(ChoicePoint::Kind::annotated, goal);
    choice.annotated = std::make_unique<AnnotatedQuery>(query);
    if (row.is_hole()) {
      query.combination = kNextRow;
    } else if (row.rule != nullptr) {
      choice.annotated->combination = kNextRow;
      Environment* const caller = environment_;
      // The head's annotations are in the rule's variables, hence the frame first.
      const bool entered =
          enter_framed(*row.rule, goal, parts.args.data()) &&
          unifier_.unify_annotations(
              parts.annots,
              unifier_.instantiate(literal_parts(row.rule->head).annots, environment_->slots));
      if (entered) return true;
      environment_ = caller;
      query.combination = kNextRow;
    } else {
      bool exhausted = false;
      choice.annotated->combination = query.combination + 1;
      if (unify_subset(query.literal, row.fact, query.combination, exhausted)) {
        goal_ = goal.next;
        return true;
      }
      query.combination = exhausted ? kNextRow : query.combination + 1;
    }
    restore(choices_.back());
    pop();
  }
}

bool Machine::unify_subset(Value literal, Value fact, std::size_t combination, bool& exhausted) {
  if (!fact.is_closed()) fact = unifier_.fresh_copy(fact);
  const LiteralParts wanted = literal_parts(literal);
  const LiteralParts known = literal_parts(fact);
  Value tail = deref(wanted.annots);
  while (tail.is_pair()) tail = deref(tail.pair()->tail);
  const std::size_t count = list_length(wanted.annots);
  const std::size_t available = list_length(known.annots);
  Value annots = known.annots;
  if (tail.is_variable()) {
    exhausted = combination > 0;  // an open set takes them all, once
  } else {
    const std::vector<std::size_t> chosen =
        count > available ? std::vector<std::size_t>{} : subset(available, count, combination);
    exhausted = chosen.empty();
    std::vector<Value> all;
    for (Value a = known.annots; a.is_pair(); a = a.pair()->tail) all.push_back(a.pair()->head);
    std::vector<Value> some;
    for (const std::size_t index : chosen) some.push_back(all[index]);
    annots = heap().list(some);
  }
  if (exhausted) return false;
  return match_fact(fact, wanted.args.data(), wanted.args) &&
         unifier_.unify_annotations(wanted.annots, annots);
}

bool Machine::variable_goal(const Goal& goal) {
  const Value value = unifier_.instantiate(goal.term, environment_->slots);
  const bool open =
      value.is_variable() || (value.is_structure() && value.structure()->form() == Form::decorated);
  return open ? any_belief(goal, value) : enter_term(value, goal);
}

bool Machine::enter_term(Value formula, const Goal& goal) {
  if (temporary_.size() > kMaxTemporaryCode) throw QueryLimit{"too many formulas made in a query"};
  auto code = std::make_unique<FormulaCode>();
  code->entry = FormulaCompiler(*code, *actions_, symbols_).compile(formula, nullptr);
  const Goal* const entry = code->entry;
  temporary_.push_back(std::move(code));
  if (entry != nullptr && entry->kind == Goal::Kind::falsity) return false;
  environment_ = make_environment(environment_, goal.next, {});
  use_frame(*environment_);
  goal_ = entry;
  return true;
}

// All relations for a variable; for N::p(X) those of that name in any namespace, the default one
// first.
std::vector<Relation*> Machine::relations_for(Value pattern) const {
  const bool named = pattern.is_structure() && is_literal(deref(pattern.structure()->arg(0)));
  Signature wanted;
  if (named) {
    wanted = symbols_.signature(literal_parts(deref(pattern.structure()->arg(0))).predicate);
  }
  std::vector<Relation*> found;
  for (Relation* const relation : beliefs_->relations()) {
    Signature signature = symbols_.signature(relation->predicate());
    const bool is_default = signature.ns == names::default_ns;
    signature.ns = wanted.ns;
    if (named && signature != wanted) continue;
    found.insert(named && is_default ? found.begin() : found.end(), relation);
  }
  return found;
}

bool Machine::any_belief(const Goal& goal, Value pattern) {
  std::vector<Value> found;
  const std::vector<Relation*> relations = relations_for(pattern);
  for (Relation* const relation : relations) {
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Row& row = relation->row(seq);
      if (!row.fact.is_unset()) found.push_back(row.fact);
      if (row.rule == nullptr) continue;
      ScratchSlots slots(unifier_, row.rule->slot_count);
      const RuleCode& rule = *row.rule;
      solve_all(rule.body.entry, slots.data(), [&] {
        found.push_back(unifier_.instantiate(rule.head, slots.data()));
        return true;
      });
    }
  }
  auto call = std::make_unique<ActionCall>(*this, goal, environment_->slots, agent_, nullptr);
  call->solutions = std::make_unique<ListedSolutions>(pattern, std::move(found));
  push(ChoicePoint::Kind::solutions, goal).call = std::move(call);
  return next_solution();
}

}  // namespace jaywalk

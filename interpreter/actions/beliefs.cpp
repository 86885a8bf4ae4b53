// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

// The relations in which a pattern may find something: one for a literal, all for a variable.
std::vector<Relation*> relations_for(Agent& agent, Value pattern) {
  std::vector<Relation*> found;
  if (is_literal(pattern)) {
    Relation* const relation = agent.beliefs().find(literal_parts(pattern).predicate);
    if (relation != nullptr) found.push_back(relation);
    return found;
  }
  for (Relation* const relation : agent.beliefs().relations()) found.push_back(relation);
  if (is_form(pattern, Form::decorated)) {  // N::p(X): the default namespace first
    std::stable_partition(found.begin(), found.end(), [](const Relation* relation) {
      return !is_foreign(relation->predicate());
    });
  }
  return found;
}

bool is_pattern(Value value) {
  return is_literal(value) || value.is_variable() || is_form(value, Form::decorated);
}

bool holds_always(const RuleCode& rule) {
  const Value body = rule.source.structure()->arg(1);
  return body.is_atom() && body.atom_id() == predicates::truth;
}

Value rule_head(Value rule) { return deref(rule.structure()->arg(0)); }

Outcome assert_belief(ActionCall& call, Place place) {
  Agent* const agent = call.agent();
  if (agent == nullptr) return Outcome::failed;
  const Value literal = call.arg(0);
  if (is_form(literal, Form::rule)) {
    agent->add_rule(literal, place);
    return Outcome::succeeded;
  }
  if (!is_java_literal(literal)) return call.java_exception("the argument is no literal");
  if (!is_literal(literal)) return call.wrong_argument(0, "a ground literal (or rule).");
  const Value fact = call.unifier().fresh_copy(literal);
  const auto& customisation = agent->customisation();
  const bool revises = customisation != nullptr && customisation->revise_beliefs;
  if (place == Place::front || revises) {
    (void)agent->add_belief(fact, place, nullptr);
  } else if (const auto added = agent->beliefs().add(fact, place)) {
    agent->add_event({TriggerOperator::add, TriggerKind::belief, *added, nullptr, 0});
  }
  call.heap().protect();
  return Outcome::succeeded;
}

}  // namespace

Value rule_term(Unifier& unifier, const RuleCode& rule) {
  ScratchSlots slots(unifier, rule.slot_count);
  const std::span<const Symbol> names = unifier.slot_names();
  unifier.set_slot_names(rule.slot_names);
  const std::size_t trail = unifier.mark();
  const Value term = unifier.instantiate(rule.source, slots.data());
  unifier.undo(trail);  // the frame is gone
  unifier.set_slot_names(names);
  return term;
}

Outcome abolish(ActionCall& call) {
  Agent* const agent = call.agent();
  if (agent == nullptr) return Outcome::failed;
  const Value pattern = call.arg(0);
  if (!is_pattern(pattern)) return call.wrong_argument(0, "a literal or variable.");
  Unifier& unifier = call.unifier();
  std::vector<std::pair<Relation*, std::int64_t>> matches;
  for (Relation* const relation : relations_for(*agent, pattern)) {
    const std::span<const Value> args =
        is_literal(pattern) ? literal_parts(pattern).args : std::span<const Value>{};
    Relation::Cursor cursor = relation->open(args);
    std::int64_t seq = 0;
    while (const Row* row = relation->advance(cursor, seq, args.data())) {
      if (row->fact.is_unset()) continue;
      const std::size_t trail = unifier.mark();
      // A variable stands for any belief, of whatever namespace.
      if (pattern.is_variable() || unifier.unify(pattern, row->fact)) {
        matches.emplace_back(relation, seq);
      }
      unifier.undo(trail);
    }
  }
  for (const auto& [relation, seq] : matches) {
    const Value fact = with_annotations(call.heap(), relation->row(seq).fact, Value::empty_list());
    agent->beliefs().erase(*relation, seq);
    agent->add_event({TriggerOperator::remove, TriggerKind::belief, fact, nullptr, 0});
  }
  call.heap().protect();
  return Outcome::succeeded;
}

Outcome belief(ActionCall& call) {
  Agent* const agent = call.agent();
  if (agent == nullptr) return Outcome::failed;
  const Value pattern = call.arg(0);
  if (!is_java_literal(pattern)) return call.java_exception("the argument is no literal");
  if (!is_pattern(pattern)) return Outcome::failed;
  std::vector<Value> found;
  for (Relation* const relation : relations_for(*agent, pattern)) {
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Row& row = relation->row(seq);
      if (!row.fact.is_unset()) found.push_back(row.fact);
      if (row.rule != nullptr && holds_always(*row.rule)) {
        found.push_back(rule_head(rule_term(call.unifier(), *row.rule)));
      }
    }
  }
  return each(call, [found = std::move(found), next = std::size_t{0}](ActionCall& inner) mutable {
    while (next < found.size()) {
      const Value fact = found[next++];
      if (inner.unify(0, fact.is_closed() ? fact : inner.unifier().fresh_copy(fact))) return true;
    }
    return false;
  });
}

Outcome relevant_rules(ActionCall& call) {
  Agent* const agent = call.agent();
  if (agent == nullptr) return Outcome::failed;
  const Value pattern = call.arg(0);
  if (!is_pattern(pattern)) return Outcome::failed;
  Unifier& unifier = call.unifier();
  std::vector<Value> found;
  for (Relation* const relation : relations_for(*agent, pattern)) {
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Row& row = relation->row(seq);
      if (row.rule == nullptr) continue;
      const Value rule = rule_term(unifier, *row.rule);
      const std::size_t trail = unifier.mark();
      const bool relevant = unifier.unify(pattern, rule_head(rule));
      unifier.undo(trail);
      if (!relevant) continue;
      const Structure& s = *rule.structure();
      const std::array<Value, 2> parts{without_sources(call.heap(), rule_head(rule)), s.arg(1)};
      found.push_back(call.heap().structure(s.predicate(), parts, s.annots(), Form::rule));
    }
  }
  return call.result(1, call.heap().list(found));
}

Outcome list_rules(ActionCall& call) {
  Agent* const agent = call.agent();
  if (agent == nullptr) return Outcome::failed;
  for (const auto& relation : agent->beliefs().relations()) {
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Row& row = relation->row(seq);
      if (row.rule == nullptr) continue;
      const Value rule = rule_term(call.unifier(), *row.rule);
      std::string text = term_text(rule_head(rule), call.symbols());
      text += " :- ";
      append_term(text, rule.structure()->arg(1), call.symbols());
      agent->host().print(*agent, text);
    }
  }
  return Outcome::succeeded;
}

Outcome asserta(ActionCall& call) { return assert_belief(call, Place::front); }
Outcome assertz(ActionCall& call) { return assert_belief(call, Place::back); }

Outcome perceive(ActionCall& call) {
  call.agent()->perceive_now();
  return Outcome::succeeded;
}

}  // namespace jaywalk::actions

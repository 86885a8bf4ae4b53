// SPDX-License-Identifier: Apache-2.0
#include "interpreter/explain/near_misses.h"

#include <vector>

#include <fmt/format.h>

#include "interpreter/program/plan_compiler.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

constexpr std::size_t kShownFacts = 3;

std::string indicator(const Signature& signature, const SymbolTable& symbols) {
  return fmt::format("{}{}/{}", signature.negated ? "~" : "", symbols.text(signature.functor),
                     signature.arity);
}

bool has_rows(const Relation& relation) { return relation.size() > 0; }

std::string shown_facts(const Relation& relation, const SymbolTable& symbols) {
  std::string text;
  std::size_t shown = 0;
  std::size_t count = 0;
  // The newest first, as the agent itself would find them.
  for (std::int64_t seq = relation.end_seq() - 1; seq >= relation.first_seq(); --seq) {
    const Row& row = relation.row(seq);
    // A rule, or a fact that was removed.
    if (row.fact.is_unset()) continue;
    ++count;
    if (shown == kShownFacts) continue;
    text += fmt::format("{}{}", shown++ == 0 ? "" : ", ", term_text(row.fact, symbols));
  }
  if (count > shown) text += fmt::format(" and {} more", count - shown);
  return text;
}

}  // namespace

std::string missing_belief_hint(const Agent& agent, Predicate asked) {
  const SymbolTable& symbols = agent.symbols();
  const Relation* const relation = agent.beliefs().find(asked);
  if (relation != nullptr && has_rows(*relation)) {
    const std::string facts = shown_facts(*relation, symbols);
    return facts.empty() ? std::string() : "believed is " + facts;
  }
  const Signature& wanted = symbols.signature(asked);
  const std::string name = indicator(wanted, symbols);
  std::vector<std::string> others;
  for (const auto& other : agent.beliefs().relations()) {
    if (!has_rows(*other)) continue;
    const Signature& signature = symbols.signature(other->predicate());
    if (signature.functor == wanted.functor && signature.ns == wanted.ns) {
      // From near to far: another number of arguments or negation, another namespace, a similar
      // name.
      const bool negation = signature.negated != wanted.negated;
      return fmt::format("nothing is believed about {}, but about {}{}", name,
                         indicator(signature, symbols),
                         negation ? " (strong negation is a belief of its own)" : "");
    }
    if (signature.functor == wanted.functor) {
      return fmt::format("nothing is believed about {} in this namespace, but in '{}'", name,
                         symbols.text(signature.ns));
    }
    if (signature.arity == wanted.arity) others.emplace_back(symbols.text(signature.functor));
  }
  const auto similar = closest(symbols.text(wanted.functor), others);
  if (similar) {
    return fmt::format("nothing is believed about {}; did you mean '{}'?", name, *similar);
  }
  return fmt::format("nothing is believed about {}", name);
}

std::string missing_plan_hint(const Agent& agent, const Event& event) {
  if (!is_literal(event.literal)) return {};
  const SymbolTable& symbols = agent.symbols();
  const Signature& wanted = symbols.signature(predicate_of(event.literal));
  const std::string op = trigger_operator(event.op, event.kind);
  std::vector<std::string> others;
  for (const auto& plan : agent.library().plans()) {
    // Plans that every agent has, or that fit any event, are no near miss.
    if (plan->is_standard || plan->any_predicate) continue;
    const Signature& signature = symbols.signature(plan->key.predicate);
    const bool same_event = plan->key.op == event.op && plan->key.kind == event.kind;
    if (signature.functor == wanted.functor) {
      const std::string trigger = fmt::format(
          "{}{}", trigger_operator(plan->key.op, plan->key.kind), indicator(signature, symbols));
      if (same_event && signature.arity != wanted.arity) {
        return fmt::format("there is a plan for {} ({}:{}), with {} argument{}", trigger,
                           plan->file, plan->line, signature.arity,
                           signature.arity == 1 ? "" : "s");
      }
      if (!same_event && signature.arity == wanted.arity && plan->key.op == event.op) {
        return fmt::format("there is a plan for {} ({}:{}), which is another kind of event",
                           trigger, plan->file, plan->line);
      }
    } else if (same_event) {
      others.emplace_back(symbols.text(signature.functor));
    }
  }
  const auto similar = closest(symbols.text(wanted.functor), others);
  return similar ? fmt::format("did you mean '{}{}'?", op, *similar) : std::string();
}

}  // namespace jaywalk

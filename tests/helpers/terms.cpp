// SPDX-License-Identifier: Apache-2.0
#include "tests/helpers/terms.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "interpreter/logic/formula_compiler.h"
#include "interpreter/syntax/parser.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk::test {
namespace {

SourcePtr source_of(std::string_view text) {
  return std::make_shared<const Source>("test", std::string(text));
}

// A test whose own text is wrong cannot say anything.
void require(bool fine, std::string_view text, const Diagnostics& diagnostics) {
  if (fine && !diagnostics.has_errors()) return;
  std::fprintf(stderr, "cannot read '%s':\n%s\n", std::string(text).c_str(),
               diagnostics.render().c_str());
  std::abort();
}

}  // namespace

Terms::Terms()
    : machine(heap, symbols, beliefs, standard_actions()),
      translator_(heap, symbols, standard_actions()) {
  machine.set_log([this](std::string_view line) { warnings.emplace_back(line); });
  new_scope();
}

void Terms::new_scope() {
  scope_ = std::make_unique<VariableScope>(VariableScope::Kind::variables, heap, symbols);
}

Value Terms::term(std::string_view text) {
  const SourcePtr source = source_of(text);
  ast::Arena arena;
  Diagnostics diagnostics;
  const ast::Node* const node = parse_term(source, arena, diagnostics);
  require(node != nullptr, text, diagnostics);
  return translator_.term(*node, *scope_);
}

void Terms::believe(std::string_view program) {
  Diagnostics diagnostics;
  const ast::File file = parse_agent(source_of(program), diagnostics);
  require(true, program, diagnostics);
  for (std::size_t i = file.components.size(); i > 0; --i) {
    const ast::Component& component = file.components[i - 1];
    VariableScope slots(VariableScope::Kind::slots, heap, symbols);
    Value head = translator_.literal(*component.literal, slots);
    Value annots = literal_parts(head).annots;
    if (!has_source(annots)) annots = union_of(heap, annots, source_self(), symbols);
    head = with_annotations(heap, head, annots);
    if (component.body == nullptr && slots.slot_names().empty()) {
      (void)beliefs.add(head, Place::front);
      continue;
    }
    const Value body = component.body == nullptr ? Value::atom(predicates::truth)
                                                 : translator_.formula(*component.body, slots);
    beliefs.add_rule(
        make_rule(head, body, std::move(slots.slot_names()), heap, standard_actions(), symbols),
        Place::front);
  }
  heap.protect();
}

std::string Terms::text(Value value) { return term_text(unifier().apply(value), symbols); }

bool Terms::holds(std::string_view formula) { return machine.solve_term(term(formula)); }

std::vector<std::string> Terms::answers(std::string_view formula, std::string_view shown) {
  const Value goal = term(formula);
  const Value wanted = term(shown);
  std::vector<std::string> found;
  machine.solve_all_terms(goal, [&] {
    found.push_back(text(wanted));
    return true;
  });
  return found;
}

std::vector<std::string> Terms::facts(std::string_view functor, int arity) {
  std::vector<std::string> found;
  const Relation* const relation =
      beliefs.find(symbols.predicate(functor, static_cast<std::uint16_t>(arity)));
  if (relation == nullptr) return found;
  for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
    const Row& row = relation->row(seq);
    if (!row.fact.is_unset()) found.push_back(term_text(row.fact, symbols));
  }
  return found;
}

}  // namespace jaywalk::test

// SPDX-License-Identifier: Apache-2.0
// Programs read and written while an agent runs: `.include`, `.save_agent`.

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

/// Sets, maps and queues cannot be written down.
bool has_object(Value term) {
  std::vector<Value> todo{term};
  while (!todo.empty()) {
    const Value value = deref(todo.back());
    todo.pop_back();
    if (value.is_object()) return true;
    if (value.is_pair()) {
      todo.push_back(value.pair()->head);
      todo.push_back(value.pair()->tail);
    } else if (value.is_structure()) {
      const Structure& s = *value.structure();
      todo.insert(todo.end(), s.args(), s.args() + s.arity);
      todo.push_back(s.annots());
    }
  }
  return false;
}

/// The belief without `source(percept)`.
Value without_percept(Heap& heap, Value fact) {
  const Value percept = source_percept().pair()->head;
  std::vector<Value> kept;
  for (const Value annot : elements(literal_parts(fact).annots)) {
    if (!equal_terms(annot, percept)) kept.push_back(annot);
  }
  return with_annotations(heap, fact, heap.list(kept));
}

/// Writes an agent as the text of a program.
class ProgramText {
 public:
  explicit ProgramText(Agent& agent) : agent_(agent) {}

  std::string write(Value goals) {
    for (const RuleFunction& function : agent_.program().functions()) write(function);
    for (const auto& program : agent_.included()) {
      for (const RuleFunction& function : program->functions()) write(function);
    }
    for (const auto& relation : agent_.beliefs().relations()) write(*relation);
    for (const Value goal : elements(goals)) text_ += fmt::format("!{}.\n", source(goal));
    for (const auto& plan : agent_.library().plans()) {
      if (!plan->is_standard) write(*plan, 0);
    }
    return std::move(text_);
  }

 private:
  // Local namespaces have names that cannot be written; any other of their own will do.
  std::string source(Value term) {
    std::string text = source_text(term, agent_.symbols());
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool in_string = text[i] == '"';
      if (in_string) i = end_of_string(text, i);
      if (text[i] == '#') text.replace(i, 1, "local_");
    }
    return text;
  }

  static std::size_t end_of_string(const std::string& text, std::size_t i) {
    for (++i; i < text.size() && text[i] != '"'; ++i) {
      if (text[i] == '\\') ++i;
    }
    return i;
  }

  void write(const RuleFunction& function) {
    text_ += fmt::format("{{ register_function(\"{}\",{},\"{}\") }}\n",
                         agent_.symbols().text(function.name), function.arity,
                         agent_.symbols().functor(function.predicate));
  }

  // In the order of queries, which is that of a program's beliefs.
  void write(const Relation& relation) {
    for (std::int64_t seq = relation.end_seq() - 1; seq >= relation.first_seq(); --seq) {
      const Row& row = relation.row(seq);
      if (row.rule != nullptr) {
        const Structure& rule = *rule_term(agent_.machine().unifier(), *row.rule).structure();
        text_ += fmt::format("{} :- {}.\n", source(rule.arg(0)), source(rule.arg(1)));
      } else if (!row.fact.is_unset() && !has_object(row.fact)) {
        write_fact(row);
      }
    }
  }

  // Beliefs that come from percepts alone are left out: the copy perceives by itself.
  void write_fact(const Row& row) {
    Value fact = row.fact;
    if (row.percept_generation != 0) {
      fact = without_percept(agent_.heap(), fact);
      if (!has_source(literal_parts(fact).annots)) return;
    }
    text_ += source(fact) + ".\n";
  }

  void write(const Plan& plan, int depth) {
    const std::string indent(static_cast<std::size_t>(depth) * 2, ' ');
    const PlanParts parts = plan_parts(agent_.plan_term(plan));
    text_ += indent;
    if (is_literal(parts.label)) write_label(literal_parts(parts.label));
    text_ += bare(parts.trigger);
    if (!parts.context.is_unset()) text_ += " : " + source(parts.context);
    if (!parts.goal_condition.is_unset()) text_ += " <: " + source(parts.goal_condition);
    const std::string body = bare(parts.body);
    if (!body.empty()) text_ += " <- " + body;
    text_ += '.';
    if (plan.subplans != nullptr) {
      text_ += " {\n";
      for (const auto& inner : plan.subplans->plans()) write(*inner, depth + 1);
      text_ += indent + "}";
    }
    text_ += '\n';
  }

  // Leaves out generated labels, but keeps their annotations, except for the file of the plan.
  void write_label(const LiteralParts& label) {
    const Predicate url = agent_.symbols().predicate("url", 1);
    std::vector<Value> kept;
    for (const Value annot : elements(label.annots)) {
      if (!annot.is_structure() || annot.structure()->predicate() != url) kept.push_back(annot);
    }
    const Value annots = agent_.heap().list(kept);
    if (!agent_.symbols().functor(label.predicate).starts_with("p__")) {
      text_ += '@' + source(agent_.heap().structure(label.predicate, label.args, annots)) + ' ';
    } else if (!kept.empty()) {
      text_ += '@' + source(annots) + ' ';
    }
  }

  // A trigger or body without its braces.
  std::string bare(Value term) {
    std::string text = source(term);
    if (!text.starts_with('{')) return text;
    const std::size_t from = text.find_first_not_of(' ', 1);
    const std::size_t to = text.find_last_not_of(' ', text.size() - 2);
    return to < from || from + 1 >= text.size() ? "" : text.substr(from, to + 1 - from);
  }

  Agent& agent_;
  std::string text_;
};

std::string new_namespace(const SymbolTable& symbols) {
  for (int i = 1;; ++i) {
    std::string name = fmt::format("ns{}", i);
    if (!symbols.knows(name)) return name;
  }
}

}  // namespace

Outcome include(ActionCall& call) {
  if (!call.arg(0).is_text()) return call.wrong_argument(0, "a string.");
  ProgramRequest request{
      .file = std::string(call.arg(0).text()->view()), .included = true, .ns = {}};
  const bool is_open = call.count() > 1 && call.arg(1).is_variable();
  if (is_open) {
    request.ns = new_namespace(call.symbols());
  } else if (call.count() > 1) {
    if (!call.arg(1).is_atom()) {
      return call.wrong_arguments("second argument (the namespace) must be an atom or a variable.");
    }
    request.ns = call.symbols().functor(call.arg(1).atom_id());
  }
  Agent& agent = *call.agent();
  LoadProblem problem;
  const std::shared_ptr<const Program> program = agent.host().society().load(request, problem);
  if (program == nullptr && !problem.is_refused) {
    // As in Jason: nothing is included, and the plan goes on.
    agent.log(problem.text);
  } else if (program == nullptr || !agent.include(program, problem.text)) {
    return call.fail("internal_action", problem.text);
  }
  if (!is_open) return Outcome::succeeded;
  return call.result(1, Value::atom(call.symbols().predicate(request.ns, 0)));
}

Outcome save_agent(ActionCall& call) {
  if (!call.arg(0).is_text()) return call.wrong_argument(0, "a string, the name of a file");
  const Value goals = call.count() > 1 ? call.arg(1) : Value::empty_list();
  if (!goals.is_list()) return call.wrong_argument(1, "a list of goals");
  std::string problem;
  const bool saved = call.agent()->host().society().save(
      std::string(call.arg(0).text()->view()), ProgramText(*call.agent()).write(goals), problem);
  return saved ? Outcome::succeeded : call.fail("internal_action", problem);
}

}  // namespace jaywalk::actions

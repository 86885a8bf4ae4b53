// SPDX-License-Identifier: Apache-2.0
#include "interpreter/compile/translator.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "interpreter/program/step_place.h"
#include "interpreter/term/compare.h"

namespace jaywalk {
namespace {

Predicate operator_predicate(ast::Operator op) {
  switch (op) {
    case ast::Operator::logical_and:
      return predicates::logical_and;
    case ast::Operator::logical_or:
      return predicates::logical_or;
    case ast::Operator::less:
      return predicates::less;
    case ast::Operator::less_equal:
      return predicates::less_equal;
    case ast::Operator::greater:
      return predicates::greater;
    case ast::Operator::greater_equal:
      return predicates::greater_equal;
    case ast::Operator::equal:
      return predicates::equal;
    case ast::Operator::not_equal:
      return predicates::not_equal;
    case ast::Operator::unify:
      return predicates::unify;
    case ast::Operator::univ:
      return predicates::univ;
    case ast::Operator::add:
      return predicates::add;
    case ast::Operator::subtract:
      return predicates::subtract;
    case ast::Operator::multiply:
      return predicates::multiply;
    case ast::Operator::divide:
      return predicates::divide;
    case ast::Operator::int_divide:
      return predicates::int_divide;
    case ast::Operator::modulo:
      return predicates::modulo;
    case ast::Operator::power:
      return predicates::power;
    case ast::Operator::negative:
    case ast::Operator::positive:
      return predicates::negative;
    case ast::Operator::logical_not:
      return predicates::logical_not;
    case ast::Operator::none:
      break;
  }
  return predicates::truth;
}

Form operator_form(ast::Operator op) {
  if (op == ast::Operator::logical_and || op == ast::Operator::logical_or) return Form::logical;
  return op >= ast::Operator::add ? Form::expression : Form::relation;
}

Symbol body_operator(ast::BodyOperator op) {
  switch (op) {
    case ast::BodyOperator::none:
      return names::empty;
    case ast::BodyOperator::achieve:
      return names::achieve;
    case ast::BodyOperator::achieve_new_focus:
      return names::achieve_new_focus;
    case ast::BodyOperator::test:
      return names::test;
    case ast::BodyOperator::add:
      return names::plus;
    case ast::BodyOperator::add_new_focus:
      return names::add_new_focus;
    case ast::BodyOperator::add_begin:
      return names::add_begin;
    case ast::BodyOperator::add_end:
      return names::add_end;
    case ast::BodyOperator::remove:
      return names::minus;
    case ast::BodyOperator::remove_new_focus:
      return names::remove_new_focus;
    case ast::BodyOperator::replace:
      return names::replace;
  }
  return names::empty;
}

// Names that no namespace applies to.
bool is_keyword(std::string_view name, std::size_t arity) {
  constexpr std::array<std::string_view, 14> kWords{
      "atomic", "breakpoint", "all_unifs", "default",   "this_ns", "self",   "percept",
      "tell",   "untell",     "achieve",   "unachieve", "askOne",  "askAll", "askHow"};
  if (name == "source" || name == "learned") return arity == 1;
  if (name == "tellHow" || name == "untellHow") return arity == 0;
  return arity == 0 && std::find(kWords.begin(), kWords.end(), name) != kWords.end();
}

}  // namespace

Value VariableScope::variable(std::string_view name) {
  const bool numbered =
      name.size() > 1 && name[0] == '_' && std::isdigit(static_cast<unsigned char>(name[1])) != 0;
  const bool unnamed = name[0] == '_';
  std::string key(name);
  if (numbered) {  // `_12abc` is `_12`
    std::size_t end = 1;
    while (end < key.size() && std::isdigit(static_cast<unsigned char>(key[end])) != 0) ++end;
    key.resize(end);
  }
  if (!unnamed || numbered) {
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
  }
  const Symbol symbol = unnamed ? names::unnamed : symbols_.symbol(name);
  Value made;
  const auto number = static_cast<std::uint32_t>(slot_names_.size());
  slot_names_.push_back(symbol);
  if (kind_ == Kind::slots) {
    made = Value::slot(number);
  } else {
    made = heap_.variable(symbol);
  }
  if (!unnamed || numbered) known_.emplace(std::move(key), made);
  return made;
}

void Translator::add_function(std::string_view name, std::size_t arity) {
  functions_.emplace_back(name, arity);
}

bool Translator::is_function(std::string_view name, std::size_t arity) const {
  const bool own = std::any_of(functions_.begin(), functions_.end(), [&](const auto& function) {
    return function.first == name && function.second == arity;
  });
  return own || actions_.function(name, arity) != nullptr;
}

Symbol Translator::resolve_namespace(std::string_view written) {
  const Symbol symbol = symbols_.symbol(written);
  if (written == "this_ns") return module_;
  const auto found = renamed_.find(symbol);
  return found == renamed_.end() ? symbol : found->second;
}

Symbol Translator::namespace_of(const ast::Node& node, std::size_t arity) {
  if (node.ns != nullptr && node.ns->kind == ast::Kind::literal) {
    return resolve_namespace(node.ns->text);
  }
  if (node.this_namespace) return module_;
  if (node.ns != nullptr || namespace_ == names::default_ns) return names::default_ns;
  if (node.dotted || is_keyword(node.text, arity)) return names::default_ns;
  return namespace_;
}

namespace {
// The atom `this_ns`, as a term the name of the module.
bool names_module(const ast::Node& node) {
  return node.kind == ast::Kind::literal && node.text == "this_ns" && node.args.empty() &&
         node.ns == nullptr && !node.negated;
}
}  // namespace

Value Translator::term(const ast::Node& node, VariableScope& scope) {
  const Symbol outer = std::exchange(namespace_, names::default_ns);
  const bool is_module = names_module(node);
  const Value made = is_module ? Value::atom(symbols_.predicate(Signature{.functor = module_}))
                               : translate(node, scope);
  namespace_ = outer;
  return made;
}

Value Translator::translate(const ast::Node& node, VariableScope& scope) {
  switch (node.kind) {
    case ast::Kind::number:
      return Value::number(node.number);
    case ast::Kind::string:
      return heap_.text(node.text);
    case ast::Kind::variable:
      return translate_variable(node, scope);
    case ast::Kind::literal:
      return translate_literal(node, scope);
    case ast::Kind::truth:
      return Value::atom(node.text == "true" ? predicates::truth : predicates::falsity);
    case ast::Kind::list:
      return translate_list(node, scope);
    case ast::Kind::unary:
      return translate_unary(node, scope);
    case ast::Kind::binary:
      return translate_binary(node, scope);
    case ast::Kind::body:
      return body(node.formulas, scope);
    case ast::Kind::trigger:
      return trigger(*node.trigger, scope);
    case ast::Kind::plan:
      return plan(*node.plan, scope);
    case ast::Kind::rule: {
      const std::array<Value, 2> parts{literal(*node.args[0], scope),
                                       formula(*node.args[1], scope)};
      return heap_.structure(symbols_.predicate(Signature{.functor = names::rule_text, .arity = 2}),
                             parts, Value::empty_list(), Form::rule);
    }
  }
  return {};
}

Value Translator::annotations(const ast::Node* annots, VariableScope& scope) {
  return annots == nullptr ? Value::empty_list()
                           : sorted_set(heap_, translate_list(*annots, scope), symbols_);
}

Predicate Translator::predicate_of(const ast::Node& node) {
  Signature signature{.ns = namespace_of(node, node.args.size()),
                      .functor = last_signature_.functor,
                      .arity = static_cast<std::uint16_t>(node.args.size()),
                      .negated = node.negated};
  if (node.text == last_functor_ && signature == last_signature_) return last_predicate_;
  signature.functor = symbols_.symbol(node.text);
  const Predicate predicate = symbols_.predicate(signature);
  if (!node.args.empty()) {
    last_functor_ = symbols_.text(signature.functor);
    last_signature_ = signature;
    last_predicate_ = predicate;
  }
  return predicate;
}

namespace {
// `.include(File)`, which names no namespace.
bool is_include(const ast::Node& node) {
  return node.dotted && node.text == ".include" && node.args.size() == 1;
}
}  // namespace

Value Translator::translate_literal(const ast::Node& node, VariableScope& scope,
                                    Value unless_annotated) {
  const std::size_t first = args_.size();
  for (const ast::Node* arg : node.args) args_.push_back(term(*arg, scope));
  Predicate predicate = predicate_of(node);
  if (is_include(node) && namespace_ != names::default_ns) {
    // As in Jason a module includes a file into itself.
    args_.push_back(Value::atom(symbols_.predicate(Signature{.functor = namespace_})));
    predicate = symbols_.predicate(node.text, 2);
  }
  const bool function = !node.negated && node.dotted && is_function(node.text, node.args.size());
  const Value annots = node.annots == nullptr ? unless_annotated : annotations(node.annots, scope);
  const Value made = heap_.structure(predicate, std::span<const Value>(args_).subspan(first),
                                     annots, function ? Form::function : Form::literal);
  args_.resize(first);
  if (node.ns == nullptr || node.ns->kind != ast::Kind::variable) return made;
  // The namespace is a variable: known when the literal is applied.
  const std::array<Value, 2> parts{made, scope.variable(node.ns->text)};
  return heap_.structure(
      symbols_.predicate(Signature{.functor = names::decorated_text, .arity = 2}), parts,
      Value::empty_list(), Form::decorated);
}

// A variable at the place of a literal stands for a literal of the namespace in force.
Value Translator::translate_variable(const ast::Node& node, VariableScope& scope) {
  const Value variable = scope.variable(node.text);
  const Symbol ns = node.this_namespace ? module_ : namespace_;
  const bool is_plain = node.ns == nullptr && ns == names::default_ns && !node.this_namespace;
  if (!node.negated && is_plain && node.annots == nullptr) return variable;
  std::vector<Value> parts{variable};
  if (node.ns == nullptr) {
    if (!is_plain) parts.push_back(Value::atom(symbols_.predicate(Signature{.functor = ns})));
  } else {
    parts.push_back(node.ns->kind == ast::Kind::variable
                        ? scope.variable(node.ns->text)
                        : Value::atom(symbols_.predicate(
                              Signature{.functor = resolve_namespace(node.ns->text)})));
  }
  const Predicate predicate =
      symbols_.predicate(Signature{.functor = names::decorated_text,
                                   .arity = static_cast<std::uint16_t>(parts.size()),
                                   .negated = node.negated});
  return heap_.structure(predicate, parts, annotations(node.annots, scope), Form::decorated);
}

Value Translator::translate_list(const ast::Node& node, VariableScope& scope) {
  std::vector<Value> elements;
  elements.reserve(node.args.size());
  for (const ast::Node* element : node.args) elements.push_back(term(*element, scope));
  const Value tail = node.tail == nullptr ? Value::empty_list() : term(*node.tail, scope);
  return heap_.list(elements, tail);
}

Value Translator::translate_unary(const ast::Node& node, VariableScope& scope) {
  const bool is_formula = node.op == ast::Operator::logical_not;
  const Value operand = is_formula ? formula(*node.args[0], scope) : term(*node.args[0], scope);
  if (node.op == ast::Operator::positive) return operand;
  if (node.op == ast::Operator::negative && operand.is_number()) {
    return Value::number(-operand.as_number());
  }
  const std::array<Value, 1> args{operand};
  return heap_.structure(operator_predicate(node.op), args, Value::empty_list(),
                         is_formula ? Form::logical : Form::expression);
}

Value Translator::translate_binary(const ast::Node& node, VariableScope& scope) {
  const Form form = operator_form(node.op);
  const auto part = [&](const ast::Node& written) {
    if (form == Form::expression) return term(written, scope);
    return form == Form::relation ? operand(written, scope) : formula(written, scope);
  };
  const std::array<Value, 2> args{part(*node.args[0]), part(*node.args[1])};
  return heap_.structure(operator_predicate(node.op), args, Value::empty_list(), form);
}

// A literal or variable on a side of a relation is a term: it is in the default namespace, even if
// the module's own is written. Formulas and programs there are the module's.
Value Translator::operand(const ast::Node& node, VariableScope& scope) {
  if (node.kind != ast::Kind::literal && node.kind != ast::Kind::variable) {
    return translate(node, scope);
  }
  if (names_module(node)) return term(node, scope);
  const bool has_own_prefix =
      node.this_namespace || (node.ns != nullptr && node.ns->kind == ast::Kind::literal &&
                              resolve_namespace(node.ns->text) == namespace_);
  const Symbol outer = std::exchange(namespace_, names::default_ns);
  ast::Node bare = node;
  if (has_own_prefix) {
    bare.ns = nullptr;
    bare.this_namespace = false;
  }
  const Value made = translate(bare, scope);
  namespace_ = outer;
  return made;
}

// `if`, `for`, `while` and forks are internal actions by name, whose arguments are not terms: they
// are formulas and bodies of the module.
Value Translator::statement(const ast::Formula& formula, VariableScope& scope) {
  const ast::Node& node = *formula.node;
  const bool is_fork =
      formula.statement == ast::Statement::fork_and || formula.statement == ast::Statement::fork_or;
  std::vector<Value> args;
  args.reserve(node.args.size());
  for (const ast::Node* arg : node.args) {
    const bool is_mode = is_fork && args.empty();
    args.push_back(is_mode ? term(*arg, scope) : translate(*arg, scope));
    if (arg->kind == ast::Kind::body) args.back().structure()->info |= Structure::kBare;
  }
  const Signature signature{.functor = symbols_.symbol(node.text),
                            .arity = static_cast<std::uint16_t>(args.size())};
  return heap_.structure(symbols_.predicate(signature), args);
}

Value Translator::step(const ast::Formula& formula, VariableScope& scope) {
  const double place = source_ == nullptr ? 0 : encode(step_place(*source_, formula.span));
  const bool is_statement = formula.statement != ast::Statement::formula;
  const std::array<Value, 2> args{
      is_statement ? statement(formula, scope) : translate(*formula.node, scope),
      Value::number(place)};
  const Predicate predicate =
      symbols_.predicate(Signature{.functor = body_operator(formula.op), .arity = 2});
  return heap_.structure(predicate, args, Value::empty_list(), Form::step);
}

Value Translator::body(std::span<const ast::Formula> formulas, VariableScope& scope) {
  std::vector<Value> steps;
  steps.reserve(formulas.size());
  for (const ast::Formula& formula : formulas) {
    // A body within parentheses is just a part of the body around it.
    if (formula.op == ast::BodyOperator::none && formula.node->kind == ast::Kind::body) {
      const Value inner = body(formula.node->formulas, scope);
      const auto inner_steps = inner.structure()->arg_span();
      steps.insert(steps.end(), inner_steps.begin(), inner_steps.end());
    } else {
      steps.push_back(step(formula, scope));
    }
  }
  const Predicate predicate = symbols_.predicate(
      Signature{.functor = names::body_text, .arity = static_cast<std::uint16_t>(steps.size())});
  return heap_.structure(predicate, steps, Value::empty_list(), Form::body);
}

Value Translator::trigger(const ast::Trigger& trigger, VariableScope& scope) {
  std::string op = trigger.op == ast::TriggerOperator::add      ? "+"
                   : trigger.op == ast::TriggerOperator::remove ? "-"
                                                                : "^";
  if (trigger.kind == ast::TriggerKind::achieve) op += '!';
  if (trigger.kind == ast::TriggerKind::test) op += '?';
  const std::array<Value, 1> args{literal(*trigger.literal, scope)};
  return heap_.structure(symbols_.predicate(op, 1), args, Value::empty_list(), Form::trigger);
}

namespace {
bool is_true(const ast::Node& node) { return node.kind == ast::Kind::truth && node.text == "true"; }
}  // namespace

Value Translator::label(const ast::Plan& plan, VariableScope& scope) {
  if (plan.label == nullptr) return {};
  if (plan.label->kind == ast::Kind::list) {
    // `@[atomic]`: annotations of a label without a name.
    return heap_.structure(symbols_.predicate("", 0), {}, annotations(plan.label, scope));
  }
  if (!plan.label->args.empty()) {
    return heap_.structure(symbols_.predicate("", 0), {}, annotations(plan.label->annots, scope));
  }
  return literal(*plan.label, scope);
}

Value Translator::plan(const ast::Plan& plan, VariableScope& scope) {
  const Symbol outer = std::exchange(namespace_, names::default_ns);
  const Value made = label(plan, scope);
  namespace_ = outer;
  return plan_with_label(made, plan, scope);
}

Value Translator::program_plan(const ast::Plan& plan, VariableScope& scope) {
  return plan_with_label(label(plan, scope), plan, scope);
}

Value Translator::plan_with_label(Value label, const ast::Plan& plan, VariableScope& scope) {
  std::array<Value, 6> parts{
      label, trigger(plan.trigger, scope),
      // A context `true` is none.
      plan.context == nullptr || is_true(*plan.context) ? Value() : formula(*plan.context, scope),
      body(plan.body, scope),
      plan.goal_condition == nullptr ? Value() : formula(*plan.goal_condition, scope), Value()};
  for (const std::size_t part : {std::size_t{1}, std::size_t{3}}) {
    parts[part].structure()->info |= Structure::kBare;
  }
  return heap_.structure(symbols_.predicate(Signature{.functor = names::plan_text, .arity = 6}),
                         parts, Value::empty_list(), Form::plan);
}

}  // namespace jaywalk

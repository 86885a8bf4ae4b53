#include "interpreter/compile/translator.h"

#include <algorithm>
#include <array>
#include <cctype>

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
  if (name == "source") return arity == 1;
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
  if (!is_dotted(name)) return false;
  const bool own = std::any_of(functions_.begin(), functions_.end(), [&](const auto& function) {
    return function.first == name && function.second == arity;
  });
  return own || actions_.function(name, arity) != nullptr;
}

Symbol Translator::resolve_namespace(std::string_view written) {
  const Symbol symbol = symbols_.symbol(written);
  if (written == "this_ns") return namespace_;
  const auto found = renamed_.find(symbol);
  return found == renamed_.end() ? symbol : found->second;
}

Symbol Translator::namespace_of(const ast::Node& node, Position position, std::size_t arity) {
  if (node.ns != nullptr && node.ns->kind == ast::Kind::literal) {
    return resolve_namespace(node.ns->text);
  }
  if (node.this_namespace) return namespace_;
  if (node.ns != nullptr || position == Position::term) return names::default_ns;
  if (is_dotted(node.text) || is_keyword(node.text, arity)) return names::default_ns;
  return namespace_;
}

Value Translator::translate(const ast::Node& node, VariableScope& scope, Position position) {
  switch (node.kind) {
    case ast::Kind::number:
      return Value::number(node.number);
    case ast::Kind::string:
      return heap_.text(node.text);
    case ast::Kind::variable:
      return translate_variable(node, scope);
    case ast::Kind::literal:
      return translate_literal(node, scope, position);
    case ast::Kind::truth:
      return Value::atom(node.text == "true" ? predicates::truth : predicates::falsity);
    case ast::Kind::list:
      return translate_list(node, scope);
    case ast::Kind::unary:
      return translate_unary(node, scope, position);
    case ast::Kind::binary:
      return translate_binary(node, scope, position);
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

Value Translator::translate_literal(const ast::Node& node, VariableScope& scope,
                                    Position position) {
  if (node.text == "this_ns" && position == Position::term && node.args.empty() &&
      node.ns == nullptr && !node.negated) {
    return Value::atom(symbols_.predicate(Signature{.functor = namespace_}));
  }
  std::vector<Value> args;
  args.reserve(node.args.size());
  for (const ast::Node* arg : node.args) args.push_back(term(*arg, scope));
  const Signature signature{.ns = namespace_of(node, position, args.size()),
                            .functor = symbols_.symbol(node.text),
                            .arity = static_cast<std::uint16_t>(args.size()),
                            .negated = node.negated};
  const bool function = !node.negated && is_function(node.text, args.size());
  const Value made =
      heap_.structure(symbols_.predicate(signature), args, annotations(node.annots, scope),
                      function ? Form::function : Form::literal);
  if (node.ns == nullptr || node.ns->kind != ast::Kind::variable) return made;
  // The namespace is a variable: known when the literal is applied.
  const std::array<Value, 2> parts{made, translate_variable(*node.ns, scope)};
  return heap_.structure(
      symbols_.predicate(Signature{.functor = names::decorated_text, .arity = 2}), parts,
      Value::empty_list(), Form::decorated);
}

Value Translator::translate_variable(const ast::Node& node, VariableScope& scope) {
  const Value variable = scope.variable(node.text);
  if (!node.negated && node.ns == nullptr && node.annots == nullptr && !node.this_namespace) {
    return variable;
  }
  std::vector<Value> parts{variable};
  if (node.this_namespace) {
    parts.push_back(Value::atom(symbols_.predicate(Signature{.functor = namespace_})));
  } else if (node.ns != nullptr) {
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

Value Translator::translate_unary(const ast::Node& node, VariableScope& scope, Position position) {
  const Value operand = translate(
      *node.args[0], scope, node.op == ast::Operator::logical_not ? position : Position::term);
  if (node.op == ast::Operator::positive) return operand;
  if (node.op == ast::Operator::negative && operand.is_number()) {
    return Value::number(-operand.as_number());
  }
  const std::array<Value, 1> args{operand};
  return heap_.structure(operator_predicate(node.op), args, Value::empty_list(),
                         node.op == ast::Operator::logical_not ? Form::logical : Form::expression);
}

Value Translator::translate_binary(const ast::Node& node, VariableScope& scope, Position position) {
  const Form form = operator_form(node.op);
  const Position inner = form == Form::logical ? position : Position::term;
  const std::array<Value, 2> args{translate(*node.args[0], scope, inner),
                                  translate(*node.args[1], scope, inner)};
  return heap_.structure(operator_predicate(node.op), args, Value::empty_list(), form);
}

Value Translator::step(const ast::Formula& formula, VariableScope& scope) {
  const Position position =
      formula.node->kind == ast::Kind::body ? Position::term : Position::literal;
  const double line =
      source_ == nullptr ? 0 : static_cast<double>(source_->position(formula.span.begin).line);
  const std::array<Value, 2> args{translate(*formula.node, scope, position), Value::number(line)};
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

Value Translator::plan(const ast::Plan& plan, VariableScope& scope) {
  Value label;
  if (plan.label != nullptr && plan.label->kind == ast::Kind::list) {
    // `@[atomic]`: annotations of a label without a name.
    label = heap_.structure(symbols_.predicate("", 0), {}, annotations(plan.label, scope));
  } else if (plan.label != nullptr && !plan.label->args.empty()) {
    label = heap_.structure(symbols_.predicate("", 0), {}, annotations(plan.label->annots, scope));
  } else if (plan.label != nullptr) {
    label = literal(*plan.label, scope);
  }
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

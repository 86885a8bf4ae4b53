// SPDX-License-Identifier: Apache-2.0
#include "tests/property/syntax/generator.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace jaywalk {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Operator;
using ast::Statement;

Node* SyntaxGenerator::make(Kind kind, std::string_view text) {
  Node* const node =
      std::construct_at(static_cast<Node*>(arena_.allocate(sizeof(Node), alignof(Node))));
  node->kind = kind;
  node->text = text;
  return node;
}

template <class T>
std::span<const T> SyntaxGenerator::keep(const std::vector<T>& items) {
  if (items.empty()) return {};
  auto* const storage = static_cast<T*>(arena_.allocate(items.size() * sizeof(T), alignof(T)));
  std::uninitialized_copy(items.begin(), items.end(), storage);
  return {storage, items.size()};
}

std::string_view SyntaxGenerator::keep(std::string_view text) {
  auto* const storage = static_cast<char*>(arena_.allocate(text.size() + 1, 1));
  std::copy(text.begin(), text.end(), storage);
  return {storage, text.size()};
}

// Arguments, annotations and namespaces may follow a functor.
Node* SyntaxGenerator::name(Kind kind, std::string_view text, int depth) {
  Node* const node = make(kind, text);
  if (depth > 0 && kind == Kind::literal && chance(50)) {
    Nodes args;
    for (int i = 1 + pick(3); i > 0; --i) args.push_back(term(depth - 1));
    node->args = keep(args);
  }
  return node;
}

Node* SyntaxGenerator::literal(int depth) {
  Node* const node = name(
      Kind::literal, one_of({"a", "b1", "isOn", "'quoted atom'", "begin", "end", "x_y"}), depth);
  node->negated = chance(10);
  if (depth > 0 && chance(15)) node->annots = list(depth - 1);
  if (chance(5)) {
    node->this_namespace = true;
  } else if (chance(5)) {
    node->ns = chance(50) ? make(Kind::literal, "space") : make(Kind::variable, "N");
  }
  return node;
}

Node* SyntaxGenerator::internal_action(int depth) {
  return name(Kind::literal, one_of({".print", "math.max", "my.own.action", ".count"}), depth);
}

Node* SyntaxGenerator::variable(int depth) {
  Node* const node = make(Kind::variable, one_of({"X", "Yz_1", "_", "_Any", "_12"}));
  if (depth > 0 && chance(10)) node->annots = list(depth - 1);
  return node;
}

Node* SyntaxGenerator::number() {
  Node* const node = make(Kind::number);
  constexpr double kNumbers[] = {0, 1, 42, 0.5, 1e20, 1.5e-7, 9007199254740992.0, 123456.789};
  node->number = kNumbers[pick(8)];
  return node;
}

Node* SyntaxGenerator::string() {
  std::string text;
  for (int i = pick(5); i > 0; --i) {
    text += one_of({"a", " ", "\n", "\"", "\\t", "\\\\", "ä", "//", "'", "."});
  }
  return make(Kind::string, keep(text));
}

Node* SyntaxGenerator::list(int depth) {
  Node* const node = make(Kind::list);
  Nodes elements;
  for (int i = pick(4); i > 0; --i) elements.push_back(term(depth - 1));
  node->args = keep(elements);
  if (chance(25)) node->tail = chance(50) ? make(Kind::variable, "T") : list(depth - 1);
  return node;
}

Node* SyntaxGenerator::operation(Operator op, Nodes operands) {
  Node* const node = make(operands.size() == 1 ? Kind::unary : Kind::binary);
  node->op = op;
  node->args = keep(operands);
  return node;
}

Node* SyntaxGenerator::arithmetic(int depth) {
  if (depth <= 0) return chance(50) ? number() : variable(0);
  if (chance(20)) {
    return operation(chance(80) ? Operator::negative : Operator::positive, {arithmetic(depth - 1)});
  }
  if (chance(10)) return internal_action(depth - 1);
  if (chance(20)) return arithmetic(0);
  const auto op = static_cast<Operator>(static_cast<int>(Operator::add) + pick(7));
  Node* const left = arithmetic(depth - 1);
  return operation(op, {left, arithmetic(depth - 1)});
}

Node* SyntaxGenerator::operand(int depth) {
  switch (pick(depth > 0 ? 6 : 3)) {
    case 0:
      return arithmetic(depth);
    case 1:
      return literal(depth);
    case 2:
      return string();
    case 3:
      return list(depth - 1);
    case 4:
      return brace(depth - 1);
    default:
      return internal_action(depth - 1);
  }
}

Node* SyntaxGenerator::formula(int depth) {
  if (depth <= 0) {
    return chance(80) ? literal(0) : make(Kind::truth, one_of({"true", "false"}));
  }
  switch (pick(6)) {
    case 0:
      return operation(Operator::logical_not, {formula(depth - 1)});
    case 1:
    case 2: {
      Node* const left = formula(depth - 1);
      return operation(chance(50) ? Operator::logical_and : Operator::logical_or,
                       {left, formula(depth - 1)});
    }
    case 3: {
      const auto op = static_cast<Operator>(static_cast<int>(Operator::less) + pick(8));
      Node* const left = operand(depth - 1);
      return operation(op, {left, operand(depth - 1)});
    }
    case 4:
      return internal_action(depth - 1);
    default:
      return literal(depth);
  }
}

const Node* SyntaxGenerator::term(int depth) {
  return chance(40) ? formula(depth) : operand(depth);
}

Node* SyntaxGenerator::body_term(int depth, int least) {
  Node* const node = make(Kind::body);
  node->formulas = keep(body(depth, least));
  return node;
}

SyntaxGenerator::Formulas SyntaxGenerator::body(int depth, int least) {
  Formulas formulas;
  for (int i = least + pick(3); i > 0; --i) formulas.push_back(body_formula(depth));
  return formulas;
}

ast::Formula SyntaxGenerator::body_formula(int depth) {
  if (depth > 0 && chance(25)) return statement(depth - 1);
  ast::Formula formula;
  formula.op = static_cast<BodyOperator>(pick(11));
  if (formula.op == BodyOperator::none && depth > 0 && chance(10)) {
    Node* const inner = body_term(depth - 1, 1);
    inner->parenthesised = true;
    formula.node = inner;
  } else if (formula.op == BodyOperator::none || formula.op == BodyOperator::test) {
    formula.node = this->formula(depth);
  } else if (formula.op == BodyOperator::add && depth > 0 && chance(20)) {
    formula.node = brace(depth - 1);
  } else {
    formula.node = chance(80) ? literal(depth) : variable(depth);
  }
  return formula;
}

ast::Formula SyntaxGenerator::statement(int depth) {
  ast::Formula made;
  made.statement = static_cast<Statement>(1 + pick(5));
  Nodes args;
  std::string_view functor = ".fork";
  switch (made.statement) {
    case Statement::formula:
    case Statement::if_statement:
      functor = ".if_then_else";
      args = {formula(depth), body_term(depth, 0)};
      if (chance(50)) args.push_back(body_term(depth, 0));
      break;
    case Statement::for_loop:
      functor = ".foreach";
      args = {formula(depth), body_term(depth, 0)};
      break;
    case Statement::while_loop:
      functor = ".loop";
      args = {formula(depth), body_term(depth, 0)};
      break;
    case Statement::fork_and:
    case Statement::fork_or:
      args = {make(Kind::literal, made.statement == Statement::fork_and ? "and" : "or")};
      for (int i = 2 + pick(2); i > 0; --i) args.push_back(body_term(depth, 1));
      break;
  }
  Node* const node = make(Kind::literal, functor);
  node->args = keep(args);
  made.node = node;
  return made;
}

ast::Trigger SyntaxGenerator::trigger(int depth) {
  ast::Trigger made;
  made.op = static_cast<ast::TriggerOperator>(pick(3));
  made.kind = static_cast<ast::TriggerKind>(pick(3));
  made.literal = chance(90) ? literal(depth) : variable(depth);
  return made;
}

const ast::Plan* SyntaxGenerator::plan(int depth, bool is_term) {
  auto* const made = std::construct_at(
      static_cast<ast::Plan*>(arena_.allocate(sizeof(ast::Plan), alignof(ast::Plan))));
  if (chance(30)) {
    Node* const label = make(Kind::literal, one_of({"l1", "end", "p.q"}));
    if (chance(50)) label->annots = list(depth - 1);
    made->label = chance(20) ? list(depth - 1) : label;
  }
  made->trigger = trigger(depth);
  if (chance(50)) made->context = formula(depth);
  made->has_body = is_term || chance(70);
  if (made->has_body) made->body = keep(body(depth, 0));
  if (is_term) return made;
  if (chance(10)) made->goal_condition = formula(depth);
  if (depth > 0 && chance(20)) {
    std::vector<const ast::Plan*> subplans;
    for (int i = 1 + pick(2); i > 0; --i) subplans.push_back(plan(depth - 1, false));
    made->subplans = keep(subplans);
  }
  return made;
}

// A trigger without a kind, `{ +b }`, would be a body; a plan must be more than a trigger.
Node* SyntaxGenerator::brace(int depth) {
  switch (pick(4)) {
    case 0: {
      ast::Trigger made = trigger(depth);
      if (made.kind == ast::TriggerKind::belief) made.kind = ast::TriggerKind::achieve;
      Node* const node = make(Kind::trigger);
      node->trigger = keep(std::vector{made}).data();
      return node;
    }
    case 1: {
      Node* const node = make(Kind::plan);
      node->plan = plan(depth, true);
      return node;
    }
    case 2: {
      Node* const node = make(Kind::rule);
      Node* const head = literal(depth);
      node->args = keep(Nodes{head, formula(depth)});
      return node;
    }
    default:
      return body_term(depth, 0);
  }
}

ast::Component SyntaxGenerator::component(int depth) {
  ast::Component made;
  made.kind = static_cast<ast::ComponentKind>(pick(depth > 0 ? 4 : 3));
  switch (made.kind) {
    case ast::ComponentKind::belief:
      made.literal = literal(depth);
      if (chance(50)) made.body = formula(depth);
      break;
    case ast::ComponentKind::goal:
      made.literal = chance(90) ? literal(depth) : variable(depth);
      break;
    case ast::ComponentKind::plan:
      made.plan = plan(depth, false);
      break;
    case ast::ComponentKind::directive:
      made.literal = name(Kind::literal, one_of({"include", "namespace", "dg"}), depth);
      made.is_block = chance(50);
      if (made.is_block) {
        std::vector<ast::Component> inner;
        for (int i = pick(3); i > 0; --i) inner.push_back(component(depth - 1));
        made.inner = keep(inner);
      }
      break;
  }
  return made;
}

}  // namespace jaywalk

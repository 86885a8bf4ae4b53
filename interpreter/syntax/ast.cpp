// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/ast.h"

#include <array>

namespace jaywalk::ast {

bool is_arithmetic(const Node& node) {
  return (node.kind == Kind::binary && node.op >= Operator::add) ||
         (node.kind == Kind::unary && node.op != Operator::logical_not);
}

std::string_view description_of(const Node& node) {
  switch (node.kind) {
    case Kind::number:
      return "a number";
    case Kind::string:
      return "a string";
    case Kind::list:
      return "a list";
    case Kind::variable:
      return "a variable";
    case Kind::truth:
      return "'true' or 'false'";
    case Kind::literal:
      return is_internal(node) ? "an internal action" : "a literal";
    case Kind::unary:
    case Kind::binary:
      return is_arithmetic(node) ? "an arithmetic expression" : "a logical formula";
    case Kind::body:
      return "a plan body";
    case Kind::trigger:
      return "a trigger";
    case Kind::plan:
      return "a plan";
    case Kind::rule:
      return "a rule";
  }
  return "";
}

std::string_view spelling_of(Operator op) {
  // In the order of the enumeration, from `none` to `power`.
  static constexpr std::array<std::string_view, 21> kSpellings{
      "",       "-",   "+",     "not ", " & ", " | ", " < ", " <= ",  " > ",   " >= ", " == ",
      " \\== ", " = ", " =.. ", "+",    "-",   "*",   "/",   " div ", " mod ", "**"};
  return kSpellings[static_cast<std::size_t>(op)];
}

std::string_view spelling_of(BodyOperator op) {
  // From `none` to `replace`.
  static constexpr std::array<std::string_view, 11> kSpellings{"",   "!",  "!!", "?",  "+", "++",
                                                               "+<", "+>", "-",  "--", "-+"};
  return kSpellings[static_cast<std::size_t>(op)];
}

std::string_view spelling_of(const Trigger& trigger) {
  const bool add = trigger.op == TriggerOperator::add;
  const bool remove = trigger.op == TriggerOperator::remove;
  switch (trigger.kind) {
    case TriggerKind::belief:
      return add ? "+" : remove ? "-" : "^";
    case TriggerKind::achieve:
      return add ? "+!" : remove ? "-!" : "^!";
    case TriggerKind::test:
      return add ? "+?" : remove ? "-?" : "^?";
  }
  return "";
}

}  // namespace jaywalk::ast

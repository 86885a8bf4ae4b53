// SPDX-License-Identifier: Apache-2.0
// Comparisons that cannot be meant: of different types, of constants, of a term with itself.

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "interpreter/check/checking.h"
#include "interpreter/check/index/traversal.h"
#include "interpreter/syntax/ast.h"
#include "interpreter/syntax/printer.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;
using ast::Operator;
using Role = Condition::Role;

bool is_relation(const Node& node) {
  return node.kind == Kind::binary && node.op >= Operator::less && node.op <= Operator::unify;
}

/// Calls `visit(relation)` for each comparison that the formula is made of.
template <class Visit>
void each_relation(const Node& formula, Visit&& visit) {
  if (is_relation(formula)) visit(formula);
  const bool logical = formula.op == Operator::logical_and || formula.op == Operator::logical_or ||
                       formula.op == Operator::logical_not;
  if (logical) {
    for (const Node* operand : formula.args) each_relation(*operand, visit);
  }
}

// The type of a term whatever its variables are; empty if it depends on them.
std::string_view type_of(const Node& node) {
  if (node.kind == Kind::number || ast::is_arithmetic(node)) return "a number";
  if (node.kind == Kind::string) return "a string";
  if (node.kind == Kind::list) return "a list";
  if (node.kind == Kind::literal && !ast::is_internal(node)) return "a literal";
  return {};
}

// A number in quotes.
bool is_quoted_number(const Node& node) {
  if (node.kind != Kind::string) return false;
  const char* const end = node.text.data() + node.text.size();
  double number = 0;
  const auto [rest, error] = std::from_chars(node.text.data(), end, number);
  return error == std::errc() && rest == end;
}

bool is_bare_word(const Node& node) { return node.kind == Kind::literal && node.args.empty(); }

std::optional<double> value_of(const Node& node) {
  if (node.kind == Kind::number) return node.number;
  if (!ast::is_arithmetic(node)) return std::nullopt;
  const std::optional<double> left = value_of(*node.args[0]);
  if (node.kind == Kind::unary) {
    return left && node.op == Operator::negative ? std::optional(-*left) : left;
  }
  const std::optional<double> right = value_of(*node.args[1]);
  if (!left || !right) return std::nullopt;
  switch (node.op) {
    case Operator::add:
      return *left + *right;
    case Operator::subtract:
      return *left - *right;
    case Operator::multiply:
      return *left * *right;
    case Operator::divide:
      return *left / *right;
    case Operator::power:
      return std::pow(*left, *right);
    default:
      return std::nullopt;
  }
}

// No variable and no function in it.
bool is_constant(const Node& node) {
  bool constant = true;
  each_node(node, [&](const Node& each) {
    constant &= each.kind != Kind::variable && !ast::is_internal(each);
  });
  return constant;
}

bool holds(Operator op, int order) {
  switch (op) {
    case Operator::less:
      return order < 0;
    case Operator::less_equal:
      return order <= 0;
    case Operator::greater:
      return order > 0;
    case Operator::greater_equal:
      return order >= 0;
    case Operator::not_equal:
      return order != 0;
    default:
      return order == 0;
  }
}

// Each occurrence of it may stand for something else: `_`, `math.random`.
bool varies(const Node& node) {
  bool different = false;
  each_node(node, [&](const Node& each) {
    different |=
        (each.kind == Kind::variable && each.text.front() == '_') || ast::is_internal(each);
  });
  return different;
}

// How the sides are ordered, if that depends on nothing.
std::optional<int> constant_order(const Node& relation) {
  const Node& left = *relation.args[0];
  const Node& right = *relation.args[1];
  const auto x = value_of(left);
  const auto y = value_of(right);
  // A comparison with NaN is decided by the engine's own rules: nothing is said of it.
  if (x && y && !std::isnan(*x) && !std::isnan(*y)) return *x < *y ? -1 : static_cast<int>(*x > *y);
  if (print(left) == print(right) && !varies(left)) return 0;
  // Different constants are unequal, but which is less depends on the order of all terms: not said.
  const bool ordered = relation.op < Operator::equal;
  if (!ordered && is_constant(left) && is_constant(right) && left.kind == right.kind &&
      left.annots == nullptr && right.annots == nullptr && left.ns == nullptr &&
      right.ns == nullptr && left.args.empty() && right.args.empty() && left.tail == nullptr &&
      right.tail == nullptr && left.kind != Kind::body) {
    return 1;
  }
  return std::nullopt;
}

// `N = N + 1`: there is no assignment.
bool is_assignment(const Node& relation) {
  const Node& left = *relation.args[0];
  const Node& right = *relation.args[1];
  if (relation.op != Operator::unify || left.kind != Kind::variable) return false;
  return (right.op == Operator::add || right.op == Operator::subtract) &&
         ((right.args[0]->kind == Kind::variable && right.args[0]->text == left.text &&
           value_of(*right.args[1]).value_or(0) != 0) ||
          (right.args[1]->kind == Kind::variable && right.args[1]->text == left.text &&
           value_of(*right.args[0]).value_or(0) != 0));
}

void judge(Checking& checking, CheckedFile& file, const Node& relation) {
  if (is_assignment(relation)) {
    checking.warn(file, relation.span,
                  fmt::format("'{}' is no assignment: a variable keeps its value", print(relation)),
                  "use a new variable");
    return;
  }
  const auto order = constant_order(relation);
  if (!order) return;
  checking.warn(file, relation.span,
                fmt::format("'{}' is always {}", print(relation),
                            holds(relation.op, *order) ? "true" : "false"));
}

// The formulas that a conjunction consists of.
void conjuncts(const Node& formula, std::vector<const Node*>& all) {
  if (formula.op != Operator::logical_and) {
    all.push_back(&formula);
    return;
  }
  conjuncts(*formula.args[0], all);
  conjuncts(*formula.args[1], all);
}

// `p(X) & not p(X)`
void look_for_contradiction(Checking& checking, CheckedFile& file, const Node& formula) {
  std::vector<const Node*> all;
  conjuncts(formula, all);
  if (all.size() < 2) return;
  std::set<std::string> affirmed;
  for (const Node* each : all) {
    if (each->kind == Kind::literal && !ast::is_internal(*each)) affirmed.insert(print(*each));
  }
  for (const Node* each : all) {
    if (each->op != Operator::logical_not || each->args[0]->kind != Kind::literal) continue;
    const std::string denied = print(*each->args[0]);
    if (!affirmed.contains(denied)) continue;
    checking.warn(file, each->span,
                  fmt::format("always false: '{}' must hold and must not hold", denied));
  }
}

// `D < "25"`: a string is greater than every number.
void look_at_quotes(Checking& checking, CheckedFile& file, const Node& relation) {
  if (relation.op >= Operator::equal) return;
  for (const std::size_t side : {0U, 1U}) {
    const Node& text = *relation.args[side];
    if (!is_quoted_number(text) || relation.args[1 - side]->kind != Kind::variable) continue;
    checking.warn(file, text.span,
                  fmt::format("{} is a string, which is greater than every number", print(text)),
                  fmt::format("write {}, without quotes", text.text));
  }
}

void look_at_truth(Checking& checking, CheckedFile& file, const Condition& condition) {
  const Node* node = condition.node;
  const bool negated = node->op == Operator::logical_not;
  if (negated) node = node->args[0];
  if (node->kind != Kind::truth) return;
  const bool value = (node->text == "true") != negated;
  const bool odd = condition.role == Role::statement || (condition.role == Role::context && !value);
  if (!odd) return;
  checking.warn(file, condition.node->span,
                fmt::format("the condition is always {}", value ? "true" : "false"));
}

}  // namespace

void incompatible_types(Checking& checking) {
  for (CheckedFile& file : checking.files()) {
    for (const Condition& condition : file.uses.conditions) {
      each_relation(*condition.node, [&](const Node& relation) {
        look_at_quotes(checking, file, relation);
        const std::string_view left = type_of(*relation.args[0]);
        const std::string_view right = type_of(*relation.args[1]);
        if (left.empty() || right.empty() || left == right) return;
        const bool has_atom = is_bare_word(*relation.args[0]) || is_bare_word(*relation.args[1]);
        checking.warn(file, relation.span, fmt::format("{} is compared with {}", left, right),
                      has_atom ? "variables begin with an upper-case letter" : "");
      });
    }
  }
}

void constant_conditions(Checking& checking) {
  for (CheckedFile& file : checking.files()) {
    for (const Condition& condition : file.uses.conditions) {
      look_at_truth(checking, file, condition);
      each_relation(*condition.node,
                    [&](const Node& relation) { judge(checking, file, relation); });
      look_for_contradiction(checking, file, *condition.node);
    }
  }
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Rules that can only answer by way of themselves.

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "interpreter/check/checking.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;
using ast::Operator;

bool is_same(const Node& a, const Node& b) {
  return a.kind == Kind::literal && a.text == b.text && a.args.size() == b.args.size() &&
         a.negated == b.negated && a.ns == nullptr && b.ns == nullptr;
}

// Whether there is no answer to the formula without one to a literal like the head.
bool needs(const Node& formula, const Node& head) {
  if (formula.op == Operator::logical_and) {
    return needs(*formula.args[0], head) || needs(*formula.args[1], head);
  }
  if (formula.op == Operator::logical_or) {
    return needs(*formula.args[0], head) && needs(*formula.args[1], head);
  }
  return is_same(formula, head);
}

using HeadKey = std::tuple<std::string_view, std::size_t, bool>;

}  // namespace

void endless_rules(Checking& checking) {
  if (checking.index().has_open_beliefs) return;
  std::map<HeadKey, bool> has_base;  // beside facts
  for (const CheckedFile& file : checking.files()) {
    for (const auto& [head, body] : file.uses.clauses) {
      if (body == nullptr) continue;
      has_base[{head->text, head->args.size(), head->negated}] |= !needs(*body, *head);
    }
  }
  for (CheckedFile& file : checking.files()) {
    for (const auto& [head, body] : file.uses.clauses) {
      if (body == nullptr || has_base[{head->text, head->args.size(), head->negated}]) continue;
      if (checking.index().facts.contains(head->text, arity_of(*head))) continue;
      checking.warn(file, head->span,
                    fmt::format("'{}' has no answer: every rule for it needs another '{}'",
                                head->text, head->text),
                    "add a rule or a belief that ends the recursion");
    }
  }
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Random syntax trees, such as the parser could make. The same seed gives the same trees.

#include <cstdint>
#include <initializer_list>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "interpreter/syntax/ast.h"

namespace jaywalk {

class SyntaxGenerator {
 public:
  explicit SyntaxGenerator(std::uint64_t seed) : rng_(seed) {}

  /// A term or formula at most so deep, more or less.
  const ast::Node* term(int depth);
  ast::Component component(int depth);

 private:
  using Nodes = std::vector<const ast::Node*>;
  using Formulas = std::vector<ast::Formula>;

  /// A number from 0 to `count` - 1.
  int pick(int count) { return static_cast<int>(rng_() % static_cast<std::uint64_t>(count)); }
  bool chance(int percent) { return pick(100) < percent; }
  std::string_view one_of(std::initializer_list<std::string_view> texts) {
    return texts.begin()[pick(static_cast<int>(texts.size()))];
  }

  ast::Node* make(ast::Kind kind, std::string_view text = {});
  template <class T>
  std::span<const T> keep(const std::vector<T>& items);
  std::string_view keep(std::string_view text);

  ast::Node* name(ast::Kind kind, std::string_view text, int depth);
  ast::Node* literal(int depth);
  ast::Node* internal_action(int depth);
  ast::Node* variable(int depth);
  ast::Node* number();
  ast::Node* string();
  ast::Node* list(int depth);
  ast::Node* brace(int depth);
  ast::Node* operation(ast::Operator op, Nodes operands);
  ast::Node* arithmetic(int depth);
  ast::Node* operand(int depth);
  ast::Node* formula(int depth);
  ast::Node* body_term(int depth, int least);
  Formulas body(int depth, int least);
  ast::Formula body_formula(int depth);
  ast::Formula statement(int depth);
  ast::Trigger trigger(int depth);
  const ast::Plan* plan(int depth, bool is_term);

  ast::Arena arena_;
  std::mt19937_64 rng_;
};

}  // namespace jaywalk

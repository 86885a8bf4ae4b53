// SPDX-License-Identifier: Apache-2.0
#pragma once

// The semantic actions of the grammar (grammar.cpp): each method is one, and together they build
// the syntax tree on a few stacks. The grammar looks one token ahead and never goes back, so that
// only the recovery from an error undoes actions.

#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/ast.h"
#include "interpreter/syntax/lexer.h"

namespace jaywalk {

class Builder {
 public:
  /// A mistake that the grammar cannot express; it ends the clause.
  struct Failure {
    Span span;
    std::string message;
    std::string hint;
    /// The parser's place when it noticed the mistake.
    std::uint32_t noticed = 0;
  };

  /// `tokens` and `arena` must outlive the builder.
  Builder(SourcePtr source, std::span<const Token> tokens, ast::Arena& arena,
          Diagnostics& diagnostics);

  /// The token that was matched last.
  void consume(const Token& token) {
    token_ = &token;
    next_ = token_ + 1;
  }

  // Bounds the recursion of the grammar; false: too deep, see failure().
  [[nodiscard]] bool enter();
  void leave() { --nesting_; }

  // Terms: each leaves one value on the stack.
  void namespace_prefix();
  void this_namespace_prefix();
  void tilde();
  void begin_literal();
  void begin_variable();
  void end_arguments();
  void attach_annotations();
  void end_literal();
  void end_label();
  void truth();
  void number();
  void string();
  void begin_list();
  void list_tail();
  void end_list();
  void parenthesised();

  // Expressions, by operator precedence: operands and operators in the order of the text.
  void begin_expression();
  void prefix_operator();
  void infix_operator();
  [[nodiscard]] bool end_expression();
  /// Complains about a value (the last one) that cannot be true or false.
  void check_condition();

  // Bodies. Between begin_body and its end stand formulas; `may_continue` says whether there can
  // be another one, after a semicolon or a statement.
  void begin_body();
  [[nodiscard]] bool may_continue() const;
  void semicolon();
  /// Whether the next token begins another formula of the body, though no semicolon says so.
  [[nodiscard]] bool formula_follows() const;
  /// A formula follows another without a semicolon; tolerated, with a warning.
  void missing_semicolon();
  /// The body's formulas as a term on the stack of values.
  void end_body_as_term();
  void begin_formula();
  void formula_operator();
  void end_formula();
  void end_parenthesised_body();
  void begin_fork();
  void end_fork_and() { end_fork(ast::Statement::fork_and); }
  void end_fork_or() { end_fork(ast::Statement::fork_or); }
  void begin_statement();
  void end_if() { end_statement(ast::Statement::if_statement, ".if_then_else"); }
  void end_for() { end_statement(ast::Statement::for_loop, ".foreach"); }
  void end_while() { end_statement(ast::Statement::while_loop, ".loop"); }
  void elif_as_term();

  // Terms in braces.
  void begin_brace();
  void empty_brace();
  void body_brace();
  void rule_brace();
  [[nodiscard]] bool plan_brace_from_body();
  void plan_brace();
  void end_brace();

  // Plans.
  void begin_plan();
  void plan_label();
  /// A label has arguments, which say nothing; tolerated, with a warning.
  void label_arguments();
  void trigger_operator();
  void trigger_kind();
  void end_trigger();
  void plan_context();
  void plan_goal_condition();
  void plan_body();
  void end_plan();
  void subplan();

  // Programs.
  void begin_component();
  void belief_head();
  void belief_body();
  void end_belief();
  void end_goal();
  void end_plan_component();
  void begin_directive();
  void begin_block();
  void end_directive();
  /// A block ends that never began.
  void stray_end();
  void end_component();

  /// Forgets what was begun since the innermost begin_component; the text goes on at `next`.
  void recover(const Token* next);
  /// Reports the mistakes found since the clause began, those noticed before an offset.
  void report_mistakes(std::uint32_t before);

  [[nodiscard]] std::optional<Failure> take_failure();
  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
  [[nodiscard]] const SourcePtr& source() const { return source_; }
  [[nodiscard]] std::span<const Token> tokens() const { return tokens_; }
  /// The first token of the innermost component.
  [[nodiscard]] const Token* clause() const;

  // Results, once everything has been parsed.
  [[nodiscard]] std::span<const ast::Component> components();
  [[nodiscard]] const ast::Node* value() const { return values_.back().node; }
  [[nodiscard]] const ast::Node* values_as_list();
  [[nodiscard]] const ast::Plan* plan() const { return finished_plan_; }

 private:
  struct Value {
    ast::Node* node = nullptr;
    int depth = 1;
  };
  struct FormulaValue {
    ast::Formula formula;
    int depth = 1;
  };
  // An operator that waits for its right operand.
  struct Pending {
    ast::Operator op = ast::Operator::none;
    Span span;
  };
  // A construct whose parts are not all on the stacks yet.
  struct Frame {
    const Token* begin = nullptr;
    ast::Node* node = nullptr;
    int depth = 0;
    std::size_t values = 0;
    std::size_t formulas = 0;
    std::size_t pending = 0;
    ast::BodyOperator op = ast::BodyOperator::none;
    bool may_continue = true;
  };
  struct PlanFrame {
    ast::Plan* plan = nullptr;
    int depth = 0;
    const Token* begin = nullptr;
    std::size_t subplans = 0;
  };
  struct ComponentFrame {
    ast::Component component;
    std::size_t inner = 0;
  };
  struct Checkpoint {
    const Token* begin = nullptr;
    int nesting = 0;
    std::size_t values = 0, formulas = 0, pending = 0, frames = 0, plans = 0, subplans = 0,
                open_components = 0;
  };

  // Storage in the arena.
  template <class T>
  T* make() {
    static_assert(std::is_trivially_destructible_v<T>);
    return std::construct_at(static_cast<T*>(arena_.allocate(sizeof(T), alignof(T))));
  }
  template <class T, class Range>
  std::span<const T> copy(const Range& range) {
    const auto count = static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    if (count == 0) return {};
    auto* const storage = static_cast<T*>(arena_.allocate(count * sizeof(T), alignof(T)));
    std::uninitialized_copy(range.begin(), range.end(), storage);
    return {storage, count};
  }
  ast::Node* make_node(ast::Kind kind, Span span);
  static void set_name(ast::Node& node, std::string_view name);

  [[nodiscard]] Span span_from(const Token* begin) const;
  void begin_frame(const Token* begin);
  Frame end_frame();
  void push_value(ast::Node* node, int depth);
  Value pop_value();
  std::span<const ast::Node* const> pop_values(std::size_t mark, int& depth);
  std::span<const ast::Formula> pop_formulas(std::size_t mark, int& depth);
  void push_formula(ast::Formula formula, int depth);
  void begin_named(ast::Kind kind);
  void reduce();
  void check_formula(const ast::Node& node);
  void check_number(const ast::Node& operand, Span operation);
  void check_body_size(std::span<const ast::Formula> body);
  void check_target(ast::BodyOperator op, const ast::Node& node);
  void end_fork(ast::Statement statement);
  void end_statement(ast::Statement statement, std::string_view functor);
  void check_usable_in_context(const ast::Node& formula);
  void finish_component(ast::ComponentKind kind);
  void error(Span span, std::string message, std::string hint = {});

  SourcePtr source_;
  std::span<const Token> tokens_;
  ast::Arena& arena_;
  Diagnostics& diagnostics_;

  const Token* token_;  // matched last
  const Token* next_;
  const ast::Node* namespace_ = nullptr;
  const Token* prefix_begin_ = nullptr;
  bool this_namespace_ = false;
  bool negated_ = false;
  int nesting_ = 0;
  std::optional<Failure> failure_;

  std::vector<Failure> mistakes_;  // of this clause
  std::vector<const ast::Node*> scratch_;

  std::vector<Value> values_;
  std::vector<FormulaValue> formulas_;
  std::vector<Pending> pending_;
  std::vector<Frame> frames_;
  std::vector<PlanFrame> plans_;
  std::vector<const ast::Plan*> subplans_;
  const ast::Plan* finished_plan_ = nullptr;
  std::vector<ComponentFrame> open_components_;
  std::vector<ast::Component> components_;
  std::vector<Checkpoint> checkpoints_;
};

}  // namespace jaywalk

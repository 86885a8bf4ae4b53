// SPDX-License-Identifier: Apache-2.0
// The actions for bodies and what stands in braces; those for plans and programs are in
// builder_plans.cpp, those for terms in builder.cpp.

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/width.h"
#include "interpreter/syntax/ast.h"
#include "interpreter/syntax/builder.h"
#include "interpreter/syntax/precedence.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Statement;

// Operators of other languages.
constexpr std::array<std::string_view, 3> kConnectives = {"is", "and", "or"};

BodyOperator body_operator_of(TokenKind kind) {
  switch (kind) {
    case TokenKind::bang:
      return BodyOperator::achieve;
    case TokenKind::double_bang:
      return BodyOperator::achieve_new_focus;
    case TokenKind::question:
      return BodyOperator::test;
    case TokenKind::plus:
      return BodyOperator::add;
    case TokenKind::plus_plus:
      return BodyOperator::add_new_focus;
    case TokenKind::plus_less:
      return BodyOperator::add_begin;
    case TokenKind::plus_greater:
      return BodyOperator::add_end;
    case TokenKind::minus:
      return BodyOperator::remove;
    case TokenKind::minus_minus:
      return BodyOperator::remove_new_focus;
    case TokenKind::minus_plus:
      return BodyOperator::replace;
    default:
      return BodyOperator::none;
  }
}

}  // namespace

// --- Bodies ----------------------------------------------------------------------------------

void Builder::begin_body() { begin_frame(next_); }

bool Builder::may_continue() const { return frames_.back().may_continue; }

void Builder::semicolon() { frames_.back().may_continue = true; }

// Jason 1 and 2 need no semicolons at all, and many programs lack one at the end of some line. A
// text that is not indented is rather the next clause, and a word without arguments another
// language's operator.
bool Builder::formula_follows() const {
  const Span last = next_[-1].span;
  const std::string_view name = source_->text(next_->span);
  const std::string_view between = source_->text({last.end, next_->span.begin});
  const bool is_literal = next_->kind == TokenKind::atom || next_->kind == TokenKind::tilde;
  if (is_literal && std::ranges::find(kConnectives, name) != kConnectives.end()) return false;
  if (between.find('\n') == std::string_view::npos) {
    return next_->kind == TokenKind::atom && next_[1].kind == TokenKind::open &&
           (!between.empty() || !name.starts_with('.'));
  }
  if (!is_literal || name.starts_with('.')) return true;
  return source_->position(next_->span.begin).column >
         source_->position(clause()->span.begin).column;
}

void Builder::missing_semicolon() {
  frames_.back().may_continue = true;
  const std::uint32_t end = next_[-1].span.end;
  diagnostics_.warning({source_, {end, end}}, "missing-semicolon",
                       "a ';' is missing between two formulas");
}

namespace {

// Adds the formulas to `count`, until there are too many; the one that is. A body within
// parentheses is just a part of the body around it.
const ast::Formula* first_beyond_limit(std::span<const ast::Formula> body, std::size_t& count) {
  for (const ast::Formula& formula : body) {
    const bool is_part = formula.op == BodyOperator::none && formula.node->kind == Kind::body;
    if (is_part) {
      const ast::Formula* const beyond = first_beyond_limit(formula.node->formulas, count);
      if (beyond != nullptr) return beyond;
    } else if (++count > kMostParts) {
      return &formula;
    }
  }
  return nullptr;
}

}  // namespace

void Builder::check_body_size(std::span<const ast::Formula> body) {
  std::size_t count = 0;
  const ast::Formula* const beyond = first_beyond_limit(body, count);
  if (beyond == nullptr) return;
  error(beyond->span, fmt::format("more than {} formulas in a body", kMostParts),
        "split it into several plans");
}

void Builder::end_body_as_term() {
  const Frame frame = end_frame();
  Node* const node = make_node(Kind::body, {});
  int depth = 0;
  node->formulas = pop_formulas(frame.formulas, depth);
  check_body_size(node->formulas);
  // From the bracket before the first formula to the one that was matched last.
  node->span = span_from(frame.begin - 1);
  push_value(node, depth + 1);
}

void Builder::begin_formula() { begin_frame(next_); }

void Builder::formula_operator() { frames_.back().op = body_operator_of(token_->kind); }

void Builder::check_target(BodyOperator op, const Node& node) {
  if (node.kind == Kind::body && node.parenthesised && op != BodyOperator::none) {
    error(node.span, "a body in parentheses cannot have an operator before it");
    return;
  }
  if (op == BodyOperator::none || op == BodyOperator::test) {
    if (node.kind == Kind::plan || node.kind == Kind::rule || node.kind == Kind::trigger) {
      error(node.span, fmt::format("{} cannot be a formula of a body", description_of(node)),
            "'+{...}' adds it to the agent");
    }
    check_formula(node);
    return;
  }
  const bool in_braces =
      node.kind == Kind::plan || node.kind == Kind::trigger || node.kind == Kind::body;
  const bool belief = (node.kind == Kind::literal && !is_internal(node)) ||
                      node.kind == Kind::variable || node.kind == Kind::rule ||
                      (in_braces && op != BodyOperator::replace);
  if (!belief) {
    error(node.span,
          fmt::format("{} cannot be added or removed as a belief", description_of(node)));
  }
}

void Builder::end_formula() {
  const Frame frame = end_frame();
  const Value value = pop_value();
  if (frame.op != BodyOperator::achieve && frame.op != BodyOperator::achieve_new_focus) {
    check_target(frame.op, *value.node);
  }
  push_formula({.op = frame.op, .span = span_from(frame.begin), .node = value.node}, value.depth);
  frames_.back().may_continue = false;
}

void Builder::end_parenthesised_body() {
  end_body_as_term();
  parenthesised();
}

void Builder::begin_fork() {
  begin_frame(token_);
  --frames_.back().formulas;  // the formula before the operator belongs to it
}

void Builder::end_fork(Statement statement) {
  const Frame frame = end_frame();
  Node* const name = make_node(Kind::literal, frame.begin->span);
  name->text = statement == Statement::fork_and ? "and" : "or";
  push_value(name, 1);
  for (std::size_t i = frame.formulas; i < formulas_.size(); ++i) {
    const auto [formula, depth] = formulas_[i];
    const bool is_body = formula.node->kind == Kind::body && formula.node->parenthesised;
    Node* const body = make_node(Kind::body, formula.span);
    body->formulas =
        is_body ? formula.node->formulas : copy<ast::Formula>(std::span(&formula, std::size_t{1}));
    push_value(body, depth + 1);
  }
  const Span span = {formulas_[frame.formulas].formula.span.begin, token_->span.end};
  formulas_.resize(frame.formulas);
  Node* const node = make_node(Kind::literal, span);
  set_name(*node, ".fork");
  int depth = 0;
  node->args = pop_values(frame.values, depth);
  push_formula({.statement = statement, .span = span, .node = node}, depth + 1);
}

void Builder::begin_statement() { begin_frame(token_); }

void Builder::end_statement(Statement statement, std::string_view functor) {
  const Frame frame = end_frame();
  Node* const node = make_node(Kind::literal, span_from(frame.begin));
  set_name(*node, functor);
  int depth = 0;
  node->args = pop_values(frame.values, depth);
  push_formula({.statement = statement, .span = node->span, .node = node}, depth + 1);
  frames_.back().may_continue = true;
}

void Builder::elif_as_term() {
  const FormulaValue value = formulas_.back();
  formulas_.pop_back();
  Node* const body = make_node(Kind::body, value.formula.span);
  body->formulas = copy<ast::Formula>(std::span(&value.formula, std::size_t{1}));
  push_value(body, value.depth + 1);
}

// --- Terms in braces -------------------------------------------------------------------------

void Builder::begin_brace() { begin_frame(token_); }

void Builder::empty_brace() { push_value(make_node(Kind::body, {}), 1); }

void Builder::body_brace() { end_body_as_term(); }

void Builder::rule_brace() {
  const Value body = pop_value();
  const Frame frame = end_frame();
  const std::size_t count = formulas_.size() - frame.formulas;
  const FormulaValue head = count == 1 ? formulas_.back() : FormulaValue{};
  formulas_.resize(frame.formulas);
  const bool has_head = count == 1 && head.formula.op == BodyOperator::none &&
                        head.formula.node->kind == Kind::literal;
  if (!has_head) {
    error(frame.begin->span, "the head of a rule must be a literal");
    push_value(make_node(Kind::body, {}), 1);  // checks go on, and a rule has a head to them
    return;
  }
  Node* const node = make_node(Kind::rule, {});
  const std::array<const Node*, 2> parts = {head.formula.node, body.node};
  node->args = copy<const Node*>(parts);
  push_value(node, std::max(head.depth, body.depth) + 1);
}

bool Builder::plan_brace_from_body() {
  const Frame frame = end_frame();
  const std::size_t count = formulas_.size() - frame.formulas;
  const ast::Formula first = count > 0 ? formulas_[frame.formulas].formula : ast::Formula{};
  const bool is_trigger = count == 1 && !frame.may_continue &&
                          (first.op == BodyOperator::add || first.op == BodyOperator::remove) &&
                          (first.node->kind == Kind::literal || first.node->kind == Kind::variable);
  const int depth = count > 0 ? formulas_[frame.formulas].depth : 0;
  formulas_.resize(frame.formulas);
  if (!is_trigger) {
    failure_ = {next_->span, fmt::format("unexpected {} in a plan body", name_of(next_->kind)),
                "a plan in braces begins with a trigger, as in { +!g : c <- b }"};
    return false;
  }
  begin_plan();
  ast::Plan& plan = *plans_.back().plan;
  plans_.back().depth = depth;
  plan.trigger.op =
      first.op == BodyOperator::add ? ast::TriggerOperator::add : ast::TriggerOperator::remove;
  plan.trigger.span = first.span;
  plan.trigger.literal = first.node;
  return true;
}

// `{+!g}` without a label, context or arrow is but a trigger.
void Builder::plan_brace() {
  const int depth = plans_.back().depth;
  end_plan();
  const ast::Plan* const plan = std::exchange(finished_plan_, nullptr);
  const bool only_trigger = plan->label == nullptr && plan->context == nullptr && !plan->has_body;
  Node* const node = make_node(only_trigger ? Kind::trigger : Kind::plan, {});
  if (only_trigger) {
    node->trigger = &plan->trigger;
  } else {
    node->plan = plan;
  }
  push_value(node, depth + 1);
}

void Builder::end_brace() {
  const Frame frame = end_frame();
  values_.back().node->span = span_from(frame.begin);
}

}  // namespace jaywalk

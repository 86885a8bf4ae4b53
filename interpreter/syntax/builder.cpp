// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/builder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <memory>
#include <system_error>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/width.h"
#include "interpreter/syntax/ast.h"
#include "interpreter/syntax/parser.h"
#include "interpreter/syntax/precedence.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;
using ast::Operator;

Operator infix_of(TokenKind kind) {
  switch (kind) {
    case TokenKind::bar:
      return Operator::logical_or;
    case TokenKind::ampersand:
      return Operator::logical_and;
    case TokenKind::less:
      return Operator::less;
    case TokenKind::less_equal:
      return Operator::less_equal;
    case TokenKind::greater:
      return Operator::greater;
    case TokenKind::greater_equal:
      return Operator::greater_equal;
    case TokenKind::equal:
      return Operator::equal;
    case TokenKind::not_equal:
      return Operator::not_equal;
    case TokenKind::unify:
      return Operator::unify;
    case TokenKind::univ:
      return Operator::univ;
    case TokenKind::plus:
      return Operator::add;
    case TokenKind::minus:
      return Operator::subtract;
    case TokenKind::times:
      return Operator::multiply;
    case TokenKind::divide:
      return Operator::divide;
    case TokenKind::div_word:
      return Operator::int_divide;
    case TokenKind::mod_word:
      return Operator::modulo;
    case TokenKind::power:
      return Operator::power;
    default:
      return Operator::none;
  }
}

bool is_unary(Operator op) {
  return op == Operator::logical_not || precedence_of(op) == Precedence::sign;
}

// Only these two escapes mean another character than what is written.
std::string unescaped(std::string_view text) {
  std::string value;
  value.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (text[i] == '\\' && (next == 'n' || next == '"')) {
      value += next == 'n' ? '\n' : '"';
      ++i;
    } else {
      value += text[i];
    }
  }
  return value;
}

double number_in(std::string_view text) {
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code == std::errc::result_out_of_range) {
    // from_chars leaves the value alone where strtod rounds to infinity or zero.
    return std::strtod(std::string(text).c_str(), nullptr);  // infinity or (almost) nothing
  }
  assert(code == std::errc() && end == text.data() + text.size() && "the lexer's numbers are ours");
  return value;
}

}  // namespace

Builder::Builder(SourcePtr source, std::span<const Token> tokens, ast::Arena& arena,
                 Diagnostics& diagnostics)
    : source_(std::move(source)),
      tokens_(tokens),
      arena_(arena),
      diagnostics_(diagnostics),
      token_(tokens.data()),
      next_(tokens.data()) {}

// --- Storage ---------------------------------------------------------------------------------

Node* Builder::make_node(Kind kind, Span span) {
  Node* const node = make<Node>();
  node->kind = kind;
  node->span = span;
  return node;
}

void Builder::set_name(Node& node, std::string_view name) {
  node.text = name;
  node.dotted = name.front() != '\'' && name.find('.') != std::string_view::npos;
}

Span Builder::span_from(const Token* begin) const { return {begin->span.begin, token_->span.end}; }

void Builder::begin_frame(const Token* begin) {
  // The stacks are shared by all that is under way: a frame notes how much of each lies below it.
  frames_.push_back({.begin = begin,
                     .values = values_.size(),
                     .formulas = formulas_.size(),
                     .pending = pending_.size()});
}

Builder::Frame Builder::end_frame() {
  const Frame frame = frames_.back();
  frames_.pop_back();
  return frame;
}

void Builder::push_value(Node* node, int depth) { values_.push_back({node, depth}); }

Builder::Value Builder::pop_value() {
  const Value value = values_.back();
  values_.pop_back();
  return value;
}

std::span<const Node* const> Builder::pop_values(std::size_t mark, int& depth) {
  // Collected first and copied at once, as the arena never frees.
  std::vector<const Node*>& nodes = scratch_;
  nodes.clear();
  for (std::size_t i = mark; i < values_.size(); ++i) {
    nodes.push_back(values_[i].node);
    depth = std::max(depth, values_[i].depth);
  }
  values_.resize(mark);
  return copy<const Node*>(nodes);
}

std::span<const ast::Formula> Builder::pop_formulas(std::size_t mark, int& depth) {
  std::vector<ast::Formula> formulas;
  for (std::size_t i = mark; i < formulas_.size(); ++i) {
    formulas.push_back(formulas_[i].formula);
    depth = std::max(depth, formulas_[i].depth);
  }
  formulas_.resize(mark);
  return copy<ast::Formula>(formulas);
}

void Builder::push_formula(ast::Formula formula, int depth) {
  formulas_.push_back({formula, depth});
}

void Builder::error(Span span, std::string message, std::string hint) {
  // Not reported yet: if the parser fails before this place it goes back, and reads it again.
  mistakes_.push_back({span, std::move(message), std::move(hint), token_->span.begin});
}

bool Builder::enter() {
  if (++nesting_ <= kMaxNesting) return true;
  failure_ = {token_->span, fmt::format("nested deeper than {} levels", kMaxNesting),
              "split it into several rules or plans"};
  return false;
}

// --- Terms -----------------------------------------------------------------------------------

void Builder::namespace_prefix() {
  const Kind kind = token_->kind == TokenKind::variable ? Kind::variable : Kind::literal;
  Node* const node = make_node(kind, token_->span);
  set_name(*node, source_->text(token_->span));
  namespace_ = node;
  prefix_begin_ = token_;
}

void Builder::this_namespace_prefix() {
  this_namespace_ = true;
  prefix_begin_ = token_;
}

void Builder::tilde() {
  negated_ = true;
  if (prefix_begin_ == nullptr) prefix_begin_ = token_;
}

void Builder::begin_named(Kind kind) {
  // The namespace and `~` before a name belong to its span.
  const Token* const begin = prefix_begin_ != nullptr ? prefix_begin_ : token_;
  begin_frame(begin);
  Node* const node = make_node(kind, span_from(begin));
  set_name(*node, source_->text(token_->span));
  node->ns = std::exchange(namespace_, nullptr);
  node->this_namespace = std::exchange(this_namespace_, false);
  node->negated = std::exchange(negated_, false);
  prefix_begin_ = nullptr;
  frames_.back().node = node;
  frames_.back().depth = 1;
}

void Builder::begin_literal() { begin_named(Kind::literal); }

void Builder::begin_variable() { begin_named(Kind::variable); }

void Builder::end_arguments() {
  Frame& frame = frames_.back();
  int depth = 0;
  frame.node->args = pop_values(frame.values, depth);
  if (frame.node->args.size() > kMostParts) {
    error(frame.node->span, fmt::format("more than {} arguments", kMostParts),
          "a list may have any number of elements");
  }
  frame.depth = std::max(frame.depth, depth + 1);
}

void Builder::attach_annotations() {
  const Value annotations = pop_value();
  frames_.back().node->annots = annotations.node;
  frames_.back().depth = std::max(frames_.back().depth, annotations.depth);
}

void Builder::end_label() {
  const Frame frame = end_frame();
  frame.node->span = span_from(frame.begin);
  push_value(frame.node, frame.depth);
}

void Builder::end_literal() {
  end_label();
  const Node& node = *values_.back().node;
  if (!is_internal(node)) return;
  if (node.negated) {
    error(node.span, "internal actions cannot be strongly negated", "write 'not' instead of '~'");
  }
  if (node.annots != nullptr) {
    error(node.annots->span, "internal actions cannot have annotations");
  }
}

void Builder::truth() {
  Node* const node = make_node(Kind::truth, token_->span);
  node->text = source_->text(token_->span);
  push_value(node, 1);
}

void Builder::number() {
  Node* const node = make_node(Kind::number, token_->span);
  node->number = number_in(source_->text(token_->span));
  push_value(node, 1);
}

void Builder::string() {
  Node* const node = make_node(Kind::string, token_->span);
  std::string_view text = source_->text({token_->span.begin + 1, token_->span.end - 1});
  if (text.find('\\') != std::string_view::npos) {
    const std::string value = unescaped(text);
    text = {copy<char>(value).data(), value.size()};
  }
  node->text = text;
  push_value(node, 1);
}

void Builder::begin_list() {
  begin_frame(token_);
  frames_.back().node = make_node(Kind::list, token_->span);
}

void Builder::list_tail() {
  const Value tail = pop_value();
  frames_.back().node->tail = tail.node;
  frames_.back().depth = tail.depth;
}

void Builder::end_list() {
  const Frame frame = end_frame();
  int depth = frame.depth;
  frame.node->args = pop_values(frame.values, depth);
  frame.node->span = span_from(frame.begin);
  push_value(frame.node, depth + 1);
}

void Builder::parenthesised() { values_.back().node->parenthesised = true; }

// --- Expressions -----------------------------------------------------------------------------

void Builder::begin_expression() { begin_frame(next_); }

void Builder::prefix_operator() {
  const Operator op = token_->kind == TokenKind::not_word ? Operator::logical_not
                      : token_->kind == TokenKind::plus   ? Operator::positive
                                                          : Operator::negative;
  if (op == Operator::logical_not && pending_.size() > frames_.back().pending &&
      precedence_of(pending_.back().op) >= Precedence::negation) {
    error(token_->span, "'not' cannot stand here", "put the negation in parentheses");
  }
  pending_.push_back({op, token_->span});
}

void Builder::infix_operator() {
  const Operator op = infix_of(token_->kind);
  const Precedence precedence = precedence_of(op);
  while (pending_.size() > frames_.back().pending) {
    const Precedence waiting = precedence_of(pending_.back().op);
    // An operator that binds less than the next one waits; of equals a right-associative one does.
    if (waiting < precedence || (waiting == precedence && is_right_associative(precedence))) break;
    if (waiting == Precedence::relation && precedence == Precedence::relation) {
      error(token_->span, "comparisons cannot be chained",
            "join them with '&', as in X < Y & Y < Z");
    }
    reduce();
  }
  pending_.push_back({op, token_->span});
}

// The last operator and its operands become one value.
void Builder::reduce() {
  const Pending pending = pending_.back();
  pending_.pop_back();
  // Operands lie on the stack in the order of writing: the right one on top.
  const Value right = pop_value();
  const bool unary = is_unary(pending.op);
  const Value left = unary ? right : pop_value();
  // Arithmetic wants numbers, `not`, `&` and `|` want formulas; relations take any terms.
  if (precedence_of(pending.op) >= Precedence::sum) {
    if (!unary) check_number(*left.node, pending.span);
    check_number(*right.node, pending.span);
  } else if (precedence_of(pending.op) <= Precedence::negation) {
    if (!unary) check_formula(*left.node);
    check_formula(*right.node);
  }
  const std::uint32_t begin = unary ? pending.span.begin : left.node->span.begin;
  Node* const node = make_node(unary ? Kind::unary : Kind::binary, {begin, right.node->span.end});
  node->op = pending.op;
  const std::array<const Node*, 2> operands = {left.node, right.node};
  node->args = copy<const Node*>(std::span(operands).first(unary ? 1 : 2));
  push_value(node, std::max(left.depth, right.depth) + 1);
}

void Builder::check_number(const Node& operand, Span operation) {
  const bool numeric = operand.kind == Kind::number || operand.kind == Kind::variable ||
                       is_internal(operand) || is_arithmetic(operand);
  if (numeric) return;
  std::string what = operand.kind == Kind::literal
                         ? fmt::format("'{}'", source_->text(operand.span))
                         : std::string(description_of(operand));
  error(operand.span,
        fmt::format("{} is not numeric or a variable, as an operand of '{}' must be", what,
                    source_->text(operation)),
        operand.kind == Kind::literal && operand.args.empty()
            ? "variables begin with an upper-case letter"
            : "");
}

bool Builder::end_expression() {
  while (pending_.size() > frames_.back().pending) reduce();
  end_frame();
  if (values_.back().depth <= kMaxNesting) return true;
  failure_ = {values_.back().node->span, fmt::format("nested deeper than {} levels", kMaxNesting),
              "split it into several rules or plans"};
  // The caret alone: the whole would be hundreds of brackets long.
  failure_->span.end = failure_->span.begin;
  return false;
}

void Builder::check_formula(const Node& node) {
  const bool formula = node.kind != Kind::number && node.kind != Kind::string &&
                       node.kind != Kind::list && !is_arithmetic(node);
  if (!formula) {
    error(node.span,
          fmt::format("{} is not a formula that can be true or false", description_of(node)));
  }
}

void Builder::check_condition() { check_formula(*values_.back().node); }

}  // namespace jaywalk

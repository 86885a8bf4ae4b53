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

#include "interpreter/syntax/parser.h"
#include "interpreter/syntax/precedence.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Operator;
using ast::Statement;

constexpr std::array<std::string_view, 6> kNotInContexts = {".send",    ".broadcast", ".wait",
                                                            ".stopMAS", ".fork",      ".join"};

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

// `.print`, `my.action`, `math.max`: internal actions and functions.
bool is_internal(const Node& node) {
  return node.kind == Kind::literal && node.text.front() != '\'' &&
         node.text.find('.') != std::string_view::npos;
}

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

template <class T>
T* Builder::make() {
  static_assert(std::is_trivially_destructible_v<T>);
  return std::construct_at(static_cast<T*>(arena_.allocate(sizeof(T), alignof(T))));
}

template <class T, class Range>
std::span<const T> Builder::copy(const Range& range) {
  const auto count = static_cast<std::size_t>(std::distance(range.begin(), range.end()));
  if (count == 0) return {};
  auto* const storage = static_cast<T*>(arena_.allocate(count * sizeof(T), alignof(T)));
  std::uninitialized_copy(range.begin(), range.end(), storage);
  return {storage, count};
}

Node* Builder::make_node(Kind kind, Span span) {
  Node* const node = make<Node>();
  node->kind = kind;
  node->span = span;
  return node;
}

Span Builder::span_from(const Token* begin) const { return {begin->span.begin, token_->span.end}; }

void Builder::begin_frame(const Token* begin) {
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
  mistakes_.push_back({span, std::move(message), std::move(hint)});
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
  node->text = source_->text(token_->span);
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
  const Token* const begin = prefix_begin_ != nullptr ? prefix_begin_ : token_;
  begin_frame(begin);
  Node* const node = make_node(kind, span_from(begin));
  node->text = source_->text(token_->span);
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
  const Value right = pop_value();
  const bool unary = is_unary(pending.op);
  const Value left = unary ? right : pop_value();
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
  error(operand.span, fmt::format("{} is not numeric or a variable, as an operand of '{}' must be",
                                  what, source_->text(operation)));
}

bool Builder::end_expression() {
  while (pending_.size() > frames_.back().pending) reduce();
  end_frame();
  if (values_.back().depth <= kMaxNesting) return true;
  failure_ = {values_.back().node->span, fmt::format("nested deeper than {} levels", kMaxNesting),
              "split it into several rules or plans"};
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

// --- Bodies ----------------------------------------------------------------------------------

void Builder::begin_body() { begin_frame(next_); }

bool Builder::may_continue() const { return frames_.back().may_continue; }

void Builder::semicolon() { frames_.back().may_continue = true; }

void Builder::end_body_as_term() {
  const Frame frame = end_frame();
  Node* const node = make_node(Kind::body, {});
  int depth = 0;
  node->formulas = pop_formulas(frame.formulas, depth);
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
  const bool in_braces = node.kind == Kind::plan || node.kind == Kind::rule ||
                         node.kind == Kind::trigger || node.kind == Kind::body;
  const bool belief = (node.kind == Kind::literal && !is_internal(node)) ||
                      node.kind == Kind::variable || (in_braces && op != BodyOperator::replace);
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
  node->text = ".fork";
  int depth = 0;
  node->args = pop_values(frame.values, depth);
  push_formula({.statement = statement, .span = span, .node = node}, depth + 1);
}

void Builder::begin_statement() { begin_frame(token_); }

void Builder::end_statement(Statement statement, std::string_view functor) {
  const Frame frame = end_frame();
  Node* const node = make_node(Kind::literal, span_from(frame.begin));
  node->text = functor;
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
  Node* const node = make_node(Kind::rule, {});
  if (count == 1 && head.formula.op == BodyOperator::none &&
      head.formula.node->kind == Kind::literal) {
    const std::array<const Node*, 2> parts = {head.formula.node, body.node};
    node->args = copy<const Node*>(parts);
  } else {
    error(frame.begin->span, "the head of a rule must be a literal");
  }
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

// --- Plans -----------------------------------------------------------------------------------

void Builder::begin_plan() {
  plans_.push_back(
      {.plan = make<ast::Plan>(), .depth = 0, .begin = next_, .subplans = subplans_.size()});
}

void Builder::plan_label() {
  const Value label = pop_value();
  plans_.back().plan->label = label.node;
  plans_.back().depth = std::max(plans_.back().depth, label.depth);
}

void Builder::trigger_operator() {
  ast::Trigger& trigger = plans_.back().plan->trigger;
  trigger.span = token_->span;
  trigger.op = token_->kind == TokenKind::plus    ? ast::TriggerOperator::add
               : token_->kind == TokenKind::minus ? ast::TriggerOperator::remove
                                                  : ast::TriggerOperator::goal_state;
}

void Builder::trigger_kind() {
  plans_.back().plan->trigger.kind =
      token_->kind == TokenKind::bang ? ast::TriggerKind::achieve : ast::TriggerKind::test;
}

void Builder::end_trigger() {
  const Value literal = pop_value();
  ast::Trigger& trigger = plans_.back().plan->trigger;
  trigger.literal = literal.node;
  trigger.span.end = token_->span.end;
  plans_.back().depth = std::max(plans_.back().depth, literal.depth);
}

void Builder::check_usable_in_context(const Node& formula) {
  if (formula.kind == Kind::literal) {
    const auto found = std::find(kNotInContexts.begin(), kNotInContexts.end(), formula.text);
    if (found != kNotInContexts.end()) {
      error(formula.span, fmt::format("{} cannot be used in the context of a plan", formula.text),
            "call it in the body");
    }
  }
  if (precedence_of(formula.op) > Precedence::negation || formula.op == Operator::none) return;
  for (const Node* operand : formula.args) check_usable_in_context(*operand);
}

void Builder::plan_context() {
  const Value context = pop_value();
  check_formula(*context.node);
  check_usable_in_context(*context.node);
  plans_.back().plan->context = context.node;
  plans_.back().depth = std::max(plans_.back().depth, context.depth);
}

void Builder::plan_goal_condition() {
  const Value condition = pop_value();
  check_formula(*condition.node);
  plans_.back().plan->goal_condition = condition.node;
}

// A leading `true` does nothing; as any other literal, it would be an action of the environment.
void Builder::plan_body() {
  const Frame frame = end_frame();
  int depth = 0;
  std::span<const ast::Formula> body = pop_formulas(frame.formulas, depth);
  if (!body.empty() && body.front().op == BodyOperator::none &&
      body.front().node->kind == Kind::truth && body.front().node->text == "true") {
    body = body.subspan(1);
  }
  ast::Plan& plan = *plans_.back().plan;
  plan.has_body = true;
  plan.body = body;
  plans_.back().depth = std::max(plans_.back().depth, depth);
}

void Builder::end_plan() {
  const PlanFrame frame = plans_.back();
  plans_.pop_back();
  frame.plan->span = span_from(frame.begin);
  frame.plan->subplans = copy<const ast::Plan*>(std::span(subplans_).subspan(frame.subplans));
  subplans_.resize(frame.subplans);
  finished_plan_ = frame.plan;
}

void Builder::subplan() { subplans_.push_back(finished_plan_); }

// --- Programs --------------------------------------------------------------------------------

void Builder::begin_component() {
  checkpoints_.push_back({.begin = next_,
                          .nesting = nesting_,
                          .values = values_.size(),
                          .formulas = formulas_.size(),
                          .pending = pending_.size(),
                          .frames = frames_.size(),
                          .plans = plans_.size(),
                          .subplans = subplans_.size(),
                          .open_components = open_components_.size()});
  open_components_.push_back({.component = {}, .inner = components_.size()});
}

void Builder::belief_head() {
  const Value head = pop_value();
  if (head.node->kind != Kind::literal) {
    error(head.node->span,
          fmt::format("the head of a belief or rule must be a literal, not {}",
                      description_of(*head.node)),
          head.node->kind == Kind::variable ? "names begin with a lower-case letter" : "");
  } else if (is_internal(*head.node)) {
    error(head.node->span, "an internal action cannot be a belief",
          "call it in the body of a plan");
  }
  open_components_.back().component.literal = head.node;
}

void Builder::belief_body() {
  const Value body = pop_value();
  check_formula(*body.node);
  open_components_.back().component.body = body.node;
}

void Builder::finish_component(ast::ComponentKind kind) {
  ast::Component component = open_components_.back().component;
  open_components_.pop_back();
  component.kind = kind;
  component.span = span_from(checkpoints_.back().begin);
  components_.push_back(component);
}

void Builder::end_belief() { finish_component(ast::ComponentKind::belief); }

void Builder::end_goal() {
  open_components_.back().component.literal = pop_value().node;
  finish_component(ast::ComponentKind::goal);
}

void Builder::end_plan_component() {
  open_components_.back().component.plan = std::exchange(finished_plan_, nullptr);
  finish_component(ast::ComponentKind::plan);
}

void Builder::begin_directive() { open_components_.back().component.literal = pop_value().node; }

void Builder::begin_block() { open_components_.back().component.is_block = true; }

void Builder::end_directive() {
  ComponentFrame& frame = open_components_.back();
  frame.component.inner = copy<ast::Component>(std::span(components_).subspan(frame.inner));
  components_.resize(frame.inner);
  finish_component(ast::ComponentKind::directive);
}

void Builder::stray_end() { error(next_->span, "'{ end }' without a '{ begin ... }' before it"); }

void Builder::end_component() {
  checkpoints_.pop_back();
  report_mistakes(std::numeric_limits<std::uint32_t>::max());
}

void Builder::report_mistakes(std::uint32_t before) {
  for (Failure& mistake : mistakes_) {
    if (mistake.span.begin >= before) continue;
    diagnostics_.error({source_, mistake.span}, std::move(mistake.message),
                       std::move(mistake.hint));
  }
  mistakes_.clear();
}

const Token* Builder::clause() const {
  return checkpoints_.empty() ? tokens_.data() : checkpoints_.back().begin;
}

void Builder::recover(const Token* next) {
  report_mistakes(next->span.begin);
  next_ = next;
  namespace_ = nullptr;
  prefix_begin_ = nullptr;
  this_namespace_ = false;
  negated_ = false;
  failure_.reset();
  finished_plan_ = nullptr;
  if (checkpoints_.empty()) return;
  const Checkpoint checkpoint = checkpoints_.back();
  checkpoints_.pop_back();
  nesting_ = checkpoint.nesting;
  values_.resize(checkpoint.values);
  formulas_.resize(checkpoint.formulas);
  pending_.resize(checkpoint.pending);
  frames_.resize(checkpoint.frames);
  plans_.resize(checkpoint.plans);
  subplans_.resize(checkpoint.subplans);
  open_components_.resize(checkpoint.open_components);
}

std::optional<Builder::Failure> Builder::take_failure() {
  return std::exchange(failure_, std::nullopt);
}

std::span<const ast::Component> Builder::components() { return copy<ast::Component>(components_); }

const Node* Builder::values_as_list() {
  Node* const node = make_node(Kind::list, span_from(tokens_.data()));
  int depth = 0;
  node->args = pop_values(0, depth);
  return node;
}

}  // namespace jaywalk

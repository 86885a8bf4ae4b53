// The actions for bodies, plans and programs; those for terms are in builder.cpp.

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/width.h"
#include "interpreter/syntax/builder.h"
#include "interpreter/syntax/node.h"
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

// Of other languages.
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

// Jason 1 and 2 need no semicolons at all, and many programs lack one at the end of some line. What
// is not indented is the next clause rather, and what has no arguments another language's operator.
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

void Builder::label_arguments() {
  diagnostics_.warning({source_, next_->span}, "label-arguments",
                       "a label has no arguments: the plan has its annotations, but no label");
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
  check_body_size(body);
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

void Builder::belief_head() { open_components_.back().component.literal = pop_value().node; }

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

void Builder::end_belief() {
  const Node& head = *open_components_.back().component.literal;
  if (head.kind != Kind::literal) {
    error(
        head.span,
        fmt::format("the head of a belief or rule must be a literal, not {}", description_of(head)),
        head.kind == Kind::variable ? "names begin with a lower-case letter" : "");
  } else if (is_internal(head)) {
    error(head.span, "an internal action cannot be a belief", "call it in the body of a plan");
  }
  finish_component(ast::ComponentKind::belief);
}

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
    if (mistake.noticed >= before) continue;
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

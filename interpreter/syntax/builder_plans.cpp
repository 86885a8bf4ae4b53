// SPDX-License-Identifier: Apache-2.0
// The actions for plans and programs; those for bodies are in builder_bodies.cpp, those for terms
// in builder.cpp.

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "interpreter/syntax/ast.h"
#include "interpreter/syntax/builder.h"
#include "interpreter/syntax/precedence.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Operator;

constexpr std::array<std::string_view, 6> kNotInContexts = {".send",    ".broadcast", ".wait",
                                                            ".stopMAS", ".fork",      ".join"};

}  // namespace

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
  // Only what holds or not is looked into: the arguments of relations and arithmetic are terms.
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
  // The sub-plans of this plan are those above its mark; outer ones stay.
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
  // The component is whole: nothing of it will be read again.
  report_mistakes(std::numeric_limits<std::uint32_t>::max());
}

void Builder::report_mistakes(std::uint32_t before) {
  for (Failure& mistake : mistakes_) {
    // Text behind `before` is parsed again, and its mistakes are noticed again.
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
  // Restores all stacks to their sizes when the component began.
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

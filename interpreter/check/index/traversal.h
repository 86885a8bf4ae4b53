// SPDX-License-Identifier: Apache-2.0
#pragma once

// Visits every node below one, in the order of the text: arguments, annotations, tails, namespaces,
// and within programs as terms; and every formula of a body. `visit` is called before the parts.

#include <span>

#include "interpreter/syntax/ast.h"

namespace jaywalk {

template <class Visit>
void each_node(const ast::Plan& plan, Visit&& visit);

template <class Visit>
void each_node(const ast::Node& node, Visit&& visit) {
  visit(node);
  if (node.ns != nullptr) each_node(*node.ns, visit);
  for (const ast::Node* argument : node.args) each_node(*argument, visit);
  for (const ast::Formula& formula : node.formulas) each_node(*formula.node, visit);
  if (node.trigger != nullptr) each_node(*node.trigger->literal, visit);
  if (node.plan != nullptr) each_node(*node.plan, visit);
  if (node.tail != nullptr) each_node(*node.tail, visit);
  if (node.annots != nullptr) each_node(*node.annots, visit);
}

/// The plan's label, trigger, context, body and sub-plans.
template <class Visit>
void each_node(const ast::Plan& plan, Visit&& visit) {
  if (plan.label != nullptr) each_node(*plan.label, visit);
  each_node(*plan.trigger.literal, visit);
  if (plan.context != nullptr) each_node(*plan.context, visit);
  if (plan.goal_condition != nullptr) each_node(*plan.goal_condition, visit);
  for (const ast::Formula& formula : plan.body) each_node(*formula.node, visit);
  for (const ast::Plan* subplan : plan.subplans) each_node(*subplan, visit);
}

/// Calls `visit(formula)` for each formula of the body and of the blocks within.
template <class Visit>
void each_formula(std::span<const ast::Formula> formulas, Visit&& visit) {
  for (const ast::Formula& formula : formulas) {
    visit(formula);
    if (formula.node->kind == ast::Kind::body) each_formula(formula.node->formulas, visit);
    for (const ast::Node* part : formula.node->args) {
      if (part->kind == ast::Kind::body) each_formula(part->formulas, visit);
    }
  }
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "interpreter/check/index/uses.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/check/check.h"
#include "interpreter/support/text.h"
#include "interpreter/syntax/ast.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Operator;
using ast::Statement;
using Role = Condition::Role;

class Collector {
 public:
  Uses run(std::span<const ast::Component> components) {
    this->components(components, Order::kept);
    return std::move(uses_);
  }

 private:
  // Whether the plans are tried one after another, as they are written. Goal patterns, such as
  // `ebdg`, give them contexts of their own.
  enum class Order : std::uint8_t { kept, changed };

  void components(std::span<const ast::Component> components, Order order) {
    std::vector<const ast::Plan*> plans;
    for (const ast::Component& component : components) {
      switch (component.kind) {
        case ast::ComponentKind::belief:
          uses_.clauses.push_back({component.literal, component.body});
          terms_of(*component.literal);
          if (component.body != nullptr) condition(*component.body, Role::rule);
          break;
        case ast::ComponentKind::goal:
          uses_.goals.push_back(component.literal);
          terms_of(*component.literal);
          break;
        case ast::ComponentKind::plan:
          plans.push_back(component.plan);
          plan(*component.plan);
          break;
        case ast::ComponentKind::directive:
          this->components(component.inner,
                           component.literal->text == "namespace" ? order : Order::changed);
          break;
      }
    }
    if (order == Order::kept) uses_.plan_lists.push_back(std::move(plans));
  }

  void plan(const ast::Plan& plan) {
    uses_.plans.push_back(&plan);
    terms_of(*plan.trigger.literal);
    if (plan.context != nullptr) condition(*plan.context, Role::context);
    if (plan.goal_condition != nullptr) query(*plan.goal_condition);
    formulas(plan.body);
    for (const ast::Plan* subplan : plan.subplans) this->plan(*subplan);
    uses_.plan_lists.emplace_back(plan.subplans.begin(), plan.subplans.end());
  }

  void formulas(std::span<const ast::Formula> formulas) {
    for (const ast::Formula& formula : formulas) {
      if (formula.statement == Statement::formula) {
        this->formula(formula);
      } else {
        statement(formula);
      }
    }
  }

  void formula(const ast::Formula& formula) {
    const Node& node = *formula.node;
    switch (formula.op) {
      case BodyOperator::achieve:
      case BodyOperator::achieve_new_focus:
        uses_.goals.push_back(&node);
        terms_of(node);
        return;
      case BodyOperator::test:
        condition(node, Role::formula);
        return;
      case BodyOperator::none:
        if (node.kind == Kind::body) {
          formulas(node.formulas);
        } else if (node.kind == Kind::binary) {
          condition(node, Role::formula);
        } else {
          if (node.kind == Kind::literal && !is_internal(node)) uses_.actions.push_back(&node);
          term(node);
        }
        return;
      case BodyOperator::add:
      case BodyOperator::add_new_focus:
      case BodyOperator::add_begin:
      case BodyOperator::add_end:
      case BodyOperator::remove:
      case BodyOperator::remove_new_focus:
      case BodyOperator::replace:
        term(node);
        return;
    }
  }

  // The condition, if there is one, and the bodies of if, for, while and forks.
  void statement(const ast::Formula& formula) {
    for (const Node* argument : formula.node->args) {
      if (argument->kind == Kind::body) {
        formulas(argument->formulas);
      } else if (formula.statement == Statement::while_loop) {
        query(*argument);
      } else if (formula.statement == Statement::if_statement ||
                 formula.statement == Statement::for_loop) {
        condition(*argument, Role::statement);
      }
    }
  }

  void condition(const Node& node, Role role) {
    uses_.conditions.push_back({&node, role});
    query(node);
  }

  void query(const Node& node) {
    const bool logical = node.op == Operator::logical_and || node.op == Operator::logical_or ||
                         node.op == Operator::logical_not;
    if (logical) {
      for (const Node* operand : node.args) query(*operand);
      return;
    }
    if (node.kind == Kind::literal && !is_internal(node)) uses_.queries.push_back(&node);
    term(node);
  }

  // Terms as data: what goals and beliefs are in there is not this agent's concern, perhaps.
  void term(const Node& node) {
    if (node.kind == Kind::literal && is_internal(node)) {
      uses_.internal_actions.push_back(&node);
      if (const Node* const asked = query_argument(node)) condition(*asked, Role::formula);
    }
    terms_of(node);
  }

  void terms_of(const Node& node) {
    const Node* const asked = query_argument(node);
    for (const Node* argument : node.args) {
      if (argument->kind != Kind::rule && argument != asked) term(*argument);
    }
  }

  Uses uses_;
};

using ast::Kind;
using ast::Node;

/// Calls `visit(node)` for all nodes of a program, except for the literals that it defines:
/// triggers of plans and heads of rules.
template <class Visit>
class Reader {
 public:
  explicit Reader(Visit visit) : visit_(visit) {}

  void run(const SourceTree& program) {
    for (const auto& file : program.files) components(file->components);
  }

 private:
  void components(std::span<const ast::Component> components) {
    for (const ast::Component& component : components) {
      switch (component.kind) {
        case ast::ComponentKind::belief:
          parts_of(*component.literal);
          if (component.body != nullptr) node(*component.body);
          break;
        case ast::ComponentKind::goal:
          node(*component.literal);
          break;
        case ast::ComponentKind::plan:
          plan(*component.plan);
          break;
        case ast::ComponentKind::directive:
          node(*component.literal);
          this->components(component.inner);
          break;
      }
    }
  }

  void plan(const ast::Plan& plan) {
    parts_of(*plan.trigger.literal);
    if (plan.label != nullptr) parts_of(*plan.label);
    if (plan.context != nullptr) node(*plan.context);
    if (plan.goal_condition != nullptr) node(*plan.goal_condition);
    formulas(plan.body);
    for (const ast::Plan* subplan : plan.subplans) this->plan(*subplan);
  }

  void formulas(std::span<const ast::Formula> formulas) {
    for (const ast::Formula& formula : formulas) node(*formula.node);
  }

  void node(const Node& node) {
    visit_(node);
    if (node.kind == Kind::plan) {
      plan(*node.plan);
    } else if (node.kind == Kind::trigger) {
      this->node(*node.trigger->literal);
    }
    parts_of(node);
  }

  void parts_of(const Node& node) {
    for (const Node* argument : node.args) this->node(*argument);
    if (node.annots != nullptr) this->node(*node.annots);
    if (node.tail != nullptr) this->node(*node.tail);
    formulas(node.formulas);
  }

  Visit visit_;
};

bool is_social(const Node& node) {
  if (node.kind != Kind::literal) return false;
  const bool is_message_plan = node.text.starts_with("kqml");
  if (is_message_plan || traits_of(node.text).is_social()) return true;
  // A program that tests sources expects messages from other agents.
  if (node.text != "source" || node.args.size() != 1) return false;
  const Node& source = *node.args[0];
  return source.kind != Kind::literal || (source.text != "self" && source.text != "percept");
}

void add_words(std::string_view text, Mentions& mentions) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_name_character(text[end])) ++end;
    if (end > at && !is_digit(text[at])) mentions.names.insert(text.substr(at, end - at));
    at = end + 1;
  }
}

}  // namespace

Uses uses_in(std::span<const ast::Component> components) { return Collector().run(components); }

bool is_for_goal(const ast::Plan& plan) {
  return plan.trigger.kind == ast::TriggerKind::achieve &&
         plan.trigger.op == ast::TriggerOperator::add &&
         plan.trigger.literal->kind == Kind::literal;
}

std::set<std::string_view> handled_performatives(const Uses& uses) {
  std::set<std::string_view> handled;
  for (const ast::Plan* plan : uses.plans) {
    const Node& trigger = *plan->trigger.literal;
    if (trigger.text != "kqml_received" || trigger.args.size() != 4) continue;
    if (trigger.args[1]->kind == Kind::literal) handled.insert(trigger.args[1]->text);
  }
  return handled;
}

const ast::Node* query_argument(const ast::Node& action) {
  if (action.kind != Kind::literal) return nullptr;
  const std::size_t index = query_index(action.text, action.args.size());
  return index < action.args.size() ? action.args[index] : nullptr;
}

Mentions mentions_in(const SourceTree& program) {
  Mentions mentions;
  Reader([&mentions](const Node& node) {
    if (node.kind == Kind::literal) mentions.names.insert(node.text);
    // A text may become a plan or a goal: each of its words could be a name.
    if (node.kind == Kind::string) add_words(node.text, mentions);
  }).run(program);
  return mentions;
}

bool shows_other_agents(const SourceTree& program) {
  bool shows = false;
  Reader([&shows](const Node& node) { shows = shows || is_social(node); }).run(program);
  return shows;
}

std::set<std::string, std::less<>> names_in(const SourceTree& program) {
  const auto names = mentions_in(program).names;
  return {names.begin(), names.end()};
}

}  // namespace jaywalk

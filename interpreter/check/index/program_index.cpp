// SPDX-License-Identifier: Apache-2.0
#include "interpreter/check/index/program_index.h"

#include <span>

#include <fmt/format.h>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/syntax/ast.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;

class Indexer {
 public:
  explicit Indexer(const SourceTree& program) : program_(program) {}

  ProgramIndex run() {
    // The plans that every agent has for messages.
    index_.planned_goals.add("kqml_received", 4);
    index_.achievable_goals.add("kqml_received", 4);
    for (const auto& file : program_.files) components(file->components);
    return std::move(index_);
  }

 private:
  void components(std::span<const ast::Component> components) {
    for (const ast::Component& component : components) {
      switch (component.kind) {
        case ast::ComponentKind::belief:
          if (component.body == nullptr) {
            fact(*component.literal);
          } else {
            index_.beliefs.add(component.literal->text, arity_of(*component.literal));
            index_.given.add(component.literal->text, arity_of(*component.literal));
          }
          terms_of(*component.literal);
          if (component.body != nullptr) term(*component.body);
          break;
        case ast::ComponentKind::goal:
          goal(*component.literal);
          terms_of(*component.literal);
          break;
        case ast::ComponentKind::plan:
          plan(*component.plan);
          break;
        case ast::ComponentKind::directive:
          directive(component);
          break;
      }
    }
  }

  // Patterns of goals (dg, bc, ...) make plans for their arguments.
  void directive(const ast::Component& component) {
    const Node& literal = *component.literal;
    if (literal.text == "include") {
      // An include that could not be read may bring any plan and belief.
      if (!program_.includes.contains(&component)) leave_open();
    } else if (literal.text == "register_function") {
      if (!literal.args.empty()) index_.functions.add_any_arity(literal.args.front()->text);
    } else if (literal.text != "namespace") {
      for (const Node* argument : literal.args) {
        // A pattern given as text is not looked into.
        if (argument->kind == Kind::string) leave_open();
        if (argument->kind != Kind::literal) continue;
        index_.planned_goals.add(argument->text, arity_of(*argument));
        index_.achievable_goals.add(argument->text, arity_of(*argument));
        index_.posted_goals.add(argument->text, arity_of(*argument));
        belief(*argument);
      }
    }
    components(component.inner);
  }

  void leave_open() {
    index_.has_open_goals = true;
    index_.has_open_beliefs = true;
    index_.has_unread_parts = true;
  }

  // Most facts of long programs follow another one of the same name.
  void fact(const Node& node) {
    const bool is_known = last_fact_ != nullptr && node.kind == Kind::literal &&
                          last_fact_->kind == Kind::literal && last_fact_->text == node.text &&
                          last_fact_->args.size() == node.args.size();
    if (!is_known) belief(node);
    last_fact_ = &node;
  }

  void belief(const Node& node) {
    reaction(node);
    if (node.kind == Kind::literal) index_.given.add(node.text, arity_of(node));
  }

  void reaction(const Node& node) {
    if (node.kind == Kind::literal) {
      index_.beliefs.add(node.text, arity_of(node));
      index_.facts.add(node.text, arity_of(node));
    } else if (node.kind == Kind::variable) {
      index_.has_open_beliefs = true;
    }
  }

  void goal(const Node& node) {
    if (node.kind == Kind::literal) index_.posted_goals.add(node.text, arity_of(node));
  }

  void plan(const ast::Plan& plan) {
    const Node& literal = *plan.trigger.literal;
    const bool known = literal.kind == Kind::literal;
    switch (plan.trigger.kind) {
      case ast::TriggerKind::achieve:
        if (known && plan.trigger.op != ast::TriggerOperator::goal_state) {
          index_.planned_goals.add(literal.text, arity_of(literal));
          if (plan.trigger.op == ast::TriggerOperator::add) {
            index_.achievable_goals.add(literal.text, arity_of(literal));
          }
        } else if (!known) {
          index_.has_open_goals = true;
        }
        break;
      case ast::TriggerKind::test:
        if (known) index_.planned_tests.add(literal.text, arity_of(literal));
        break;
      case ast::TriggerKind::belief:
        if (known) reaction(literal);
        break;
    }
    terms_of(literal);
    if (plan.context != nullptr) term(*plan.context);
    if (plan.goal_condition != nullptr) term(*plan.goal_condition);
    formulas(plan.body);
    for (const ast::Plan* subplan : plan.subplans) this->plan(*subplan);
  }

  void formulas(std::span<const ast::Formula> formulas) {
    for (const ast::Formula& formula : formulas) {
      const Node& node = *formula.node;
      if (formula.op == BodyOperator::achieve || formula.op == BodyOperator::achieve_new_focus) {
        goal(node);
        // In the order of the enumeration: all that add or replace, without those that remove.
      } else if (formula.op >= BodyOperator::add && formula.op != BodyOperator::remove &&
                 formula.op != BodyOperator::remove_new_focus) {
        belief(node);
      }
      term(node);
    }
  }

  // All that is within a term, wherever: bodies and plans as terms, contents of messages.
  void term(const Node& node) {
    switch (node.kind) {
      case Kind::literal:
        internal_action(node);
        terms_of(node);
        return;
      case Kind::body:
        formulas(node.formulas);
        return;
      case Kind::plan:
        plan(*node.plan);
        return;
      case Kind::trigger:
        goal(*node.trigger->literal);
        belief(*node.trigger->literal);
        return;
      case Kind::rule:
        belief(*node.args[0]);
        term(*node.args[1]);
        return;
      case Kind::number:
      case Kind::string:
      case Kind::variable:
      case Kind::truth:
      case Kind::list:
      case Kind::unary:
      case Kind::binary:
        terms_of(node);
        return;
    }
  }

  void terms_of(const Node& node) {
    for (const Node* argument : node.args) term(*argument);
  }

  void internal_action(const Node& node) {
    switch (traits_of(node.text).about) {
      case About::new_program:
        leave_open();
        return;
      case About::new_plans: {
        // A text that the checker cannot look into, unless the plan is written there.
        const bool written = !node.args.empty() && node.args.front()->kind == Kind::plan;
        if (!written) index_.has_open_goals = true;
        return;
      }
      case About::new_belief:
        for (const Node* argument : node.args) belief(*argument);
        return;
      case About::message:
        index_.sends_messages = true;
        // This agent may receive the same messages that it sends, from agents that run the same
        // program.
        for (const Node* argument : node.args) {
          belief(*argument);
          goal(*argument);
        }
        return;
      case About::anything:
      case About::goal:
      case About::belief:
      case About::agents:
        return;
    }
  }

  const SourceTree& program_;
  ProgramIndex index_;
  const Node* last_fact_ = nullptr;
};

}  // namespace

void NameSet::add(std::string_view name, int arity) {
  auto found = arities_.find(name);
  if (found == arities_.end()) found = arities_.try_emplace(std::string(name)).first;
  found->second.insert(arity);
}

bool NameSet::contains(std::string_view name, int arity) const {
  const auto found = arities_.find(name);
  return found != arities_.end() &&
         (found->second.contains(arity) || found->second.contains(kAnyArity));
}

std::set<int> NameSet::arities(std::string_view name) const {
  const auto found = arities_.find(name);
  return found == arities_.end() ? std::set<int>() : found->second;
}

std::vector<std::string> NameSet::names() const {
  std::vector<std::string> names;
  names.reserve(arities_.size());
  for (const auto& [name, arities] : arities_) names.push_back(name);
  return names;
}

ProgramIndex index_of(const SourceTree& program) { return Indexer(program).run(); }

ProgramWords words_of(const SourceTree& program) {
  ProgramWords words;
  words.index = index_of(program);
  for (const auto& file : program.files) words.uses.push_back(uses_in(file->components));
  return words;
}

int arity_of(const ast::Node& literal) { return static_cast<int>(literal.args.size()); }

std::string belief_name(const ast::Node& literal) {
  return fmt::format("{}/{}", literal.text, literal.args.size());
}

std::string goal_name(const ast::Node& literal) { return "!" + belief_name(literal); }

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "interpreter/check/index/lsp_names.h"

#include <algorithm>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/check/index/uses.h"
#include "interpreter/syntax/ast.h"

namespace jaywalk::lsp {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Operator;
using What = Use::What;

class Collector {
 public:
  explicit Collector(std::vector<Use>& uses) : uses_(uses) {}

  void file(const ast::File& file) {
    file_ = &file;
    components(file.components);
  }

 private:
  void components(std::span<const ast::Component> components) {
    for (const ast::Component& component : components) {
      switch (component.kind) {
        case ast::ComponentKind::belief:
          name(*component.literal, What::belief, Role::definition);
          if (component.body != nullptr) formula_term(*component.body);
          break;
        case ast::ComponentKind::goal:
          name(*component.literal, What::goal);
          break;
        case ast::ComponentKind::plan:
          plan(*component.plan);
          break;
        case ast::ComponentKind::directive:
          this->components(component.inner);
          break;
      }
    }
  }

  void plan(const ast::Plan& plan) {
    trigger(plan.trigger, &plan);
    if (plan.context != nullptr) formula_term(*plan.context);
    if (plan.goal_condition != nullptr) formula_term(*plan.goal_condition);
    formulas(plan.body);
    for (const ast::Plan* subplan : plan.subplans) this->plan(*subplan);
  }

  void trigger(const ast::Trigger& trigger, const ast::Plan* plan) {
    const bool is_goal = trigger.kind == ast::TriggerKind::achieve;
    const bool defines = plan != nullptr && is_goal && trigger.op == ast::TriggerOperator::add;
    name(*trigger.literal, is_goal ? What::goal : What::belief,
         defines ? Role::definition : Role::reference, plan);
  }

  void formulas(std::span<const ast::Formula> formulas) {
    for (const ast::Formula& formula : formulas) this->formula(formula);
  }

  void formula(const ast::Formula& formula) {
    const Node& node = *formula.node;
    switch (formula.op) {
      case BodyOperator::achieve:
      case BodyOperator::achieve_new_focus:
        name(node, What::goal);
        return;
      case BodyOperator::none:
        if (node.kind == Kind::literal && !ast::is_internal(node)) {
          name(node, What::action);
        } else {
          formula_term(node);
        }
        return;
      default:
        formula_term(node);
        return;
    }
  }

  // A literal there is a belief.
  void formula_term(const Node& node) {
    if (node.kind == Kind::literal && !ast::is_internal(node)) {
      name(node, What::belief);
    } else if (node.kind == Kind::unary && node.op == Operator::logical_not) {
      formula_term(*node.args[0]);
    } else if (node.kind == Kind::binary &&
               (node.op == Operator::logical_and || node.op == Operator::logical_or)) {
      formula_term(*node.args[0]);
      formula_term(*node.args[1]);
    } else {
      term(node);
    }
  }

  void term(const Node& node) {
    switch (node.kind) {
      case Kind::body:
        formulas(node.formulas);
        return;
      case Kind::trigger:
        trigger(*node.trigger, nullptr);
        return;
      case Kind::plan:
        plan(*node.plan);
        return;
      case Kind::rule:
        name(*node.args[0], What::belief, Role::definition);
        formula_term(*node.args[1]);
        return;
      default:
        break;
    }
    if (node.kind == Kind::literal && ast::is_internal(node)) {
      internal_action(node);
    } else {
      terms_of(node);
    }
  }

  void internal_action(const Node& node) {
    name(node, What::internal_action, Role::reference, nullptr, Parts::left_out);
    const Node* const query = query_argument(node);
    const ActionTraits traits = traits_of(node.text);
    for (std::size_t i = 0; i < node.args.size(); ++i) {
      const Node& argument = *node.args[i];
      const bool is_content = traits.about == About::message && i == traits.performative + 1;
      const std::string_view performative = is_content ? node.args[traits.performative]->text : "";
      if (argument.kind != Kind::literal || ast::is_internal(argument)) {
        &argument == query ? formula_term(argument) : term(argument);
        continue;
      }
      const std::size_t first = uses_.size();
      if (performative == "achieve" || performative == "unachieve" ||
          (i == 0 && traits.about == About::goal)) {
        name(argument, What::goal);
      } else if (&argument == query || !performative.empty() ||
                 (i == 0 && traits.is_about_belief())) {
        name(argument, What::belief);
      } else {
        const bool is_condition = i == 0 && (node.text == ".if_then_else" || node.text == ".loop" ||
                                             node.text == ".foreach" || node.text == ".wait");
        is_condition ? formula_term(argument) : term(argument);
      }
      if (!performative.empty() && first < uses_.size()) uses_[first].in_message = true;
    }
  }

  void terms_of(const Node& node) {
    for (const Node* argument : node.args) term(*argument);
    if (node.annots != nullptr) terms_of(*node.annots);
  }

  enum class Role : std::uint8_t { reference, definition };
  enum class Parts : std::uint8_t { visited, left_out };

  void name(const Node& node, What what, Role role = Role::reference,
            const ast::Plan* plan = nullptr, Parts parts = Parts::visited) {
    if (node.kind == Kind::literal) {
      const std::string_view text = file_->source->text();
      const std::less<const char*> before;
      // Names that the program does not write, such as those of statements, have no place.
      if (!before(node.text.data(), text.data()) &&
          !before(text.data() + text.size(), node.text.data() + node.text.size())) {
        const auto begin = static_cast<std::uint32_t>(node.text.data() - text.data());
        const auto end = begin + static_cast<std::uint32_t>(node.text.size());
        uses_.push_back({.what = what,
                         .name = node.text,
                         .arity = static_cast<int>(node.args.size()),
                         .defines = role == Role::definition,
                         .file = file_,
                         .span = {begin, end},
                         .plan = plan});
      }
    }
    if (parts == Parts::visited) terms_of(node);
  }

  std::vector<Use>& uses_;
  const ast::File* file_ = nullptr;
};

}  // namespace

std::vector<Use> uses_of_names(const SourceTree& program) {
  std::vector<Use> uses;
  Collector collector(uses);
  for (const auto& file : program.files) collector.file(*file);
  return uses;
}

const Use* use_at(const std::vector<Use>& uses, const ast::File& file, std::uint32_t offset) {
  const auto found = std::ranges::find_if(uses, [&](const Use& use) {
    return use.file == &file && use.span.begin <= offset && offset <= use.span.end;
  });
  return found == uses.end() ? nullptr : &*found;
}

}  // namespace jaywalk::lsp

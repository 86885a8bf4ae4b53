// SPDX-License-Identifier: Apache-2.0
#include "interpreter/check/index/atom_flow.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/syntax/ast.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Operator;
using AtomRole = AtomUse::Role;

bool is_atom(const Node& node) {
  return node.kind == Kind::literal && node.args.empty() && !node.negated && node.ns == nullptr &&
         node.annots == nullptr && !ast::is_internal(node);
}

bool is_named_variable(const Node& node) {
  return node.kind == Kind::variable && node.text.front() != '_';
}

/// Puts arguments and variables that exchange values into one class each (union and find).
class ValueFlow {
 public:
  explicit ValueFlow(Checking& checking) : checking_(checking) {}

  std::vector<ValueClass> run() {
    const Vocabulary& vocabulary = checking_.vocabulary();
    for (const auto& percept : vocabulary.percepts) declare(What::belief, percept);
    for (const auto& action : vocabulary.actions) declare(What::action, action);
    for (CheckedFile& file : checking_.files()) {
      file_ = &file;
      components(file.file->components);
    }
    for (const Vocabulary::Setting& setting : vocabulary.settings) this->setting(setting);
    return classes();
  }

 private:
  using Id = std::size_t;
  enum class What : std::uint8_t { belief, goal, action, structure };
  using Signature = std::tuple<What, std::string_view, std::size_t>;

  // Classes.

  Id new_id() {
    parents_.push_back(parents_.size());
    return parents_.size() - 1;
  }
  Id root(Id id) {
    // Halves the path on its way.
    while (parents_[id] != id) id = parents_[id] = parents_[parents_[id]];
    return id;
  }
  void unite(Id a, Id b) { parents_[root(b)] = root(a); }

  // The id of the first argument; those of the others follow it. The latest name is cached, since
  // most facts of long programs follow another one of the same name.
  Id first_argument_id(What what, std::string_view name, std::size_t arity) {
    const Signature signature{what, name, arity};
    if (last_signature_ == signature) return last_arguments_;
    const auto [found, is_new] = arguments_.try_emplace(signature, parents_.size());
    if (is_new) {
      for (std::size_t i = 0; i < arity; ++i) new_id();
    }
    last_signature_ = signature;
    return last_arguments_ = found->second;
  }
  Id variable_id(std::string_view name) {
    const auto [found, is_new] = variables_.try_emplace(name, 0);
    if (is_new) found->second = new_id();
    return found->second;
  }
  enum class Written : std::uint8_t { as_atom, as_string };

  void note(Id id, AtomUse use, Written written = Written::as_atom) {
    use.is_declared_here = declared_.contains(id);
    uses_.push_back({id, use, written});
  }

  std::vector<ValueClass> classes() {
    std::map<Id, std::size_t> numbers;
    std::vector<ValueClass> classes;
    for (const auto& [id, use, written] : uses_) {
      // Roots are only known once all is united, so that classes are numbered here, in the order of
      // uses.
      const auto [number, is_new] = numbers.try_emplace(root(id), classes.size());
      if (is_new) classes.emplace_back();
      ValueClass& of_id = classes[number->second];
      (written == Written::as_string ? of_id.strings : of_id.uses).push_back(use);
    }
    return classes;
  }

  // Values declared by the environment and the scenario.

  void declare(What what, const Vocabulary::Entry& entry) {
    for (std::size_t i = 0; i < entry.values.size(); ++i) {
      if (entry.values[i].empty()) continue;
      const Id id = first_argument_id(what, entry.name, entry.values.size()) + i;
      declared_.insert(id);
      for (const std::string& atom : entry.values[i]) {
        note(id, {.atom = atom, .role = AtomRole::allowed});
      }
    }
  }

  void setting(const Vocabulary::Setting& setting) {
    for (std::size_t i = 0; i < setting.atoms.size(); ++i) {
      if (setting.atoms[i].empty()) continue;
      note(first_argument_id(What::belief, setting.name, setting.atoms.size()) + i,
           {.atom = setting.atoms[i], .role = AtomRole::given, .setting = &setting});
    }
  }

  // Programs. Variables belong to a plan with its sub-plans, or to a rule.

  void components(std::span<const ast::Component> components) {
    for (const ast::Component& component : components) {
      variables_.clear();
      switch (component.kind) {
        case ast::ComponentKind::belief:
          literal(What::belief, *component.literal, AtomRole::given);
          if (component.body != nullptr) formula_term(*component.body);
          break;
        case ast::ComponentKind::goal:
          literal(What::goal, *component.literal, AtomRole::given);
          break;
        case ast::ComponentKind::plan:
          plan(*component.plan);
          break;
        case ast::ComponentKind::directive:
          term(*component.literal);
          this->components(component.inner);
          break;
      }
    }
  }

  void plan(const ast::Plan& plan) {
    trigger(plan.trigger);
    if (plan.context != nullptr) formula_term(*plan.context);
    if (plan.goal_condition != nullptr) formula_term(*plan.goal_condition);
    formulas(plan.body);
    for (const ast::Plan* subplan : plan.subplans) this->plan(*subplan);
  }

  // A plan for a test goal answers like a rule.
  void trigger(const ast::Trigger& trigger) {
    const bool answers = trigger.kind == ast::TriggerKind::test;
    // A plan for a goal wants the values that are posted; its variables carry them into the body.
    literal(trigger.kind == ast::TriggerKind::achieve ? What::goal : What::belief, *trigger.literal,
            answers ? AtomRole::given : AtomRole::wanted);
  }

  void formulas(std::span<const ast::Formula> formulas) {
    for (const ast::Formula& formula : formulas) this->formula(formula);
  }

  void formula(const ast::Formula& formula) {
    const Node& node = *formula.node;
    if (formula.statement != ast::Statement::formula) {
      for (const Node* part : node.args) formula_term(*part);
      return;
    }
    switch (formula.op) {
      case BodyOperator::none:
        if (node.kind == Kind::literal && !ast::is_internal(node)) {
          literal(What::action, node, AtomRole::wanted);
        } else {
          formula_term(node);
        }
        return;
      case BodyOperator::achieve:
      case BodyOperator::achieve_new_focus:
        literal(What::goal, node, AtomRole::given);
        return;
      case BodyOperator::test:
        formula_term(node);
        return;
      case BodyOperator::remove:
      case BodyOperator::remove_new_focus:
        literal(What::belief, node, AtomRole::wanted);
        return;
      case BodyOperator::add:
      case BodyOperator::add_new_focus:
      case BodyOperator::add_begin:
      case BodyOperator::add_end:
      case BodyOperator::replace:
        literal(What::belief, node, AtomRole::given);
        return;
    }
  }

  // A formula that is true or false: a literal there asks for beliefs.
  void formula_term(const Node& node) {
    if (node.op >= Operator::logical_not && node.op <= Operator::logical_or) {
      for (const Node* operand : node.args) formula_term(*operand);
    } else if (node.op >= Operator::equal && node.op <= Operator::unify) {
      relation(node);
    } else if (node.kind == Kind::literal && !ast::is_internal(node)) {
      literal(What::belief, node, AtomRole::wanted);
    } else {
      term(node);
    }
  }

  void relation(const Node& node) {
    const Node& left = *node.args[0];
    const Node& right = *node.args[1];
    // `X = left` gives a value, `X == left` asks for one.
    const AtomRole role = node.op == Operator::unify ? AtomRole::given : AtomRole::wanted;
    if (is_named_variable(left)) {
      argument(variable_id(left.text), right, role);
    } else if (is_named_variable(right)) {
      argument(variable_id(right.text), left, role);
    } else {
      term(left);
      term(right);
    }
  }

  void literal(What what, const Node& node, AtomRole role) {
    if (node.kind != Kind::literal || ast::is_internal(node)) {
      term(node);
      return;
    }
    if (node.args.empty()) return;
    const Id first = first_argument_id(what, node.text, node.args.size());
    for (std::size_t i = 0; i < node.args.size(); ++i) argument(first + i, *node.args[i], role);
  }

  void argument(Id id, const Node& node, AtomRole role) {
    if (is_named_variable(node)) {
      // An argument and the variable in it take the same values.
      unite(id, variable_id(node.text));
    } else if (is_atom(node)) {
      note(id, {.atom = node.text, .role = role, .file = file_, .span = node.span});
    } else if (node.kind == Kind::string) {
      note(id, {.atom = node.text, .role = role, .file = file_, .span = node.span},
           Written::as_string);
    } else if (node.kind == Kind::literal && !ast::is_internal(node)) {
      literal(What::structure, node, role);
    } else {
      term(node);
    }
  }

  // Data, and programs as terms.
  void term(const Node& node) {
    if (node.kind == Kind::body) {
      formulas(node.formulas);
    } else if (node.kind == Kind::plan) {
      plan(*node.plan);
    } else if (node.kind == Kind::trigger) {
      trigger(*node.trigger);
    } else if (node.kind == Kind::literal && ast::is_internal(node)) {
      internal_action(node);
    } else if (node.kind == Kind::literal) {
      literal(What::structure, node, AtomRole::given);
    } else {
      for (const Node* part : node.args) term(*part);
    }
  }

  void internal_action(const Node& node) {
    const Node* const query = query_argument(node);
    const ActionTraits traits = traits_of(node.text);
    if (traits.about == About::message && node.args.size() > traits.performative + 1) {
      message(*node.args[traits.performative], *node.args[traits.performative + 1]);
    } else if (node.text == ".member" && node.args.size() == 2) {
      element(*node.args[0], *node.args[1]);
    } else if (node.text == ".random" && node.args.size() >= 2) {
      element(*node.args[1], *node.args[0]);
    } else {
      for (const Node* part : node.args) part == query ? formula_term(*part) : term(*part);
    }
  }

  // This agent may receive the same messages that it sends, from agents that run the same program.
  void message(const Node& performative, const Node& content) {
    const bool is_goal = performative.text == "achieve" || performative.text == "unachieve";
    literal(is_goal ? What::goal : What::belief, content, AtomRole::given);
  }

  // The variable is one of the list's elements.
  void element(const Node& variable, const Node& list) {
    if (!is_named_variable(variable) || list.kind != Kind::list) {
      term(variable);
      term(list);
      return;
    }
    for (const Node* each : list.args) argument(variable_id(variable.text), *each, AtomRole::given);
  }

  Checking& checking_;
  CheckedFile* file_ = nullptr;
  std::vector<Id> parents_;
  std::map<Signature, Id> arguments_;
  Signature last_signature_;
  Id last_arguments_ = 0;
  std::map<std::string_view, Id> variables_;
  std::set<Id> declared_;
  struct Noted {
    Id id = 0;
    AtomUse use;
    Written written = Written::as_atom;
  };
  std::vector<Noted> uses_;
};

}  // namespace

std::vector<ValueClass> value_classes(Checking& checking) { return ValueFlow(checking).run(); }

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Arithmetic and comparisons with variables that cannot have a value where they stand: a walk
// through each plan and rule in the order in which it is carried out. What may bind, binds; so a
// warning is certain, whatever the beliefs are.

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/check/checking.h"
#include "interpreter/check/index/traversal.h"
#include "interpreter/support/text.h"
#include "interpreter/syntax/ast.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Operator;
using ast::Statement;

constexpr std::string_view kLoop = "what a loop gives a variable is lost after it";
constexpr std::string_view kCollector =
    "what a query within an internal action gives a variable is lost after it";

// `_12abc` is the variable `_12`; every other `_x` is a variable of its own, wherever it stands.
std::string_view identity(std::string_view name) {
  if (name.front() != '_') return name;
  std::size_t end = 1;
  while (end < name.size() && is_digit(name[end])) ++end;
  return end == 1 ? std::string_view() : name.substr(0, end);
}

/// Which variables may have a value at a point of a plan or rule. Entries can be undone to a mark,
/// for branches and loops.
class MaybeBound {
 public:
  using Mark = std::size_t;

  [[nodiscard]] bool contains(const ast::Node& variable) const;
  /// All variables of the term may have a value from here on.
  void add_all_in(const ast::Node& term);
  void add(std::string_view name);
  void add(const std::vector<std::string_view>& names);
  /// From here on every variable may have a value, because an unknown body was carried out.
  void add_everything() { everything_ = true; }

  [[nodiscard]] Mark mark() const { return trail_.size(); }
  /// Removes the variables that were added since the mark, and returns them.
  std::vector<std::string_view> undo(Mark mark);
  /// Like undo(), and remembers why for the hint.
  void lose(Mark mark, std::string_view why);
  /// Why the variable has no value any more; empty if it never had one.
  [[nodiscard]] std::string_view why_lost(std::string_view name) const;

 private:
  std::set<std::string_view> bound_;
  std::vector<std::string_view> trail_;
  std::map<std::string_view, std::string_view> lost_;
  bool everything_ = false;
};

bool MaybeBound::contains(const ast::Node& variable) const {
  const std::string_view name = identity(variable.text);
  return !name.empty() && (everything_ || bound_.contains(name));
}

void MaybeBound::add_all_in(const ast::Node& term) {
  each_node(term, [this](const ast::Node& node) {
    if (node.kind == ast::Kind::variable) add(identity(node.text));
  });
}

void MaybeBound::add(std::string_view name) {
  if (!name.empty() && bound_.insert(name).second) trail_.push_back(name);
}

void MaybeBound::add(const std::vector<std::string_view>& names) {
  for (const std::string_view name : names) add(name);
}

std::vector<std::string_view> MaybeBound::undo(Mark mark) {
  std::vector<std::string_view> undone(trail_.begin() + static_cast<std::ptrdiff_t>(mark),
                                       trail_.end());
  for (const std::string_view name : undone) bound_.erase(name);
  trail_.resize(mark);
  return undone;
}

void MaybeBound::lose(Mark mark, std::string_view why) {
  for (const std::string_view name : undo(mark)) lost_[name] = why;
}

std::string_view MaybeBound::why_lost(std::string_view name) const {
  const auto found = lost_.find(identity(name));
  return found == lost_.end() ? std::string_view() : found->second;
}

class Flow {
 public:
  Flow(Checking& checking, CheckedFile& file) : checking_(checking), file_(file) {}

  void plan(const ast::Plan& plan) {
    // The event may bind the trigger's variables, so they count as bound.
    if (plan.label != nullptr) bound_.add_all_in(*plan.label);
    bound_.add_all_in(*plan.trigger.literal);
    if (plan.context != nullptr) query(*plan.context);
    const auto entered = bound_.mark();
    if (plan.goal_condition != nullptr) {
      query(*plan.goal_condition);
      // The condition is tested before each step of the goal, and its bindings are undone.
      bound_.undo(entered);
    }
    formulas(plan.body);
    // A sub-plan may begin at any formula of the body.
    for (const ast::Plan* subplan : plan.subplans) {
      const auto before = bound_.mark();
      this->plan(*subplan);
      bound_.undo(before);
    }
  }

  void rule(const Clause& clause) {
    bound_.add_all_in(*clause.head);
    query(*clause.body);
  }

 private:
  // --- Queries -------------------------------------------------------------------------------

  void query(const Node& node) {
    switch (node.op) {
      case Operator::logical_and:
        query(*node.args[0]);
        query(*node.args[1]);
        return;
      case Operator::logical_or:
        disjunction(node);
        return;
      case Operator::logical_not: {
        const auto before = bound_.mark();
        query(*node.args[0]);
        bound_.lose(before, "what stands within 'not' gives no variable a value");
        return;
      }
      case Operator::less:
      case Operator::less_equal:
      case Operator::greater:
      case Operator::greater_equal:
      case Operator::equal:
      case Operator::not_equal:
        for (const Node* side : node.args) operand(*side, hint_for(node.op));
        return;
      default:
        call(node);
    }
  }

  void disjunction(const Node& node) {
    const auto before = bound_.mark();
    query(*node.args[0]);
    // Either side may be the one that holds: the right one begins as the left one did, and what
    // either binds counts.
    const auto left = bound_.undo(before);
    query(*node.args[1]);
    bound_.add(left);
  }

  // Literals, internal actions, `=` and `=..`.
  void call(const Node& node) {
    if (node.kind == Kind::literal && ast::is_internal(node)) {
      internal_action(node);
      return;
    }
    term(node);
    bound_.add_all_in(node);
  }

  void internal_action(const Node& node) {
    if (const Node* const asked = query_argument(node)) {
      collector(node, *asked);
      return;
    }
    if (node.text == ".wait" && !node.args.empty() && node.args[0]->kind != Kind::body) {
      query(*node.args[0]);
    }
    term(node);
    if (traits_of(node.text).binds) bound_.add_all_in(node);
  }

  // `.findall(Term, Query, List)` and its like: only the last argument gets a value.
  void collector(const Node& node, const Node& asked) {
    const auto before = bound_.mark();
    query(asked);
    if (node.args.size() == 3) term(*node.args[0]);
    // `=` within .eval and .count may leak bindings, so that is not reported.
    bound_.lose(before, kCollector);
    for (const Node* argument : node.args) {
      // With two arguments (`.count(Query, N)`) the other one is the result, with three the last.
      const bool result = argument != &asked && (node.args.size() < 3 || argument != node.args[0]);
      if (result) bound_.add_all_in(*argument);
    }
  }

  // --- Bodies --------------------------------------------------------------------------------

  void formulas(std::span<const ast::Formula> formulas) {
    for (const ast::Formula& formula : formulas) {
      switch (formula.statement) {
        case Statement::formula:
          this->formula(formula);
          break;
        case Statement::if_statement:
          if_statement(*formula.node);
          break;
        case Statement::for_loop:
        case Statement::while_loop:
          loop(*formula.node);
          break;
        case Statement::fork_and:
        case Statement::fork_or:
          fork(*formula.node);
          break;
      }
    }
  }

  void formula(const ast::Formula& formula) {
    const Node& node = *formula.node;
    switch (formula.op) {
      case BodyOperator::none:
        if (node.kind == Kind::body) {
          formulas(node.formulas);
          // A body in a variable is run here, and may bind anything.
        } else if (node.kind == Kind::variable) {
          bound_.add_everything();
        } else {
          query(node);
        }
        return;
      case BodyOperator::test:
        query(node);
        return;
      case BodyOperator::achieve:
        call(node);
        // A body that is handed over may use this plan's variables.
        return;
      case BodyOperator::achieve_new_focus:
      case BodyOperator::add:
      case BodyOperator::add_new_focus:
      case BodyOperator::add_begin:
      case BodyOperator::add_end:
        term(node);
        return;
      case BodyOperator::remove:
      case BodyOperator::remove_new_focus:
      case BodyOperator::replace:
        call(node);
        return;
    }
  }

  void block(const Node& body) {
    if (body.kind == Kind::body) {
      formulas(body.formulas);
    } else {
      bound_.add_everything();
    }
  }

  // The condition's values stay; so may those of the branch that is taken.
  void if_statement(const Node& literal) {
    const auto before = bound_.mark();
    query(*literal.args[0]);
    if (literal.args.size() > 1) block(*literal.args[1]);
    // The branches exclude each other, but either may have been taken.
    const auto when_true = bound_.undo(before);
    if (literal.args.size() > 2) block(*literal.args[2]);
    bound_.add(when_true);
  }

  void loop(const Node& literal) {
    const auto before = bound_.mark();
    query(*literal.args[0]);
    if (literal.args.size() > 1) block(*literal.args[1]);
    bound_.lose(before, kLoop);
  }

  void fork(const Node& literal) {
    std::vector<std::string_view> all;
    const auto before = bound_.mark();
    for (const Node* branch : literal.args) {
      if (branch->kind != Kind::body) continue;
      formulas(branch->formulas);
      const auto added = bound_.undo(before);
      all.insert(all.end(), added.begin(), added.end());
    }
    bound_.add(all);
  }

  // --- Terms ---------------------------------------------------------------------------------

  // Arithmetic anywhere within; programs and formulas as terms are not carried out here.
  void term(const Node& node) {
    switch (node.kind) {
      case Kind::unary:
      case Kind::binary:
        if (ast::is_arithmetic(node)) {
          for (const Node* each : node.args) operand(*each);
        } else if (node.op == Operator::unify || node.op == Operator::univ) {
          for (const Node* each : node.args) term(*each);
        }
        return;
      case Kind::literal:
        if (query_argument(node) != nullptr) return;
        for (const Node* each : node.args) {
          if (node.text.starts_with("math.")) {
            operand(*each);
          } else {
            term(*each);
          }
        }
        return;
      case Kind::list:
        for (const Node* each : node.args) term(*each);
        return;
      default:
        return;
    }
  }

  // An operand that needs a value.
  void operand(const Node& node, std::string_view hint = {}) {
    if (node.kind != Kind::variable) {
      term(node);
    } else if (!bound_.contains(node)) {
      warn(node, hint);
      bound_.add_all_in(node);  // once is enough
    }
  }

  void warn(const Node& variable, std::string_view hint) {
    const std::string_view why_lost = bound_.why_lost(variable.text);
    checking_.warn(file_, variable.span,
                   fmt::format("the variable '{}' has no value here", variable.text),
                   std::string(why_lost.empty() ? hint : why_lost));
  }

  static std::string_view hint_for(Operator comparison) {
    return comparison == Operator::equal ? "'==' compares; to give a variable its value, write '='"
                                         : "";
  }

  Checking& checking_;
  CheckedFile& file_;
  MaybeBound bound_;
};

}  // namespace

void unbound_variables(Checking& checking) {
  for (CheckedFile& file : checking.files()) {
    // A sub-plan stands behind the plan that it is in, and is looked at within that.
    std::set<const ast::Plan*> inner;
    for (const ast::Plan* plan : file.uses.plans) {
      inner.insert(plan->subplans.begin(), plan->subplans.end());
      if (!inner.contains(plan)) Flow(checking, file).plan(*plan);
    }
    for (const Clause& clause : file.uses.clauses) {
      if (clause.body != nullptr) Flow(checking, file).rule(clause);
    }
  }
}

}  // namespace jaywalk

#include "interpreter/check/check.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/check/program_index.h"
#include "interpreter/syntax/node.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Operator;
using ast::Statement;

// Which argument of an internal action is a query.
struct QueryArgument {
  std::string_view action;
  std::size_t index;
};
constexpr std::array kQueryArguments = {QueryArgument{".findall", 1}, QueryArgument{".setof", 1},
                                        QueryArgument{".count", 0}};

constexpr std::size_t kShortestMisspelt = 5;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Names such as `left1` and `left2`, `pos_x` and `pos_y` differ on purpose.
bool is_misspelling(std::string_view name, std::string_view meant) {
  if (std::min(name.size(), meant.size()) < kShortestMisspelt) return false;
  if (name.size() == meant.size() &&
      name.substr(0, name.size() - 1) == meant.substr(0, meant.size() - 1)) {
    return false;
  }
  const bool plural = name.size() + 1 == meant.size() ? meant == std::string(name) + "s"
                                                      : name == std::string(meant) + "s";
  if (plural) return false;
  return std::none_of(name.begin(), name.end(), is_digit) ||
         std::none_of(meant.begin(), meant.end(), is_digit);
}

// `a/1 or a/2`, `1 or 2 arguments`.
std::string counted(const std::set<int>& arities) {
  std::string text;
  for (const int arity : arities) {
    if (!text.empty()) text += " or ";
    text += arity < 0 ? "any number of" : std::to_string(arity);
  }
  const bool one = arities.size() == 1 && *arities.begin() == 1;
  return text + (one ? " argument" : " arguments");
}

const Vocabulary::Entry* entry_of(std::span<const Vocabulary::Entry> entries,
                                  std::string_view name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

std::string counted(const Vocabulary::Entry& entry) {
  if (entry.most_args < 0) return fmt::format("at least {} arguments", entry.least_args);
  if (entry.least_args != entry.most_args) {
    return fmt::format("{} to {} arguments", entry.least_args, entry.most_args);
  }
  return counted(std::set{entry.least_args});
}

bool takes(const Vocabulary::Entry& entry, int arity) {
  return arity >= entry.least_args && (entry.most_args < 0 || arity <= entry.most_args);
}

std::vector<std::string> names_of(std::span<const Vocabulary::Entry> entries) {
  std::vector<std::string> names;
  for (const Vocabulary::Entry& entry : entries) names.push_back(entry.name);
  return names;
}

class Checker {
 public:
  Checker(const SourceTree& program, const Vocabulary& vocabulary)
      : program_(program),
        vocabulary_(vocabulary),
        index_(index_of(program)),
        answers_(index_.beliefs) {
    for (const Vocabulary::Entry& percept : vocabulary.percepts) {
      for (int arity = percept.least_args; arity <= percept.most_args; ++arity) {
        answers_.add(percept.name, arity);
      }
    }
    for (const std::string& test : index_.planned_tests.names()) {
      for (const int arity : index_.planned_tests.arities(test)) answers_.add(test, arity);
    }
  }

  Diagnostics run() {
    Diagnostics all;
    for (const auto& file : program_.files) {
      source_ = file->source;
      components(file->components);
      found_.sort_by_place();
      all.append(std::exchange(found_, {}));
    }
    return all;
  }

 private:
  // --- Walking -------------------------------------------------------------------------------

  void components(std::span<const ast::Component> components) {
    for (const ast::Component& component : components) {
      switch (component.kind) {
        case ast::ComponentKind::belief:
          terms_of(*component.literal);
          if (component.body != nullptr) query(*component.body);
          break;
        case ast::ComponentKind::goal:
          check_goal(*component.literal);
          terms_of(*component.literal);
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
    check_unused(plan.trigger);
    terms_of(*plan.trigger.literal);
    if (plan.context != nullptr) query(*plan.context);
    if (plan.goal_condition != nullptr) query(*plan.goal_condition);
    formulas(plan.body);
    for (const ast::Plan* subplan : plan.subplans) this->plan(*subplan);
  }

  void formulas(std::span<const ast::Formula> formulas) {
    for (const ast::Formula& formula : formulas) {
      if (formula.statement == Statement::formula) {
        this->formula(formula);
      } else {
        statement(*formula.node);
      }
    }
  }

  void formula(const ast::Formula& formula) {
    const Node& node = *formula.node;
    switch (formula.op) {
      case BodyOperator::achieve:
      case BodyOperator::achieve_new_focus:
        check_goal(node);
        terms_of(node);
        return;
      case BodyOperator::test:
        query(node);
        return;
      case BodyOperator::none:
        if (node.kind == Kind::body) {
          formulas(node.formulas);
        } else {
          if (node.kind == Kind::literal && !is_internal(node)) check_action(node);
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
  void statement(const Node& literal) {
    for (const Node* argument : literal.args) {
      if (argument->kind == Kind::body) {
        formulas(argument->formulas);
      } else if (literal.text != ".fork") {
        query(*argument);
      }
    }
  }

  void query(const Node& node) {
    const bool logical = node.op == Operator::logical_and || node.op == Operator::logical_or ||
                         node.op == Operator::logical_not;
    if (logical) {
      for (const Node* operand : node.args) query(*operand);
      return;
    }
    if (node.kind == Kind::literal && !is_internal(node)) check_belief(node);
    term(node);
  }

  // Terms as data: what goals and beliefs are in there is not this agent's concern, perhaps.
  void term(const Node& node) {
    if (node.kind == Kind::literal && is_internal(node)) {
      check_internal_action(node);
      for (const auto& [action, index] : kQueryArguments) {
        if (node.text == action && index < node.args.size()) query(*node.args[index]);
      }
    }
    terms_of(node);
  }

  void terms_of(const Node& node) {
    for (const Node* argument : node.args) {
      if (argument->kind != Kind::rule) term(*argument);
    }
  }

  // --- Judging -------------------------------------------------------------------------------

  void check_goal(const Node& goal) {
    const int arity = arity_of(goal);
    if (goal.kind != Kind::literal || index_.has_open_goals ||
        index_.planned_goals.contains(goal.text, arity)) {
      return;
    }
    const std::set<int> others = index_.planned_goals.arities(goal.text);
    if (!others.empty()) {
      warn(goal, "unknown-goal",
           fmt::format("no plan for the goal '{}' with {}", goal.text, counted(std::set{arity})),
           fmt::format("there are plans for it with {}", counted(others)));
      return;
    }
    warn(goal, "unknown-goal", fmt::format("no plan for the goal '{}'", goal.text),
         did_you_mean(goal.text, index_.planned_goals.names()));
  }

  // A plan that is never used because its name is misspelt, while the goal has other plans.
  void check_unused(const ast::Trigger& trigger) {
    const Node& literal = *trigger.literal;
    const bool achieve = trigger.kind == ast::TriggerKind::achieve;
    if (!achieve || literal.kind != Kind::literal || index_.has_open_goals) return;
    if (!index_.posted_goals.arities(literal.text).empty()) return;
    std::vector<std::string> goals;
    for (std::string& name : index_.posted_goals.names()) {
      const bool planned = !index_.planned_goals.arities(name).empty();
      if (planned && is_misspelling(literal.text, name)) goals.push_back(std::move(name));
    }
    std::string hint = did_you_mean(literal.text, goals);
    if (hint.empty()) return;
    warn(literal, "unused-plan", fmt::format("nobody posts the goal '{}'", literal.text),
         std::move(hint));
  }

  void check_belief(const Node& belief) {
    const int arity = arity_of(belief);
    if (index_.has_open_beliefs || answers_.contains(belief.text, arity)) return;
    const bool told_everything = vocabulary_.environment_known && !index_.sends_messages;
    const std::set<int> others = answers_.arities(belief.text);
    if (!others.empty()) {
      if (!told_everything && !is_percept(belief.text)) return;
      warn(belief, "unknown-belief",
           fmt::format("nothing is known of '{}' with {}", belief.text, counted(std::set{arity})),
           fmt::format("it is known with {}", counted(others)));
      return;
    }
    std::vector<std::string> names = answers_.names();
    if (!told_everything) {
      std::erase_if(names,
                    [&](const std::string& name) { return !is_misspelling(belief.text, name); });
    }
    std::string hint = did_you_mean(belief.text, names);
    if (hint.empty() && !told_everything) return;
    warn(belief, "unknown-belief",
         fmt::format("'{}' is neither a belief nor a percept", belief.text), std::move(hint));
  }

  [[nodiscard]] bool is_percept(std::string_view name) const {
    return entry_of(vocabulary_.percepts, name) != nullptr;
  }

  void check_action(const Node& action) {
    if (!vocabulary_.environment_known) return;
    const Vocabulary::Entry* const known = entry_of(vocabulary_.actions, action.text);
    if (known == nullptr) {
      std::string hint = did_you_mean(action.text, names_of(vocabulary_.actions));
      if (hint.empty() && !index_.planned_goals.arities(action.text).empty()) {
        hint = fmt::format("there are plans for it: write '!{}'", action.text);
      }
      if (hint.empty() && !answers_.arities(action.text).empty()) {
        hint = fmt::format("to ask for a belief, write '?{}'", action.text);
      }
      warn(action, "unknown-action", fmt::format("the environment has no action '{}'", action.text),
           std::move(hint));
    } else if (!takes(*known, arity_of(action))) {
      warn(action, "unknown-action",
           fmt::format("the action '{}' has {}, not {}", action.text, counted(*known),
                       arity_of(action)));
    }
  }

  void check_internal_action(const Node& action) {
    const std::span<const Vocabulary::Entry> entries = vocabulary_.internal_actions;
    const int arity = arity_of(action);
    if (entries.empty() || index_.functions.contains(action.text, arity)) return;
    // A name can be that of an action and of a function.
    const Vocabulary::Entry* known = nullptr;
    for (const Vocabulary::Entry& entry : entries) {
      if (entry.name != action.text) continue;
      if (takes(entry, arity)) return;
      if (known == nullptr) known = &entry;
    }
    if (known == nullptr) {
      warn(action, "unknown-internal-action",
           fmt::format("there is no internal action '{}'", action.text),
           did_you_mean(action.text, names_of(entries)));
    } else {
      warn(action, "unknown-internal-action",
           fmt::format("'{}' has {}, not {}", action.text, counted(*known), arity));
    }
  }

  // --- Telling -------------------------------------------------------------------------------

  void warn(const Node& node, std::string code, std::string message, std::string hint = {}) {
    const std::uint32_t line = source_->position(node.span.begin).line;
    if (allows(line, code) || (line > 1 && allows(line - 1, code))) return;
    found_.warning({source_, node.span}, std::move(code), std::move(message), std::move(hint));
  }

  // A comment `// jaywalk: allow unknown-goal, unknown-belief` in a line.
  [[nodiscard]] bool allows(std::uint32_t line, std::string_view code) const {
    constexpr std::string_view kMark = "jaywalk: allow ";
    const std::string_view text = source_->line(line);
    const std::size_t comment = text.find("//");
    if (comment == std::string_view::npos) return false;
    const std::size_t mark = text.find(kMark, comment);
    if (mark == std::string_view::npos) return false;
    const std::string_view codes = text.substr(mark + kMark.size());
    const std::size_t at = codes.find(code);
    if (at == std::string_view::npos) return false;
    const std::size_t end = at + code.size();
    return (at == 0 || codes[at - 1] == ' ' || codes[at - 1] == ',') &&
           (end == codes.size() || codes[end] == ' ' || codes[end] == ',');
  }

  const SourceTree& program_;
  const Vocabulary& vocabulary_;
  ProgramIndex index_;
  /// What can answer a query: beliefs, percepts and plans for test goals.
  NameSet answers_;
  SourcePtr source_;
  Diagnostics found_;
};

}  // namespace

void check_program(const SourceTree& program, const Vocabulary& vocabulary,
                   Diagnostics& diagnostics) {
  diagnostics.append(Checker(program, vocabulary).run());
}

}  // namespace jaywalk

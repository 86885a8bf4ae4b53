// SPDX-License-Identifier: Apache-2.0
// Named variables that occur once in a plan or rule: misspelt, or better written `_X`.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/check/checking.h"
#include "interpreter/check/index/traversal.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;

bool is_named(std::string_view variable) { return variable.front() != '_'; }

/// The first place of each named variable, and whether it occurs again.
class Occurrences {
 public:
  void operator()(const Node& node) {
    if (node.kind == Kind::variable && is_named(node.text)) {
      if (!first_.emplace(node.text, &node).second) repeated_.insert(node.text);
    } else if (is_program(node)) {
      data(node);
    } else if (node.kind == Kind::string) {
      interpolated(node.text);
    } else if (node.kind == Kind::literal && !node.args.empty()) {
      excused(node);
    }
  }

  /// A plan for any event, `+!G`, has to name it.
  void excuse(const Node& trigger) {
    if (trigger.kind == Kind::variable) repeated_.insert(trigger.text);
  }

  void tell(Checking& checking, CheckedFile& file) const {
    for (const auto& [name, node] : first_) {
      // One warning for a variable is enough.
      const bool reported = file.reported.contains({node->span.begin, "unbound-variable"}) ||
                            file.reported.contains({node->span.begin, "variable-goal"});
      if (reported || repeated_.contains(name)) continue;
      std::string hint = checking.is_full(file) ? "" : did_you_mean(name, others(name));
      if (hint.empty()) hint = fmt::format("write '_{}' if that is meant", name);
      checking.warn(file, node->span, fmt::format("the variable '{}' occurs only here", name),
                    std::move(hint));
    }
  }

 private:
  [[nodiscard]] std::vector<std::string> others(std::string_view name) const {
    std::vector<std::string> names;
    for (const auto& [other, node] : first_) {
      if (other != name && is_misspelling(other, name)) names.emplace_back(other);
    }
    return names;
  }

  static bool is_program(const Node& node) {
    return node.kind == Kind::plan || node.kind == Kind::trigger || node.kind == Kind::rule;
  }

  // The variables of a program as a term are those of that program, perhaps.
  void data(const Node& program) {
    each_node(program, [this](const Node& node) {
      if (node.kind == Kind::variable) repeated_.insert(node.text);
    });
  }

  // `.puts("#{X}")` uses X.
  void interpolated(std::string_view text) {
    for (std::size_t at = text.find("#{"); at != std::string_view::npos; at = text.find("#{", at)) {
      at += 2;
      repeated_.insert(text.substr(at, text.find('}', at) - at));
    }
  }

  // A loop that counts, and an agent that is named after the variable.
  void excused(const Node& literal) {
    const Node* counter = literal.args[0];
    if (literal.text == ".foreach" && counter->text == ".range" && !counter->args.empty()) {
      counter = counter->args[0];
    } else if (literal.text != ".create_agent") {
      return;
    }
    if (counter->kind == Kind::variable) repeated_.insert(counter->text);
  }

  std::map<std::string_view, const Node*> first_;
  std::set<std::string_view> repeated_;
};

}  // namespace

void singleton_variables(Checking& checking) {
  for (CheckedFile& file : checking.files()) {
    std::set<const ast::Plan*> inner;
    for (const ast::Plan* plan : file.uses.plans) {
      inner.insert(plan->subplans.begin(), plan->subplans.end());
      if (inner.contains(plan)) continue;  // its variables are those of the plan around it
      Occurrences occurrences;
      each_node(*plan, occurrences);
      occurrences.excuse(*plan->trigger.literal);
      occurrences.tell(checking, file);
    }
    for (const Clause& clause : file.uses.clauses) {
      if (clause.body == nullptr) continue;
      Occurrences occurrences;
      each_node(*clause.head, occurrences);
      each_node(*clause.body, occurrences);
      occurrences.tell(checking, file);
    }
  }
}

}  // namespace jaywalk

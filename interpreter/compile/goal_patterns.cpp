// SPDX-License-Identifier: Apache-2.0
#include "interpreter/compile/goal_patterns.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <fmt/format.h>

namespace jaywalk {
namespace {

const std::vector<std::string> kPatterns{"dg", "bdg", "ebdg", "bc", "smc",
                                         "rc", "omc", "mg",   "sga"};

// A plan between the directive's braces, in the pieces that patterns put together anew.
struct InnerPlan {
  std::string head;     // label and trigger
  std::string context;  // empty: none
  std::string body;     // without the arrow
  std::string goal;     // the trigger's literal; empty: it is not about achieving the goal
};

class Expansion {
 public:
  Expansion(const ast::Component& component, const Source& source)
      : component_(component), source_(source) {}

  std::string expand(std::string& problem) {
    const ast::Node& directive = *component_.literal;
    const std::size_t wanted = directive.text == "smc" || directive.text == "rc"    ? 2
                               : directive.text == "omc" || directive.text == "sga" ? 3
                                                                                    : 1;
    if (directive.args.size() < wanted) {
      problem = fmt::format("directive '{}' needs {} argument{}", directive.text, wanted,
                            wanted == 1 ? "" : "s");
      return {};
    }
    return pattern(std::string(directive.text), args(directive));
  }

 private:
  // The text of a term. An unnamed variable gets a number, the same one wherever the term is put:
  // it is one variable throughout each plan.
  std::string text(const ast::Node& node) {
    std::vector<const ast::Node*> found;
    find_unnamed(node, found);
    std::string result(source_.text(node.span));
    for (std::size_t i = found.size(); i > 0; --i) {
      result.replace(found[i - 1]->span.begin - node.span.begin, 1, number(*found[i - 1]));
    }
    return result;
  }

  static void find_unnamed(const ast::Node& node, std::vector<const ast::Node*>& found) {
    if (node.kind == ast::Kind::variable && node.text == "_") found.push_back(&node);
    for (const ast::Node* arg : node.args) find_unnamed(*arg, found);
    for (const ast::Node* part : {node.tail, node.annots}) {
      if (part != nullptr) find_unnamed(*part, found);
    }
  }

  // `_1`, ...: one that the source does not have.
  const std::string& number(const ast::Node& unnamed) {
    std::string& name = numbers_[&unnamed];
    while (name.empty() || source_.text().find(name) != std::string_view::npos) {
      name = fmt::format("_{}", ++last_number_);
    }
    return name;
  }

  std::vector<std::string> args(const ast::Node& directive) {
    std::vector<std::string> texts;
    for (const ast::Node* arg : directive.args) {
      texts.push_back(arg->kind == ast::Kind::string ? std::string(arg->text) : text(*arg));
    }
    return texts;
  }

  // The goal's part of `bc(g, sub)`: the sub-directive applied to the same plans.
  std::string sub_pattern(const ast::Node& directive, std::size_t index, std::string_view fallback,
                          const std::string& goal) {
    if (directive.args.size() > index) {
      const ast::Node& sub = *directive.args[index];
      std::vector<std::string> sub_args = args(sub);
      if (sub_args.empty()) sub_args.push_back(goal);
      return pattern(std::string(sub.text), sub_args);
    }
    return pattern(std::string(fallback), {goal});
  }

  std::string pattern(const std::string& name, const std::vector<std::string>& a) {
    const std::string& g = a[0];
    const ast::Node& directive = *component_.literal;
    const bool own = directive.text == name;
    if (name == "dg") return declarative(g);
    if (name == "bdg") return declarative(g) + fmt::format("-!{0} <- !{0}.\n", g);
    if (name == "ebdg") return exclusive(g);
    if (name == "bc") {
      const std::string inner = own ? sub_pattern(directive, 1, "bdg", g) : pattern("bdg", {g});
      return inner + fmt::format("+!{0} <- !{0}.\n", g);
    }
    if (name == "mg") {
      const std::string inner = own ? sub_pattern(directive, 1, "bc", g) : pattern("bc", {g});
      return fmt::format("{}.\n", g) + inner + fmt::format("-{0} <- !{0}.\n", g);
    }
    if (name == "sga") return sequenced(a);
    std::string result = pattern("bc", {g});
    if (name == "smc") result += fmt::format("+{} <- .fail_goal({}).\n", a[1], g);
    if (name == "rc") result += fmt::format("-{} <- .succeed_goal({}).\n", a[1], g);
    if (name == "omc") {
      // As in Jason, whose first plan is never applicable: `.intend` gives intentions' numbers.
      result += fmt::format(
          "+{0} : .intend({1},intention(_,[_,im(_,{{+!G}},_,_)|_])) <- .fail_goal(G).\n"
          "+{0} <- .drop_intention({1}).\n"
          "-{2} <- .succeed_goal({1}).\n",
          a[1], g, a[2]);
    }
    return result;
  }

  // The condition that a plan for the directive's goal must achieve, in the plan's own terms.
  std::string achieved(const ast::Trigger& trigger) {
    const ast::Node& goal = *component_.literal->args[0];
    const bool same = trigger.op == ast::TriggerOperator::add &&
                      trigger.kind == ast::TriggerKind::achieve &&
                      trigger.literal->kind == goal.kind && trigger.literal->text == goal.text &&
                      trigger.literal->args.size() == goal.args.size();
    return same ? text(*trigger.literal) : "";
  }

  static std::string test_of(const InnerPlan& plan) {
    return plan.goal.empty() ? "" : "?" + plan.goal;
  }

  std::vector<InnerPlan> inner_plans() {
    std::vector<InnerPlan> plans;
    for (const ast::Component& inner : component_.inner) {
      if (inner.kind != ast::ComponentKind::plan) continue;
      const ast::Plan& plan = *inner.plan;
      InnerPlan parts;
      const std::uint32_t start = plan.label != nullptr ? plan.span.begin : plan.trigger.span.begin;
      parts.head = source_.text({start, plan.trigger.literal->span.begin});
      parts.head += text(*plan.trigger.literal);
      parts.goal = achieved(plan.trigger);
      if (plan.context != nullptr) parts.context = text(*plan.context);
      if (!plan.body.empty()) {
        parts.body = source_.text({plan.body.front().span.begin, plan.body.back().span.end});
      }
      plans.push_back(std::move(parts));
    }
    return plans;
  }

  std::string others() const {
    std::string result;
    for (const ast::Component& inner : component_.inner) {
      if (inner.kind == ast::ComponentKind::plan) continue;
      result += source_.text(inner.span);
      result += '\n';
    }
    return result;
  }

  static std::string join(const InnerPlan& plan, const std::string& context,
                          const std::string& before, const std::string& after) {
    std::string body = before;
    for (const std::string& part : {plan.body, after}) {
      if (part.empty()) continue;
      if (!body.empty()) body += "; ";
      body += part;
    }
    return plan.head + (context.empty() ? "" : " : " + context) +
           (body.empty() ? "" : " <- " + body) + ".\n";
  }

  std::string declarative(const std::string& g) {
    std::string result = fmt::format("+!{0} : {0}.\n+!{0} : .intend({0}).\n", g) + others();
    for (const InnerPlan& plan : inner_plans())
      result += join(plan, plan.context, "", test_of(plan));
    return result + fmt::format("+{0} <- .succeed_goal({0}).\n", g);
  }

  std::string exclusive(const std::string& g) {
    std::string result = fmt::format("+!{0} : {0}.\n", g) + others();
    int number = 0;
    for (const InnerPlan& plan : inner_plans()) {
      ++number;
      const std::string mark = fmt::format("p__f({},{})", number, g);
      const std::string context =
          plan.context.empty() ? "not " + mark : fmt::format("not {} & ({})", mark, plan.context);
      result += join(plan, context, "+" + mark, test_of(plan));
    }
    return result + fmt::format(
                        "-!{0} <- !{0}.\n+{0} <- .abolish(p__f(_,{0})); .succeed_goal({0}).\n"
                        "-{0} <- .abolish(p__f(_,{0})).\n",
                        g);
  }

  // Sequenced goal adoption: sga("trigger", "context", goal).
  std::string sequenced(const std::vector<std::string>& a) const {
    return fmt::format(
               "{0} : not f__l(_) & {1} <- !f__g({2}).\n"
               "{0} : f__l(_) & ({1}) <- +f__l({2}).\n"
               "+!f__g({2}) <- +f__l({2}); !{2}; -f__l({2}).\n"
               "-!f__g({2}) <- -f__l({2}).\n"
               "-f__l({2}) : f__l({2}) <- !f__g({2}).\n",
               a[0], a[1].empty() ? "true" : a[1], a[2]) +
           others();
  }

  const ast::Component& component_;
  const Source& source_;
  std::map<const ast::Node*, std::string> numbers_;
  int last_number_ = 0;
};

}  // namespace

bool is_goal_pattern(std::string_view directive) {
  return std::find(kPatterns.begin(), kPatterns.end(), directive) != kPatterns.end();
}

std::span<const std::string> directive_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names = kPatterns;
    names.insert(names.end(), {"include", "namespace", "register_function"});
    return names;
  }();
  return kNames;
}

std::string expand_goal_pattern(const ast::Component& component, const Source& source,
                                std::string& problem) {
  return Expansion(component, source).expand(problem);
}

}  // namespace jaywalk

#include "interpreter/check/index/mentions.h"

#include <span>
#include <string_view>
#include <utility>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/check/check.h"
#include "interpreter/syntax/node.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

class Reader {
 public:
  Mentions run(const SourceTree& program) {
    for (const auto& file : program.files) components(file->components);
    return std::move(mentions_);
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
    if (node.kind == Kind::literal) {
      name(node.text);
      sociability(node);
    } else if (node.kind == Kind::string) {
      // A text may become a plan or a goal: each of its words could be a name.
      words(node.text);
    } else if (node.kind == Kind::plan) {
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

  void sociability(const Node& node) {
    const bool is_message_plan = node.text.starts_with("kqml");
    if (is_message_plan || traits_of(node.text).is_social()) mentions_.other_agents = true;
    // Who distinguishes sources reckons with other agents.
    if (node.text != "source" || node.args.size() != 1) return;
    const Node& source = *node.args[0];
    const bool own =
        source.kind == Kind::literal && (source.text == "self" || source.text == "percept");
    if (!own) mentions_.other_agents = true;
  }

  void name(std::string_view name) {
    if (!mentions_.names.contains(name)) mentions_.names.emplace(name);
  }

  void words(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
      std::size_t end = at;
      while (end < text.size() && is_word(text[end])) ++end;
      if (end > at) name(text.substr(at, end - at));
      at = end + 1;
    }
  }

  Mentions mentions_;
};

}  // namespace

Mentions mentions_in(const SourceTree& program) { return Reader().run(program); }

std::set<std::string, std::less<>> names_in(const SourceTree& program) {
  const auto names = mentions_in(program).names;
  return {names.begin(), names.end()};
}

}  // namespace jaywalk

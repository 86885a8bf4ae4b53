#include "interpreter/check/index/mentions.h"

#include <span>
#include <string_view>
#include <utility>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/check/check.h"
#include "interpreter/support/characters.h"
#include "interpreter/syntax/node.h"

namespace jaywalk {
namespace {

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

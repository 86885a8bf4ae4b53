// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/syntax/outline.h"

#include <array>
#include <span>
#include <type_traits>

#include <fmt/format.h>

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;

constexpr std::array kOperators = {"none", "neg", "pos", "not", "&",    "|",   "<",
                                   "<=",   ">",   ">=",  "==",  "\\==", "=",   "=..",
                                   "+",    "-",   "*",   "/",   "div",  "mod", "**"};
constexpr std::array kBodyOperators = {"", "!", "!!", "?", "+", "++", "+<", "+>", "-", "--", "-+"};
constexpr std::array kStatements = {"", "if:", "for:", "while:", "and:", "or:"};

template <class T>
std::string joined(std::span<T> items) {
  std::string text;
  for (const auto& item : items) {
    text += ' ';
    if constexpr (std::is_pointer_v<std::remove_cv_t<T>>) {
      text += outline(*item);
    } else {
      text += outline(item);
    }
  }
  return text;
}

std::string outline_of(const ast::Trigger& trigger) {
  constexpr std::array kOps = {"+", "-", "^"};
  constexpr std::array kKinds = {"", "!", "?"};
  return std::string(kOps.at(static_cast<std::size_t>(trigger.op))) +
         kKinds.at(static_cast<std::size_t>(trigger.kind)) + outline(*trigger.literal);
}

std::string outline_of_name(const Node& node) {
  std::string text;
  if (node.ns != nullptr) text += outline(*node.ns);
  if (node.ns != nullptr || node.this_namespace) text += "::";
  if (node.negated) text += '~';
  text += node.text;
  if (!node.args.empty()) text = fmt::format("({}{})", text, joined(node.args));
  if (node.annots != nullptr) text += fmt::format("@{}", outline(*node.annots));
  return text;
}

}  // namespace

std::string outline(const Node& node) {
  switch (node.kind) {
    case Kind::number:
      return fmt::format("{}", node.number);
    case Kind::string:
      return fmt::format("\"{}\"", node.text);
    case Kind::variable:
    case Kind::literal:
      return outline_of_name(node);
    case Kind::truth:
      return fmt::format("<{}>", node.text);
    case Kind::list:
      return fmt::format(
          "[{}{} ]", joined(node.args),
          node.tail != nullptr ? fmt::format(" | {}", outline(*node.tail)) : std::string());
    case Kind::unary:
    case Kind::binary:
      return fmt::format("({}{})", kOperators.at(static_cast<std::size_t>(node.op)),
                         joined(node.args));
    case Kind::body:
      return fmt::format("{{body{}}}", joined(node.formulas));
    case Kind::trigger:
      return fmt::format("{{trigger {}}}", outline_of(*node.trigger));
    case Kind::plan:
      return fmt::format("{{plan {}}}", outline(*node.plan));
    case Kind::rule:
      return fmt::format("{{rule{}}}", joined(node.args));
  }
  return "?";
}

std::string outline(const ast::Formula& formula) {
  return std::string(kStatements.at(static_cast<std::size_t>(formula.statement))) +
         kBodyOperators.at(static_cast<std::size_t>(formula.op)) + outline(*formula.node);
}

std::string outline(const ast::Plan& plan) {
  std::string text;
  if (plan.label != nullptr) text += fmt::format("@{} ", outline(*plan.label));
  text += outline_of(plan.trigger);
  if (plan.context != nullptr) text += fmt::format(" : {}", outline(*plan.context));
  if (plan.goal_condition != nullptr) text += fmt::format(" <: {}", outline(*plan.goal_condition));
  if (plan.has_body) text += fmt::format(" <-{}", joined(plan.body));
  if (!plan.subplans.empty()) text += fmt::format(" {{{} }}", joined(plan.subplans));
  return text;
}

std::string outline(const ast::Component& component) {
  switch (component.kind) {
    case ast::ComponentKind::belief:
      if (component.body == nullptr) return fmt::format("belief {}", outline(*component.literal));
      return fmt::format("belief {} :- {}", outline(*component.literal), outline(*component.body));
    case ast::ComponentKind::goal:
      return fmt::format("goal {}", outline(*component.literal));
    case ast::ComponentKind::plan:
      return fmt::format("plan {}", outline(*component.plan));
    case ast::ComponentKind::directive:
      if (!component.is_block) return fmt::format("directive {}", outline(*component.literal));
      return fmt::format("block {} {{{} }}", outline(*component.literal), joined(component.inner));
  }
  return "?";
}

std::string outline(const ast::File& file) {
  std::string text;
  for (const ast::Component& component : file.components)
    text += fmt::format("{}\n", outline(component));
  return text;
}

}  // namespace jaywalk

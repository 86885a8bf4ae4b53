#include "tools/jaywalk/vocabulary.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "interpreter/logic/action.h"

namespace jaywalk {
namespace {

Vocabulary::Entry entry_of(const EnvironmentWord& word) {
  return {.name = std::string(functor(word)),
          .least_args = arity(word),
          .most_args = arity(word),
          .summary = std::string(word.meaning)};
}

bool is_action_of(const EnvironmentKind& environment, const ast::Formula& formula) {
  const ast::Node* const node = formula.node;
  if (formula.op != ast::BodyOperator::none || node == nullptr ||
      node->kind != ast::Kind::literal) {
    return false;
  }
  return std::ranges::any_of(environment.actions, [&](const EnvironmentWord& word) {
    return functor(word) == node->text && arity(word) == static_cast<int>(node->args.size());
  });
}

/// Directives nest no deeper than the parser allows.
bool acts_in(const EnvironmentKind& environment, std::span<const ast::Component> components) {
  return std::ranges::any_of(components, [&](const ast::Component& component) {
    if (component.plan == nullptr) return acts_in(environment, component.inner);
    return std::ranges::any_of(component.plan->body, [&](const ast::Formula& formula) {
      return is_action_of(environment, formula);
    });
  });
}

}  // namespace

Vocabulary vocabulary_for(const EnvironmentKind* environment) {
  Vocabulary vocabulary;
  if (environment != nullptr) {
    vocabulary.environment_known = true;
    std::ranges::transform(environment->percepts, std::back_inserter(vocabulary.percepts),
                           entry_of);
    std::ranges::transform(environment->actions, std::back_inserter(vocabulary.actions), entry_of);
  }
  const auto add = [&vocabulary](const auto& known) {
    vocabulary.internal_actions.push_back(
        {known.name, known.least_args, known.most_args, known.summary});
  };
  std::ranges::for_each(standard_actions().actions(), add);
  std::ranges::for_each(standard_actions().functions(), add);
  // What `if`, `for`, `while`, `|&|` and `|||` stand for.
  for (const auto& [name, least, most] :
       {std::tuple{".if_then_else", 2, 3}, {".foreach", 2, 2}, {".loop", 2, 2}, {".fork", 2, -1}}) {
    vocabulary.internal_actions.push_back({name, least, most, "a statement"});
  }
  return vocabulary;
}

const EnvironmentKind* environment_of(const SourceTree& program) {
  for (const EnvironmentKind& environment : environments()) {
    const bool acts = std::ranges::any_of(
        program.files, [&](const auto& file) { return acts_in(environment, file->components); });
    if (acts) return &environment;
  }
  return nullptr;
}

}  // namespace jaywalk

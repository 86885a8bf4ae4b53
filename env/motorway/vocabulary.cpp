#include "env/motorway/vocabulary.h"

namespace jaywalk {

MotorwayVocabulary::MotorwayVocabulary(SymbolTable& symbols)
    : left_(Value::atom(symbols.predicate("left", 0))),
      right_(Value::atom(symbols.predicate("right", 0))) {
  const auto intern = [&symbols](const EnvironmentWord& word) {
    return symbols.predicate(functor(word), static_cast<std::uint16_t>(arity(word)));
  };
  for (std::size_t i = 0; i < percepts_.size(); ++i) percepts_[i] = intern(kMotorwayPercepts[i]);
  for (std::size_t i = 0; i < actions_.size(); ++i) actions_[i] = intern(kMotorwayActions[i]);
}

}  // namespace jaywalk

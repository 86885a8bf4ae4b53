#include "env/crossing/vocabulary.h"

namespace jaywalk {

CrossingVocabulary::CrossingVocabulary(SymbolTable& symbols)
    : move_(symbols.predicate("move", 1)), stay_(symbols.predicate("stay", 0)) {
  for (std::size_t i = 0; i < percepts_.size(); ++i) {
    const EnvironmentWord& word = kCrossingPercepts[i];
    percepts_[i] = symbols.predicate(functor(word), static_cast<std::uint16_t>(arity(word)));
  }
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    directions_[i] = Value::atom(symbols.predicate(name(static_cast<Direction>(i)), 0));
  }
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/vocabulary.h"

namespace jaywalk {
namespace {

// The atoms of an enumeration, each named by its `name`.
template <class Enum, std::size_t N>
void fill(std::array<Value, N>& atoms, SymbolTable& symbols) {
  for (std::size_t i = 0; i < N; ++i) {
    atoms[i] = Value::atom(symbols.predicate(name(static_cast<Enum>(i)), 0));
  }
}

}  // namespace

std::array<bool, kCrossingPercepts.size()> given_percepts(const CrossingParameters& parameters) {
#define JAYWALK_PERCEPT(id, need, form, ...) percept_needs::need.met(parameters),
#define JAYWALK_ACTION(id, form, ...)
  return {
#include "env/crossing/percepts.def"
  };
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION
}

CrossingVocabulary::CrossingVocabulary(SymbolTable& symbols)
    : move_(symbols.predicate("move", 1)),
      move_by_(symbols.predicate("move", 2)),
      stay_(symbols.predicate("stay", 0)),
      show_(symbols.predicate("show", 1)) {
  for (std::size_t i = 0; i < percepts_.size(); ++i) {
    const EnvironmentWord& word = kCrossingPercepts[i];
    percepts_[i] = symbols.predicate(functor(word), static_cast<std::uint16_t>(arity(word)));
  }
  fill<Direction>(directions_, symbols);
  fill<Surface>(surfaces_, symbols);
  fill<SignalColour>(colours_, symbols);
  fill<ActorKind>(kinds_, symbols);
  fill<CrosswalkKind>(crosswalks_, symbols);
}

}  // namespace jaywalk

#pragma once

// The words of the crossing world (percepts.def), as tables and as symbols.

#include <array>
#include <cstddef>

#include "env/environments.h"
#include "env/grid/grid.h"
#include "interpreter/term/symbol.h"
#include "interpreter/term/value.h"

namespace jaywalk {

#define JAYWALK_PERCEPT(id, form, meaning) id,
#define JAYWALK_ACTION(id, form, meaning)
enum class CrossingPercept : std::size_t {
#include "env/crossing/percepts.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

#define JAYWALK_PERCEPT(id, form, meaning) EnvironmentWord{form, meaning},
#define JAYWALK_ACTION(id, form, meaning)
inline constexpr std::array kCrossingPercepts{
#include "env/crossing/percepts.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

#define JAYWALK_PERCEPT(id, form, meaning)
#define JAYWALK_ACTION(id, form, meaning) EnvironmentWord{form, meaning},
inline constexpr std::array kCrossingActions{
#include "env/crossing/percepts.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

/// The words interned in one symbol table; made once, before the table is shared.
class CrossingVocabulary {
 public:
  explicit CrossingVocabulary(SymbolTable& symbols);

  [[nodiscard]] Predicate percept(CrossingPercept percept) const {
    return percepts_[static_cast<std::size_t>(percept)];
  }
  [[nodiscard]] Predicate move() const { return move_; }
  [[nodiscard]] Predicate stay() const { return stay_; }
  [[nodiscard]] Value atom(Direction direction) const {
    return directions_[static_cast<std::size_t>(direction)];
  }

 private:
  std::array<Predicate, kCrossingPercepts.size()> percepts_{};
  std::array<Value, kDirectionCount> directions_{};
  Predicate move_;
  Predicate stay_;
};

}  // namespace jaywalk

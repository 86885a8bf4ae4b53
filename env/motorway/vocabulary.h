#pragma once

// The words of the motorway world (words.def), as tables and as symbols.

#include <array>
#include <cstddef>

#include "env/environments.h"
#include "interpreter/term/symbol.h"
#include "interpreter/term/value.h"

namespace jaywalk {

#define JAYWALK_PERCEPT(id, form, meaning) id,
#define JAYWALK_ACTION(id, ...)
enum class MotorwayPercept : std::size_t {
#include "env/motorway/words.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

#define JAYWALK_PERCEPT(id, form, meaning)
#define JAYWALK_ACTION(id, ...) id,
enum class MotorwayAction : std::size_t {
#include "env/motorway/words.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

#define JAYWALK_PERCEPT(id, form, meaning) EnvironmentWord{form, meaning},
#define JAYWALK_ACTION(id, ...)
inline constexpr std::array kMotorwayPercepts{
#include "env/motorway/words.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

#define JAYWALK_PERCEPT(id, form, meaning)
#define JAYWALK_ACTION(id, ...) EnvironmentWord{__VA_ARGS__},
inline constexpr std::array kMotorwayActions{
#include "env/motorway/words.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

/// The words interned in one symbol table; made once, before the table is shared.
class MotorwayVocabulary {
 public:
  explicit MotorwayVocabulary(SymbolTable& symbols);

  [[nodiscard]] Predicate percept(MotorwayPercept percept) const {
    return percepts_[static_cast<std::size_t>(percept)];
  }
  [[nodiscard]] Predicate action(MotorwayAction action) const {
    return actions_[static_cast<std::size_t>(action)];
  }
  [[nodiscard]] Value left() const { return left_; }
  [[nodiscard]] Value right() const { return right_; }

 private:
  std::array<Predicate, kMotorwayPercepts.size()> percepts_{};
  std::array<Predicate, kMotorwayActions.size()> actions_{};
  Value left_;
  Value right_;
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which atoms stand as arguments of beliefs, goals and actions, and which arguments exchange values
// since they share a variable: `+!go : way(W) <- move(W)` makes what way/1 holds an argument of
// move/1. Nothing is said about the order in which that happens.

#include <cstdint>
#include <string_view>
#include <vector>

#include "interpreter/check/check.h"
#include "interpreter/check/checking.h"

namespace jaywalk {

/// An atom in an argument, or a string.
struct AtomUse {
  enum class Role : std::uint8_t {
    given,    // it becomes a value there: facts, heads of rules, `+b`, posted goals, `X = a`
    wanted,   // it is compared with the values there: queries, triggers, `X == a`
    allowed,  // the environment declares it
  };

  std::string_view atom;  // of a string its content
  Role role = Role::given;
  /// The argument of a percept or action that declares its values, not just shares them.
  bool is_declared_here = false;
  /// The file with the atom; null if it comes from the environment or a scenario.
  CheckedFile* file = nullptr;
  Span span;
  const Vocabulary::Setting* setting = nullptr;
};

/// The arguments that exchange values, with their atoms.
struct ValueClass {
  std::vector<AtomUse> uses;
  std::vector<AtomUse> strings;
};

/// All classes that have an atom or string, in the order in which their first ones stand in the
/// program.
[[nodiscard]] std::vector<ValueClass> value_classes(Checking& checking);

}  // namespace jaywalk

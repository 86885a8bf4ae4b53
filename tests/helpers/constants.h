// SPDX-License-Identifier: Apache-2.0
#pragma once

// Whether a world keeps what it says of its constants.

#include <string>
#include <vector>

#include "interpreter/environment/percepts.h"
#include "interpreter/term/print.h"
#include <jaywalk/environment.h>

namespace jaywalk::test {

/// The percepts of one report as texts, those of predicates that are among the constants.
inline std::vector<std::string> percept_texts(const Percepts& percepts, const SymbolTable& symbols,
                                              const Percepts& constants) {
  const auto is_constant = [&](Predicate predicate) {
    for (std::size_t i = 0; i < constants.size(); ++i) {
      if (constants.predicate(i) == predicate) return true;
    }
    return false;
  };
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < percepts.size(); ++i) {
    if (!is_constant(percepts.predicate(i))) continue;
    std::string text{symbols.functor(percepts.predicate(i))};
    for (const Value value : percepts.args(i)) text += ' ' + term_text(value, symbols);
    texts.push_back(text);
  }
  return texts;
}

/// The percepts that the world declares constant now.
inline std::vector<std::string> constant_texts(const Environment& world,
                                               const SymbolTable& symbols) {
  Percepts constants;
  world.constants(constants);
  return percept_texts(constants, symbols, constants);
}

/// An agent's percepts now of the predicates that the world declares constant.
inline std::vector<std::string> perceived_constants(const Environment& world, std::size_t agent,
                                                    const SymbolTable& symbols) {
  Percepts constants;
  world.constants(constants);
  Percepts percepts;
  world.perceive(static_cast<AgentId>(agent), percepts);
  return percept_texts(percepts, symbols, constants);
}

}  // namespace jaywalk::test

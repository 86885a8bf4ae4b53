// SPDX-License-Identifier: Apache-2.0
#pragma once

// The percepts that the environment declares constant and equal for all agents of a run, and the
// answers of rules that follow from them. Kept from run to run while the environment declares the
// same.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "interpreter/agent/known_to_all.h"
#include "interpreter/environment/percepts.h"
#include "interpreter/program/program.h"
#include <jaywalk/environment.h>

namespace jaywalk {

class Constants {
 public:
  /// Names from this number on are of one run alone.
  explicit Constants(std::size_t names) : names_(static_cast<std::uint32_t>(names)) {}

  /// Asks the environment, when a run begins.
  void learn(const Environment& environment, SymbolTable& symbols);
  /// REQUIRES: the environment has been asked. Good until it is asked again, when no agent is left.
  [[nodiscard]] KnownToAll known_to_agents_of(const std::shared_ptr<const Program>& program,
                                              SymbolTable& symbols);

 private:
  struct Followed {
    std::shared_ptr<const Program> program;
    std::vector<std::unique_ptr<const FoldedRules>> rules;
  };
  std::uint32_t names_;
  Percepts said_;
  std::unique_ptr<ConstantPercepts> percepts_;
  std::vector<Followed> followed_;
};

}  // namespace jaywalk

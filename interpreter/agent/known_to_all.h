// SPDX-License-Identifier: Apache-2.0
#pragma once

// Percepts and answers of rules that all agents of one program share.

#include <memory>
#include <span>

#include "interpreter/environment/percepts.h"
#include "interpreter/logic/beliefs/constant_percepts.h"
#include "interpreter/logic/beliefs/folded_rules.h"

namespace jaywalk {

/// Outlives the agent's beliefs.
struct KnownToAll {
  const ConstantPercepts* percepts = nullptr;  // null: nothing, or the agent knows it already
  std::span<const std::unique_ptr<const FoldedRules>> rules;
};

}  // namespace jaywalk

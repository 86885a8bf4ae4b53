// SPDX-License-Identifier: Apache-2.0
#pragma once

// Triggers of events and plans.

#include <cstdint>

#include "interpreter/term/symbol.h"

namespace jaywalk {

enum class TriggerOperator : std::uint8_t { add, remove, goal_state };  // + - ^
enum class TriggerKind : std::uint8_t { belief, achieve, test };        // (none) ! ?

/// The key by which plans are looked up for an event: Jason's trigger indicator, in which strong
/// negation does not count.
struct TriggerKey {
  TriggerOperator op = TriggerOperator::add;
  TriggerKind kind = TriggerKind::belief;
  Predicate predicate{};

  friend bool operator==(const TriggerKey&, const TriggerKey&) = default;
};

}  // namespace jaywalk

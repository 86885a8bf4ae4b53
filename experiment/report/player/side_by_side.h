#pragma once

// Two runs of one test, with the healthy AV and with a defective one, from the tick in which they
// part.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "experiment/judge/recording.h"

namespace jaywalk {

/// The first tick at which an actor's place or speed differs; nothing if the runs are alike, or
/// only one of them goes on. REQUIRES: the same actors.
[[nodiscard]] std::optional<std::size_t> parting(const Recording& left, const Recording& right);

/// A line for each tick from the one before they part, with both runs: the AV's place (m along its
/// way), its speed (m/s), the places of the most important actors (m across and along) and the
/// events up to then. `name`: the defective AV's name.
[[nodiscard]] std::string side_by_side(const Recording& healthy, const Recording& defective,
                                       std::string_view name);

}  // namespace jaywalk

#pragma once

// Two runs of one test, with the healthy AV and with a defective one, from the tick in which they
// part.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "experiment/judge/recording.h"

namespace jaywalk {

/// The first tick after which somebody is elsewhere, faster or slower; nothing if the runs are
/// alike, or only one of them goes on. REQUIRES: the same actors.
[[nodiscard]] std::optional<std::size_t> parting(const Recording& left, const Recording& right);

/// A line for each tick from the one before they part: where the AV is (m along its way), its speed
/// (m/s) and where those are who matter (m across and along), of the one and of the other. What has
/// happened until then to somebody stands behind. `name`: what the defective AV is called.
[[nodiscard]] std::string side_by_side(const Recording& healthy, const Recording& defective,
                                       std::string_view name);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The bins of situations (judge/situations/situations.h) that earlier tests have covered, as the
// pedestrians of a later one believe it, and as its recording keeps it.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/judge/situations/situations.h"

namespace jaywalk {

/// How often earlier tests have covered a bin of a situation item.
struct CoveredBin {
  std::string item;
  /// From 1.
  std::uint32_t bin = 0;
  std::uint64_t times = 0;

  friend bool operator==(const CoveredBin&, const CoveredBin&) = default;
};

/// The text of the event `feedback`: "entry_ttc 3 17; entry_side 1 40".
[[nodiscard]] std::string feedback_text(const std::vector<CoveredBin>& feedback);
/// Nothing if the text is not of that form.
[[nodiscard]] std::optional<std::vector<CoveredBin>> parse_feedback(std::string_view text);

/// The bins that are covered, as pedestrians believe them.
[[nodiscard]] std::vector<CoveredBin> feedback_of(const SituationCoverage& coverage);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The measures of a behaviour: the rows of measures.def.

#include <optional>
#include <span>
#include <string_view>

#include "experiment/compare/summary.h"
#include <jaywalk/measures.h>

namespace jaywalk {

struct Measure {
  std::string_view name;
  /// The names of the columns in results; a measure without an interval has no low and high.
  std::string_view column;
  std::string_view low_column;
  std::string_view high_column;
  std::string_view summary;
  Estimate (*estimate)(const Summary&);
};

[[nodiscard]] std::span<const Measure> measures();

/// By name or by column; null if there is none.
[[nodiscard]] const Measure* find_measure(std::string_view name);

namespace estimates {
#define JAYWALK_MEASURE(name, column, low, high, summary) Estimate name(const Summary& results);
#include "experiment/compare/measures/measures.def"
#undef JAYWALK_MEASURE
}  // namespace estimates

}  // namespace jaywalk

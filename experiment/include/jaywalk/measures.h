// SPDX-License-Identifier: Apache-2.0
#pragma once

// The measures of a comparison: what `jaywalk list measures` lists, with their 95 % intervals.
// docs/reference/measures.md says how each is computed.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

/// A value with its 95 % interval; empty if it does not exist (no successful test, say).
struct Estimate {
  std::optional<double> value;
  std::optional<double> low;
  std::optional<double> high;
  bool is_count = false;  // a whole number of things
};

struct MeasureInfo {
  /// "accuracy", as `--fail-on` knows it.
  std::string_view name;
  /// A sentence, with the unit.
  std::string_view summary;
};

/// All measures, in the order of the tables.
[[nodiscard]] std::vector<MeasureInfo> measure_list();

}  // namespace jaywalk

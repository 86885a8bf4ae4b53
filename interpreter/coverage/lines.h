#pragma once

// Coverage by lines, which listings and tracefiles are made of.

#include <map>
#include <string>
#include <vector>

#include "interpreter/coverage/source_coverage.h"

namespace jaywalk {

struct CoveredLine {
  /// The greatest count of what begins on the line: how often a plan was chosen, a condition asked,
  /// a formula executed.
  std::uint64_t count = 0;
  /// Descriptions of the parts of the line that were not covered, in the order of the text.
  std::vector<std::string> gaps;
};

/// The lines on which something begins that can be covered.
[[nodiscard]] std::map<std::uint32_t, CoveredLine> covered_lines(const CoveredFile& file);

/// "75.0 %"; "-" of nothing.
[[nodiscard]] std::string percent(const Share& share);

}  // namespace jaywalk

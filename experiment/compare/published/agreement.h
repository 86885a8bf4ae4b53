// SPDX-License-Identifier: Apache-2.0
#pragma once

// How well the published figures agree with ours. Both are estimates of 1,000 tests or so: they
// differ by chance, and only a difference that chance does not explain says something. Read
// comparison.h and published.h first.

#include <cstddef>
#include <string>
#include <vector>

#include "experiment/compare/comparison.h"

namespace jaywalk {

struct Agreement {
  /// Published accuracies, scores and ticks (of all tests) that stand beside ours.
  std::size_t values = 0;
  /// The values that differ by more than 99.9 % of the differences between two runs of one program,
  /// as `election 3 score`. The interval is that of a difference of means of two samples with our
  /// standard deviation, the published one of 1,000 tests (for a score: of the successful ones),
  /// and allows for the rounding of published values.
  std::vector<std::string> outside;
};

[[nodiscard]] Agreement agreement_with_published(const Comparison& comparison);

/// The agreement as one line of text; empty if no published value stands beside ours.
[[nodiscard]] std::string agreement_note(const Comparison& comparison);

}  // namespace jaywalk

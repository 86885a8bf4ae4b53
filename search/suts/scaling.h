// SPDX-License-Identifier: Apache-2.0
#pragma once

// Robustness without a unit, so that conditions about a speed and about a distance can be compared.
// Read
// experiment/judge/assertions/expression.h first.

#include <limits>
#include <optional>
#include <span>

#include "experiment/judge/assertions/expression.h"

namespace jaywalk::search {

/// The least and the greatest value that a signal can have.
struct SignalRange {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// The same condition, whose robustness is from -1 to 1: the difference of the sides of each
/// comparison is divided by the greatest one that the ranges allow, which are those of the
/// vocabulary's signals, in their order. No value after adding an error, at each comparison whose
/// sides may be arbitrarily far apart. REQUIRES: a resolved expression.
[[nodiscard]] std::optional<stl::Expression> scaled(const stl::Expression& expression,
                                                    std::span<const SignalRange> signals,
                                                    Diagnostics& diagnostics);

}  // namespace jaywalk::search

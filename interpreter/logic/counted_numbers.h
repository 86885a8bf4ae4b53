// SPDX-License-Identifier: Apache-2.0
#pragma once

// The whole numbers from a first to a last by steps, one after another: what `.range` counts.

#include <cstdint>
#include <utility>

namespace jaywalk {

struct CountedNumbers {
  std::int64_t next = 0;
  std::int64_t last = 0;
  std::int64_t step = 1;  // not 0

  [[nodiscard]] bool is_done() const { return step > 0 ? next > last : next < last; }
  /// REQUIRES: it is not done.
  [[nodiscard]] double take() { return static_cast<double>(std::exchange(next, next + step)); }
};

}  // namespace jaywalk

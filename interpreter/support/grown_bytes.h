// SPDX-License-Identifier: Apache-2.0
#pragma once

// The memory of a container, computed from the number of its elements alone.

#include <bit>
#include <cstddef>

namespace jaywalk {

/// The bytes of `count` elements in a container whose memory doubles when it is full; for many
/// elements the peak: old and new memory while it grows.
[[nodiscard]] constexpr std::size_t grown_bytes(std::size_t count, std::size_t each) {
  constexpr std::size_t kMany = 4096;
  if (count == 0) return 0;
  if (count < kMany) return std::bit_ceil(count) * each;
  return 2 * count * each;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The place of a formula in its program's text. A body as data keeps it as one number, the second
// argument of each step, which comparisons of bodies ignore.

#include <cstdint>

#include <jaywalk/diagnostics.h>

namespace jaywalk {

struct StepPlace {
  /// From 1; 0: nowhere, the formula was made at run time.
  std::uint32_t line = 0;
  /// From 1, in characters; 0: unknown, because the line is very long.
  std::uint16_t column = 0;
  /// In bytes; of a longer formula this many.
  std::uint16_t length = 0;
};

// A double holds 53 bits: 26 for the line (a source has at most 2^26 bytes), 13 for each other.
inline constexpr std::uint64_t kLineNumbers = std::uint64_t{1} << 26U;
inline constexpr std::uint64_t kColumnNumbers = std::uint64_t{1} << 13U;

[[nodiscard]] inline StepPlace step_place(const Source& source, Span span) {
  const auto [line, column] = source.position(span.begin);
  const std::uint32_t length = span.end - span.begin;
  constexpr std::uint32_t kMost = kColumnNumbers - 1;
  return {line, static_cast<std::uint16_t>(column > kMost ? 0 : column),
          static_cast<std::uint16_t>(length > kMost ? kMost : length)};
}

[[nodiscard]] inline double encode(StepPlace place) {
  return static_cast<double>(
      (std::uint64_t{place.length} * kColumnNumbers + place.column) * kLineNumbers + place.line);
}

[[nodiscard]] inline StepPlace decode_step_place(double code) {
  const auto number = static_cast<std::uint64_t>(code);
  return {static_cast<std::uint32_t>(number % kLineNumbers),
          static_cast<std::uint16_t>(number / kLineNumbers % kColumnNumbers),
          static_cast<std::uint16_t>(number / kLineNumbers / kColumnNumbers % kColumnNumbers)};
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// A crossing world in a terminal: the letter and style of each cell, and the legend of the letters.

#include <string>
#include <string_view>
#include <vector>

#include "env/crossing/world.h"

namespace jaywalk {

/// A cell's letter and its style on a terminal with colours.
struct Glyph {
  char letter = ' ';
  std::string_view style;
};

/// Ends a style.
inline constexpr std::string_view kPlainStyle = "\x1b[0m";

/// Pedestrians are shown by number, from 1, and then by letters, those above 35 all alike; other
/// actors by a letter of their kind, a signal by that of its colour.
[[nodiscard]] char letter_of(const Crossing& crossing, std::size_t body);

/// The AV's place and the zone to show: the one that the next tick tests or, once the precondition
/// was met, the one in which it was met.
struct AvSituation {
  int edge = 0;
  Interval zone;
};
[[nodiscard]] AvSituation av_situation(const Crossing& crossing);

/// The cells of one moment.
class FrameCells {
 public:
  /// The world must outlive it.
  explicit FrameCells(const Crossing& crossing);

  [[nodiscard]] Glyph at(Position cell) const;

 private:
  struct Body {
    Interval rows;
    Interval cells;
    Glyph glyph;
  };

  [[nodiscard]] Glyph ground(Position cell) const;

  const Crossing& crossing_;
  AvSituation av_;
  std::vector<Body> bodies_;
};

/// The meanings of the letters that occur in the world, as "X parked car", in a fixed order.
[[nodiscard]] std::vector<std::string> legend(const Crossing& crossing);

}  // namespace jaywalk

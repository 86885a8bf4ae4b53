// SPDX-License-Identifier: Apache-2.0
#pragma once

// Draws a test in a terminal tick by tick: the road seen from above, driving to the right, and
// below it each agent's intentions.

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "env/world/world.h"
#include "interpreter/mas/mas.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/console/interrupt.h"

namespace jaywalk {

struct FrameOptions {
  std::string title;
  Colour colour = Colour::off;
  /// Columns and lines that a frame may take. Of a longer or wider road that part is shown which is
  /// round the AV, and of many agents the first.
  int columns = 80;
  int rows = 23;
};

/// The world after a tick as lines of text: the road, the legend of its letters, and the agents.
/// `printed`: the output of the agents in this tick.
[[nodiscard]] std::string draw_frame(const World& world, const Mas& mas,
                                     const std::vector<std::string>& printed,
                                     const FrameOptions& options);

/// Shows a test frame by frame: on a terminal each frame replaces the last one, at a given speed;
/// otherwise the frames are printed one below the other.
class Viewer {
 public:
  /// `speed`: ticks per second.
  Viewer(std::string title, double speed, const InterruptGuard& interrupt, Console& console)
      : interrupt_(interrupt), console_(console), pause_(1 / speed), title_(std::move(title)) {}

  /// Shown below the next frame.
  void add_line(std::string_view line) { printed_.emplace_back(line); }

  void show(const World& world, const Mas& mas);

 private:
  void pause() const;

  const InterruptGuard& interrupt_;
  Console& console_;
  std::chrono::duration<double> pause_;
  std::string title_;
  std::vector<std::string> printed_;
  std::ptrdiff_t lines_ = 0;
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Draws a test in a terminal tick by tick: the road seen from above, driving to the right, and
// below it each agent's intentions.

#include <string>
#include <vector>

#include "env/world/world.h"
#include "interpreter/mas/mas.h"

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

}  // namespace jaywalk

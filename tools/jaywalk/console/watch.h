#pragma once

// A test of the crossing world, drawn in a terminal tick by tick: the road seen from above, driving
// to the right, and below it what each agent is after.

#include <string>
#include <vector>

#include "env/crossing/crossing.h"
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

/// The world as it is after a tick, as lines of text: the road, what its letters mean, and the
/// agents. `printed` is what the agents have said in this tick.
[[nodiscard]] std::string draw_frame(const Crossing& crossing, const Mas& mas,
                                     const std::vector<std::string>& printed,
                                     const FrameOptions& options);

/// What came of the test, in one line.
[[nodiscard]] std::string describe_result(const CrossingResult& result);

}  // namespace jaywalk

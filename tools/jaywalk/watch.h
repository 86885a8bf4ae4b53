#pragma once

// A test of the crossing world, drawn in a terminal tick by tick: the road seen from above, driving
// to the right, and below it what each pedestrian is after.

#include <string>
#include <vector>

#include "env/crossing/crossing.h"
#include "interpreter/mas/mas.h"

namespace jaywalk {

struct FrameOptions {
  std::string title;
  Colour colour = Colour::off;
  /// Columns that the picture may take; 0: as many as the road is long.
  int columns = 0;
};

/// One tick as lines of text. `printed` is what the agents have said in this tick.
[[nodiscard]] std::string draw_frame(const Crossing& crossing, const Mas& mas,
                                     const std::vector<std::string>& printed,
                                     const FrameOptions& options);

/// What came of the test, in one line.
[[nodiscard]] std::string describe_result(const CrossingResult& result);

}  // namespace jaywalk

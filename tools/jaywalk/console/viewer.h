// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shows a test frame by frame: on a terminal each frame replaces the last one, at a given speed;
// otherwise the frames are printed one below the other.

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

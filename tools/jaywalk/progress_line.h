#pragma once

// The line on a terminal that says how far a long run is, how fast, and how long it will take.

#include <chrono>
#include <string>
#include <string_view>

#include "experiment/experiment.h"
#include "tools/jaywalk/console.h"

namespace jaywalk {

/// "1200 of 84000 tests (1 %), 30500 per second, 3 s left".
[[nodiscard]] std::string progress_text(const Progress& progress, double seconds);

/// Draws over itself on standard error; draws nothing if that is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(Console& console);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  void clear();

 private:
  Console& console_;
  std::chrono::steady_clock::time_point start_;
  bool drawn_ = false;
};

}  // namespace jaywalk

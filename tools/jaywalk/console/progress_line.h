// SPDX-License-Identifier: Apache-2.0
#pragma once

// The line on a terminal that says how far a long run is, how fast, and how long it will take.

#include <chrono>
#include <string>
#include <string_view>

#include "experiment/compare/experiment.h"
#include "search/search.h"
#include "tools/jaywalk/console/console.h"

namespace jaywalk {

/// To the second below an hour, to the minute from there: "3 s", "6 min 05 s", "2 h 00 min".
[[nodiscard]] std::string duration_text(double seconds);

/// "1200 of 84000 tests (1 %), 30500 per second, 3 s left".
[[nodiscard]] std::string progress_text(const Progress& progress, double seconds);

/// "1200 tests, 31 failing, best fitness 0.98, 12 % of the budget, 3 s left".
[[nodiscard]] std::string progress_text(const search::SearchProgress& progress, double seconds);

/// Draws over itself on standard error; draws nothing if that is no terminal. Its clock starts with
/// it.
class ProgressLine {
 public:
  explicit ProgressLine(Console& console);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  /// With how it goes before that.
  void show(const Progress& progress, std::string_view how);
  void show(const search::SearchProgress& progress);
  void clear();

 private:
  [[nodiscard]] double seconds() const;
  void draw(std::string_view text);

  Console& console_;
  std::chrono::steady_clock::time_point start_;
  bool drawn_ = false;
};

}  // namespace jaywalk

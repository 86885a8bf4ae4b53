#pragma once

// The line on a terminal that says how far a long run is, how fast, and how long it will take.

#include <chrono>
#include <string_view>

#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/console/progress_text.h"

namespace jaywalk {

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

#pragma once

// The line on a terminal that says how far searches are, what they found, and how long they will
// take.

#include <chrono>
#include <string>

#include "search/search.h"
#include "tools/jaywalk/console.h"

namespace jaywalk {

/// "1200 tests, 31 failing, best fitness 0.98, 12 % of the budget, 3 s left".
[[nodiscard]] std::string search_progress_text(const search::SearchProgress& progress,
                                               double seconds);

/// Draws over itself on standard error; draws nothing if that is no terminal.
class SearchProgressLine {
 public:
  explicit SearchProgressLine(Console& console);
  ~SearchProgressLine();
  SearchProgressLine(const SearchProgressLine&) = delete;
  SearchProgressLine& operator=(const SearchProgressLine&) = delete;

  void show(const search::SearchProgress& progress);
  void clear();

 private:
  Console& console_;
  std::chrono::steady_clock::time_point start_;
  bool drawn_ = false;
};

}  // namespace jaywalk

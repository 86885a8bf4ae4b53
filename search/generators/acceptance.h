// SPDX-License-Identifier: Apache-2.0
#pragma once

// How OGAN and WOGAN choose among the candidates of their generator (Peltomäki et al. 2022,
// algorithm 1, lines 9 to 16): candidates are drawn until the predicted fitness of one reaches a
// target, which begins at 1 and shrinks with every valid candidate.

#include <optional>

#include "search/generator.h"
#include "search/learn/adversary.h"

namespace jaywalk::search {

/// Tests and their fitness as the networks take them.
struct Examples {
  std::vector<std::vector<double>> tests;
  std::vector<double> fitness;

  void add(const ExecutedTest& test);
  [[nodiscard]] std::size_t size() const { return tests.size(); }
  /// A column for each test.
  [[nodiscard]] learn::Matrix inputs() const;
  [[nodiscard]] learn::Matrix outputs() const;
};

struct AcceptanceSettings {
  /// By which the target shrinks.
  double reducer = 0.95;
  /// Invalid candidates in all before it gives up.
  int patience = 100;
};

/// `make` draws one candidate as a column. The best one so far is kept and compared with the
/// target. None if too many candidates were invalid.
template <class Make>
[[nodiscard]] std::optional<TestInput> accept_candidate(Asking& asking, learn::Analyzer& analyzer,
                                                        const AcceptanceSettings& settings,
                                                        Make make) {
  std::optional<TestInput> best;
  float best_fitness = 0;
  double target = 1;
  for (int invalid = 0; invalid < settings.patience;) {
    const learn::Matrix column = make();
    TestInput candidate{Form::vector, {column.data(), column.data() + column.size()}};
    if (!asking.valid(candidate)) {
      ++invalid;
      continue;
    }
    const float predicted = analyzer.predict(column)(0, 0);
    if (!best || predicted > best_fitness) {
      best_fitness = predicted;
      best = std::move(candidate);
    }
    target *= settings.reducer;
    if (best_fitness >= target) return best;
  }
  return std::nullopt;
}

}  // namespace jaywalk::search

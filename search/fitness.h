#pragma once

// The fitness that a search maximises: one measure of the SUT, scaled so that 0 is harmless and 1
// the worst. Read sut.h first.

#include "search/sut.h"

namespace jaywalk::search {

struct Fitness {
  /// Index into the SUT's measures.
  std::size_t measure = 0;
  /// Values of the measure whose fitness is 0 and 1; beyond them it is 0 and 1 too.
  double harmless = 0;
  double worst = 1;
  /// A test fails if its fitness is at least this.
  double fails_at = 0.95;

  /// 0 if there is no result.
  [[nodiscard]] double of(const Outcome& outcome) const;
  [[nodiscard]] bool fails(double fitness) const { return fitness >= fails_at; }
};

/// A test that was executed.
struct ExecutedTest {
  TestInput input;
  Outcome outcome;
  double fitness = 0;
  bool failed = false;
};

}  // namespace jaywalk::search

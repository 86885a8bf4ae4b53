// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/jaywalk/console/progress_line.h"

namespace jaywalk {
namespace {

TEST(ProgressText, SaysHowFarHowFastAndHowLong) {
  EXPECT_EQ(progress_text({.done = 250, .total = 1000}, 0.5),
            "250 of 1000 tests (25 %), 500 per second, 2 s left");
  EXPECT_EQ(progress_text({.done = 6, .total = 600}, 4),
            "6 of 600 tests (1 %), 1.5 per second, 6 min 36 s left");
  EXPECT_EQ(progress_text({.done = 1, .total = 7201}, 1),
            "1 of 7201 tests (0 %), 1.0 per second, 2 h 00 min left");
}

TEST(ProgressText, PromisesNothingBeforeTheFirstTest) {
  EXPECT_EQ(progress_text({.done = 0, .total = 10}, 1), "0 of 10 tests (0 %)");
  EXPECT_EQ(progress_text({.done = 0, .total = 0}, 1), "0 of 0 tests (100 %)");
}

TEST(SearchProgressText, SaysHowFarWhatWasFoundAndHowLong) {
  search::SearchProgress progress{
      .tests = 1200, .failures = 31, .best_fitness = 0.984, .spent = 0.25};
  EXPECT_EQ(progress_text(progress, 60),
            "1200 tests, 31 failing, best fitness 0.98, 25 % of the budget, 3 min 00 s left");
  progress.errors = 2;
  EXPECT_EQ(progress_text(progress, 1),
            "1200 tests, 31 failing, best fitness 0.98, 25 % of the budget, 2 without a result, "
            "3 s left");
}

TEST(SearchProgressText, PromisesNothingBeforeTheFirstTest) {
  EXPECT_EQ(progress_text(search::SearchProgress{}, 1),
            "0 tests, 0 failing, best fitness 0.00, 0 % of the budget");
}

TEST(DurationText, RoundsToWhatMatters) {
  EXPECT_EQ(duration_text(0.4), "0 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s") << "not 60 s";
  EXPECT_EQ(duration_text(3599), "59 min 59 s");
  EXPECT_EQ(duration_text(2 * 3600 + 59 * 60 + 59), "2 h 59 min");
}

}  // namespace
}  // namespace jaywalk

#include "tools/jaywalk/progress_line.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace jaywalk

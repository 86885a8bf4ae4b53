// SPDX-License-Identifier: Apache-2.0
// Where a formula stands, as one number.

#include "interpreter/program/step_place.h"

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

StepPlace again(StepPlace place) { return decode_step_place(encode(place)); }

TEST(StepPlace, IsWhatItWasAfterItsWayThroughANumber) {
  for (const StepPlace place : {StepPlace{}, StepPlace{1, 1, 1}, StepPlace{3, 17, 42},
                                StepPlace{(1U << 26U) - 1, 8191, 8191}}) {
    EXPECT_EQ(again(place).line, place.line);
    EXPECT_EQ(again(place).column, place.column);
    EXPECT_EQ(again(place).length, place.length);
  }
}

TEST(StepPlace, CountsLinesAndColumnsFromOne) {
  const Source source("t", "a.\n  bcd.\n");
  const StepPlace place = step_place(source, {5, 8});
  EXPECT_EQ(place.line, 2U);
  EXPECT_EQ(place.column, 3U);
  EXPECT_EQ(place.length, 3U);
}

TEST(StepPlace, CountsNoColumnOfAVeryLongLineAndNoMoreThanTheLengthThatFits) {
  const Source source("t", std::string(20'000, 'a'));
  EXPECT_EQ(step_place(source, {8'190, 8'191}).column, 8191U);
  EXPECT_EQ(step_place(source, {8'191, 8'192}).column, 0U);
  EXPECT_EQ(step_place(source, {0, 20'000}).length, 8191U);
  EXPECT_EQ(again(step_place(source, {9'000, 20'000})).length, 8191U);
}

}  // namespace
}  // namespace jaywalk

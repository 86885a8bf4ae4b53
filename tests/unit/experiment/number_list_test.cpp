// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/number_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(NumberList, ReadsNumbersAndRanges) {
  EXPECT_THAT(parse_number_list("1..4,10,20", "--agents").value(), ElementsAre(1, 2, 3, 4, 10, 20));
  EXPECT_THAT(parse_number_list("7", "--agents").value(), ElementsAre(7));
  EXPECT_THAT(parse_number_list(" 3 , 5..5 ", "--agents").value(), ElementsAre(3, 5));
}

TEST(NumberList, KeepsTheOrderAndEachNumberOnce) {
  EXPECT_THAT(parse_number_list("5,1..3,2,5", "--agents").value(), ElementsAre(5, 1, 2, 3));
}

TEST(NumberList, RefusesWhatIsNoList) {
  for (const char* text : {"", ",", "1,", "0", "-1", "3..1", "1...3", "1-3", "two", "1.5", "..",
                           "99999999999", "1..4000000000"}) {
    EXPECT_FALSE(parse_number_list(text, "--agents").ok()) << text;
  }
}

TEST(NumberList, ReportsEveryMistakeWithTheOption) {
  const auto list = parse_number_list("one,2,three", "--agents");
  EXPECT_EQ(list.diagnostics().error_count(), 2U);
  EXPECT_THAT(list.diagnostics().render(), HasSubstr("--agents: error: "));
  EXPECT_THAT(list.diagnostics().render(), HasSubstr("'three'"));
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/first_tests.h"

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::HasSubstr;

class TheFirstTests : public testing::Test {
 protected:
  /// A test of the row with 3 agents and the second vehicle.
  static TestKey test(std::uint64_t number) {
    return {.behaviour = 0, .agents = 3, .number = number, .vehicle = 1};
  }
  /// The first tests end, each with the error that it is given.
  void end(const std::string& error, std::uint64_t from, std::uint64_t to) {
    for (std::uint64_t number = from; number < to; ++number) first_.finished(test(number), error);
  }
  std::string why_not(std::uint64_t number) { return first_.why_not_started(test(number)).value(); }

  ExperimentPlan plan_{
      .behaviours = {"walk"}, .agents = {1, 3}, .tests = 100, .vehicles = {"healthy", "latency"}};
  FirstTests first_{plan_};
};

TEST_F(TheFirstTests, KeepTheOthersFromStartingIfAllAreErroredAlike) {
  end("it died", 0, FirstTests::kCount);
  EXPECT_THAT(why_not(8), HasSubstr("not started, since the first 8 tests"));
  EXPECT_THAT(why_not(99), HasSubstr("not started"));
  EXPECT_EQ(why_not(7), "") << "each of the first ones starts";
}

TEST_F(TheFirstTests, LetTheOthersStartIfOneIsNotErrored) {
  end("it died", 0, 7);
  first_.finished(test(7), "");
  EXPECT_EQ(why_not(8), "");
}

TEST_F(TheFirstTests, LetTheOthersStartIfTheirErrorsDiffer) {
  end("it died", 0, 7);
  first_.finished(test(7), "it hung");
  EXPECT_EQ(why_not(8), "");
}

TEST_F(TheFirstTests, DecideAboutTheirOwnRowAlone) {
  end("it died", 0, FirstTests::kCount);
  TestKey other = test(0);
  other.vehicle = 0;
  first_.finished(other, "");
  other.number = 50;
  EXPECT_EQ(first_.why_not_started(other), "");
}

TEST_F(TheFirstTests, AreWantedUntilTheRowIsDecided) {
  EXPECT_TRUE(first_.is_wanted(test(7)));
  EXPECT_FALSE(first_.is_wanted(test(8)));
  first_.finished(test(3), "");
  EXPECT_FALSE(first_.is_wanted(test(7)));
}

TEST_F(TheFirstTests, AreWaitedFor) {
  std::string why = "not asked yet";
  std::jthread waits([&] { why = why_not(20); });
  end("it died", 0, FirstTests::kCount);
  waits.join();
  EXPECT_THAT(why, HasSubstr("not started"));
}

TEST_F(TheFirstTests, AreNoLongerWaitedForWhenThatIsGivenUp) {
  std::optional<std::string> why = "not asked yet";
  std::jthread waits([&] { why = first_.why_not_started(test(20)); });
  first_.give_up();
  waits.join();
  EXPECT_EQ(why, std::nullopt);
}

}  // namespace
}  // namespace jaywalk

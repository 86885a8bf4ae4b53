// SPDX-License-Identifier: Apache-2.0
// An AV of the program's own (<jaywalk/vehicle.h>).

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/experiment_results/experiment_runs.h"
#include <jaywalk/comparison.h>

namespace jaywalk {
namespace {

using testing::HasSubstr;

/// Answers what a function does.
class Answering final : public VehicleDriver {
 public:
  using Answer = double (*)(const VehicleView& view);
  explicit Answering(Answer answer) : answer_(answer) {}
  double decide(const VehicleView& view) override { return answer_(view); }

 private:
  Answer answer_;
};

ScenarioChoice with(Answering::Answer answer) {
  ScenarioChoice choice{.behaviours = {"proximity"}};
  choice.vehicle = std::make_shared<const OwnVehicle>(
      OwnVehicle{.name = "mine", .make = [answer] { return std::make_unique<Answering>(answer); }});
  return choice;
}

class OwnVehicleTest : public StoreTest {
 protected:
  static constexpr const char* kScenario = JAYWALK_SOURCE_DIR "/scenarios/braking.yaml";

  static TestReport run(Answering::Answer answer, std::uint64_t test = 0) {
    return RunnableScenario::read(kScenario, with(answer)).value().run({.test = test}).value();
  }
};

double accelerate(const VehicleView&) { return 1; }
double brake(const VehicleView&) { return -1000; }

TEST_F(OwnVehicleTest, DrivesInsteadOfTheScenarios) {
  const TestReport fast = run(accelerate);
  const TestReport standing = run(brake);
  EXPECT_EQ(fast.error, "");
  EXPECT_EQ(fast.ended_by, "road_end");
  EXPECT_EQ(standing.error, "");
  EXPECT_EQ(standing.ended_by, "time_limit");
  EXPECT_EQ(standing.actors[0].moments.back().speed_mps, 0);
}

TEST_F(OwnVehicleTest, BrakesNoHarderThanAVehicleCan) {
  const TestReport report = run(brake);
  const auto& moments = report.actors[0].moments;
  const double change = moments[0].speed_mps - moments[1].speed_mps;
  EXPECT_NEAR(change, 9.80665 * report.tick_s, 1e-9);
}

TEST_F(OwnVehicleTest, EndsTheTestErroredByAnAnswerThatIsNoNumber) {
  const TestReport report =
      run([](const VehicleView&) { return std::numeric_limits<double>::quiet_NaN(); });
  EXPECT_THAT(report.error, HasSubstr("the controller 'mine': an acceleration of nan m/s2"));
}

TEST_F(OwnVehicleTest, IsRefusedWhereItHasNoMeaning) {
  ScenarioChoice chained = with(accelerate);
  chained.sets = {"world.av.carry_over=true"};
  const auto carrying = RunnableScenario::read(JAYWALK_SOURCE_DIR "/scenarios/paper.yaml", chained);
  ASSERT_FALSE(carrying);
  EXPECT_THAT(carrying.diagnostics().render(), HasSubstr("can carry cells over"));

  ScenarioChoice empty = with(accelerate);
  empty.vehicle = std::make_shared<const OwnVehicle>(OwnVehicle{.name = "mine", .make = {}});
  EXPECT_FALSE(RunnableScenario::read(kScenario, empty));

  const auto scenario = RunnableScenario::read(kScenario, with(accelerate)).value();
  const auto stored = compare(scenario, {.tests = 1, .store = file("own.gpkg")});
  ASSERT_FALSE(stored);
  EXPECT_THAT(stored.diagnostics().render(), HasSubstr("cannot keep tests of a program's own AV"));
  EXPECT_FALSE(std::filesystem::exists(file("own.gpkg")));
}

}  // namespace
}  // namespace jaywalk

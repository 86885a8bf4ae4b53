// SPDX-License-Identifier: Apache-2.0
// Each defect in a scene that was built for it, where the healthy twin keeps clear of all
// pedestrians and the defective one hits one, and in one where it has no reason to act.

#include "env/vehicle/defects.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

constexpr double kPeriodS = 0.05;
constexpr double kSizeM = 0.5;
// The body is 4.5 m to 7.5 m from the left, its lane 3 m to 9 m.
constexpr double kBodyLeftM = 4.5;
constexpr double kBodyRightM = 7.5;

/// Keeps these speeds until some time.
struct Leg {
  double until_s = 0;
  double right_mps = 0;
  double ahead_mps = 0;
};

/// Stands before the first leg's and after the last leg's time.
struct Person {
  double left_m = 0;
  double ahead_m = 0;
  std::vector<Leg> legs;
  double seen_from_s = 0;

  [[nodiscard]] SeenActor at(double time_s, double front_m) const {
    SeenActor actor{.gap_m = ahead_m - front_m, .left_m = left_m};
    double from_s = 0;
    for (const Leg& leg : legs) {
      const double seconds = std::clamp(time_s, from_s, leg.until_s) - from_s;
      actor.left_m += leg.right_mps * seconds;
      actor.gap_m += leg.ahead_mps * seconds;
      if (time_s >= from_s && time_s < leg.until_s) {
        actor.speed_right_mps = leg.right_mps;
        actor.speed_ahead_mps = leg.ahead_mps;
      }
      from_s = leg.until_s;
    }
    actor.right_m = actor.left_m + kSizeM;
    return actor;
  }
};

struct DefectScene {
  std::vector<Person> people;
  std::vector<StopLine> lines;
  std::vector<SeenObstacle> obstacles;
  double cruise_mps = 9;
};

struct Drive {
  std::vector<double> speeds_mps;
  bool hit = false;
};

Drive drive(const std::string& model, const std::vector<VehicleDefect>& defects,
            const DefectScene& scene) {
  VehicleParameters parameters;
  parameters.model = model;
  parameters.defects = defects;
  const auto controller = make_controller(parameters);
  Drive result;
  double front = 0;
  double speed = scene.cruise_mps;
  for (int step = 0; step < 400; ++step) {
    const double time = step * kPeriodS;
    std::vector<SeenActor> actors;
    for (std::size_t i = 0; i < scene.people.size(); ++i) {
      SeenActor actor = scene.people[i].at(time, front);
      actor.id = static_cast<std::uint32_t>(i + 1);
      const bool is_ahead = actor.gap_m > -kSizeM && actor.gap_m < 0;
      const bool is_over = actor.right_m > kBodyLeftM && actor.left_m < kBodyRightM;
      result.hit = result.hit || (is_ahead && is_over && speed > 0);
      if (time >= scene.people[i].seen_from_s) actors.push_back(actor);
    }
    std::vector<StopLine> lines = scene.lines;
    for (StopLine& line : lines) line.gap_m -= front;
    std::vector<SeenObstacle> obstacles = scene.obstacles;
    for (SeenObstacle& each : obstacles) {
      each.gap_m -= front;
      each.far_m -= front;
    }
    const VehicleDecision decision = controller->decide({.time_s = time,
                                                         .period_s = kPeriodS,
                                                         .speed_mps = speed,
                                                         .cruise_mps = scene.cruise_mps,
                                                         .left_m = kBodyLeftM,
                                                         .right_m = kBodyRightM,
                                                         .lane_left_m = 3,
                                                         .lane_right_m = 9,
                                                         .actors = actors,
                                                         .stop_lines = lines,
                                                         .obstacles = obstacles});
    const Motion next =
        drive_on(speed, decision.acceleration_mps2 * kPeriodS, scene.cruise_mps, kPeriodS);
    speed = next.speed;
    front += next.way;
    result.speeds_mps.push_back(speed);
  }
  return result;
}

// Where a careful driver just stops for a pedestrian who steps into the lane from 0.5 m beside it.
constexpr double kBrinkM = 21.9;

/// Walks for so long from the left pavement, and stays.
Person steps_in(double ahead_m, double seconds = 2.2, double mps = 1.5) {
  return {2, ahead_m, {{seconds, mps}}};
}
/// The same after a second of standing at the kerb.
Person sets_out(double ahead_m) { return {2, ahead_m, {{1, 0}, {3.2, 1.5}}}; }
Person stands(double left_m, double ahead_m) { return {left_m, ahead_m, {}}; }
/// Steps in, stays until 3 s, steps out, and in again at some time.
Person returns(double ahead_m, double again_s) {
  return {2, ahead_m, {{1, 1.5}, {3, 0}, {3.8, -1.5}, {again_s, 0}, {again_s + 2.2, 1.5}}};
}

const DefectScene kBystander{.people = {stands(0, 40)}};
const DefectScene kBrink{.people = {steps_in(kBrinkM)}};
const DefectScene kStander{.people = {stands(5.25, 40)}};
const DefectScene kNearStander{.people = {stands(5.25, 20)}};
const DefectScene kSetsOut{.people = {sets_out(kBrinkM + 9)}};
const DefectScene kFromTheRight{.people = {{9.5, kBrinkM, {{2, -1.5}}}}};
const DefectScene kClosedLine{.lines = {{40, true}}};
const DefectScene kPair{.people = {stands(2.4, kBrinkM), steps_in(kBrinkM, 1.5)}};

struct Case {
  std::string defect;
  std::string model;
  DefectScene exposed;  // the healthy twin has no collision, the defective one has
  DefectScene idle;     // both drive the same
};

void PrintTo(const Case& each, std::ostream* out) { *out << each.defect; }

const std::vector<Case>& cases() {
  static const std::string careful = "careful-competent";
  static const std::vector<Case> kCases{
      {"latency", careful, kBrink, kBystander},
      {"short-range=12", careful, kStander, kBystander},
      {"narrow-view=15", careful, kBrink, kStander},
      {"blind-to-standing", careful, kStander, {.people = {steps_in(30, 5)}}},
      {"own-lane-only", careful, kBrink, kStander},
      {"own-path-only", careful, kBrink, kStander},
      {"slow-tracking",
       careful,
       {.people = {{.left_m = 5.25, .ahead_m = 28.5, .legs = {}, .seen_from_s = 1}}},
       kBrink},
      {"class-change", careful, kStander, kBystander},
      {"merged-group", careful, kPair, kBrink},
      {"off-crossing", careful, kBrink, {.people = {steps_in(kBrinkM)}, .lines = {{20, false}}}},
      {"near-obstacle",
       careful,
       {.people = {steps_in(kBrinkM)}, .obstacles = {{kBrinkM - 5, kBrinkM - 0.2, 2, 4.5}}},
       kBrink},
      {"near-blind", "braking", kStander, kBystander},
      {"frozen-frames=1", careful, kSetsOut, kStander},
      {"lateral-bias", careful, kFromTheRight, kStander},
      {"range-bias", "braking", kStander, kBystander},
      {"blind-left", careful, kBrink, kFromTheRight},
      {"blind-right", careful, kFromTheRight, kBrink},
      {"fast-as-noise", careful, {.people = {steps_in(kBrinkM - 1.5, 1.1, 3)}}, kBrink},
      {"constant-velocity", careful, kSetsOut, kStander},
      {"kerb-standing", careful, kSetsOut, kBrink},
      {"stops-at-kerb", careful, kBrink, kStander},
      {"forgets-turners", careful, {.people = {{2, 24, {{2.2, 1.5}, {2.4, -1.5}}}}}, kBrink},
      {"ignores-along", careful, {.people = {{5.25, 30, {{20, 0, 0.3}}}}}, kBrink},
      {"group-as-first", careful, kPair, kBrink},
      {"trusts-walkers", careful, {.people = {steps_in(37)}}, kStander},
      {"confirmation", careful, kBrink, kBystander},
      {"brakes-once", careful, {.people = {returns(36, 5)}}, kBrink},
      {"resumes-early", careful, {.people = {steps_in(28.5, 20, 0.5)}}, kBrink},
      {"nearest-only", careful, {.people = {stands(0, 20), steps_in(kBrinkM)}}, kBrink},
      {"comfort-braking", careful, kBrink, kBystander},
      {"off-when-slow", careful, kNearStander, kBystander},
      {"off-when-fast", careful, kStander, {.people = {stands(5.25, 40)}, .cruise_mps = 7}},
      {"creeps", careful, kNearStander, kBystander},
      {"gives-up", careful, kStander, kBystander},
      {"zebra-only", careful, kStander, kClosedLine},
      {"blind-after-stop", careful, {.people = {returns(26.5, 4)}}, kBrink},
      {"slow-brakes", careful, kBrink, kBystander},
      {"low-friction", careful, kBrink, kBystander},
      {"brake-fade", careful, {.people = {returns(30, 5)}}, kBrink},
      {"pedal-change", careful, kBrink, kBystander},
      {"actuation-delay", careful, kBrink, kBystander},
      {"weak-brakes", careful, kBrink, kBystander},
  };
  return kCases;
}

class Defects : public testing::TestWithParam<Case> {};

TEST_P(Defects, MakeTheVehicleHitWhomItsHealthyTwinSpares) {
  const Case& each = GetParam();
  EXPECT_FALSE(drive(each.model, {}, each.exposed).hit) << "healthy";
  EXPECT_TRUE(drive(each.model, {*parse_defect(each.defect)}, each.exposed).hit);
}

TEST_P(Defects, ChangeNothingWithoutAReason) {
  const Case& each = GetParam();
  EXPECT_EQ(drive(each.model, {*parse_defect(each.defect)}, each.idle).speeds_mps,
            drive(each.model, {}, each.idle).speeds_mps);
}

TEST_P(Defects, AreDeterministic) {
  const Case& each = GetParam();
  const VehicleDefect defect = *parse_defect(each.defect);
  EXPECT_EQ(drive(each.model, {defect}, each.exposed).speeds_mps,
            drive(each.model, {defect}, each.exposed).speeds_mps);
}

INSTANTIATE_TEST_SUITE_P(Vehicle, Defects, testing::ValuesIn(cases()), [](const auto& each) {
  std::string name = each.param.defect.substr(0, each.param.defect.find('='));
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(DefectTable, HasAtLeastThirtyRowsEachWithItsScene) {
  EXPECT_GE(defect_models().size(), 30U);
  std::set<std::string_view> names;
  for (const DefectModel& model : defect_models()) {
    EXPECT_TRUE(names.insert(model.name).second) << model.name << " is there twice";
    EXPECT_EQ(find_defect(model.name), &model);
    EXPECT_TRUE(std::ranges::any_of(
        cases(), [&](const Case& each) { return parse_defect(each.defect)->name == model.name; }))
        << model.name << " has no scene";
  }
}

TEST(DefectTable, DescribesEachDefectAndNamesItsSource) {
  for (const DefectModel& model : defect_models()) {
    EXPECT_FALSE(model.summary.empty()) << model.name;
    EXPECT_FALSE(model.source.empty()) << model.name;
    ASSERT_FALSE(model.severities.empty()) << model.name;
    if (model.unit.empty()) {
      EXPECT_EQ(model.severities.size(), 1U) << model.name;
    }
    for (const double severity : model.severities) EXPECT_GT(severity, 0) << model.name;
  }
}

TEST(DefectText, RoundTrips) {
  for (const DefectModel& model : defect_models()) {
    for (const double severity : model.severities) {
      const VehicleDefect defect{std::string(model.name), severity};
      EXPECT_EQ(parse_defect(text_of(defect)), defect) << text_of(defect);
    }
  }
  EXPECT_EQ(text_of({"latency", 0.3}), "latency=0.3");
  EXPECT_EQ(text_of({"blind-left", 1}), "blind-left");
  EXPECT_EQ(parse_defect("latency=0.25"), (VehicleDefect{"latency", 0.25}));
}

TEST(DefectText, OfADefectAloneHasTheFirstSeverityOfItsRow) {
  for (const DefectModel& model : defect_models()) {
    EXPECT_EQ(parse_defect(model.name),
              (VehicleDefect{std::string(model.name), model.severities.front()}));
  }
}

TEST(DefectText, IsRefusedWhereItMeansNothing) {
  for (const char* text : {"", "=", "=0.3", "latencies", "latency=", "latency=0", "latency=-1",
                           "latency=inf", "latency=nan", "latency=1e999", "latency=0.3s",
                           "latency =0.3", "latency=0.3=1", "blind-left=1", "weak-brakes=101"}) {
    EXPECT_EQ(parse_defect(text), std::nullopt) << text;
  }
}

TEST(Defect, OfAnySeverityAnswersWithANumber) {
  for (const DefectModel& model : defect_models()) {
    for (const double severity : {1e-308, 1e-9, 1.0, 1e9, 1e300}) {
      if (model.unit.empty() && severity != 1) continue;
      const VehicleDefect defect{std::string(model.name), severity};
      for (const double speed : drive("braking", {defect}, kSetsOut).speeds_mps) {
        ASSERT_TRUE(speed >= 0 && speed <= kSetsOut.cruise_mps) << text_of(defect);
      }
    }
  }
}

/// Notes what it sees and answers as told.
class Probe final : public VehicleController {
 public:
  explicit Probe(std::vector<SeenActor>* seen) : seen_(seen) {}
  VehicleDecision decide(const VehicleView& view) override {
    seen_->assign(view.actors.begin(), view.actors.end());
    return {-5};
  }
  [[nodiscard]] double longest_period_s() const override { return 0.07; }
  [[nodiscard]] std::string failure() const override { return "it died"; }

 private:
  std::vector<SeenActor>* seen_;
};

TEST(Defect, HandsOnWhatItsControllerSaysOfItself) {
  for (const DefectModel& model : defect_models()) {
    std::vector<SeenActor> seen;
    const auto defective = model.make(std::make_unique<Probe>(&seen), model.severities.front());
    EXPECT_EQ(defective->longest_period_s(), 0.07) << model.name;
    EXPECT_EQ(defective->failure(), "it died") << model.name;
  }
}

TEST(Defect, IsPutOnInTheOrderOfTheList) {
  std::vector<SeenActor> seen;
  const SeenActor actor{.id = 1, .gap_m = 21, .left_m = 5, .right_m = 5.5};
  const auto sees = [&](std::vector<VehicleDefect> defects) {
    const auto controller = with_defects(std::make_unique<Probe>(&seen), defects);
    static_cast<void>(controller->decide({.period_s = 0.1, .actors = {&actor, 1}}));
    return !seen.empty();
  };
  EXPECT_FALSE(sees({{"short-range", 22}, {"range-bias", 3}})) << "the biased one is out of range";
  EXPECT_TRUE(sees({{"range-bias", 3}, {"short-range", 22}})) << "in range, and then biased";
}

TEST(Defect, LeavesAModelWithoutControllerAlone) {
  const VehicleDefect defect{"latency", 0.3};
  EXPECT_EQ(with_defects(nullptr, {&defect, 1}), nullptr);
}

TEST(Latency, ShowsOthersAsTheyWereAndTheVehicleAsItIs) {
  std::vector<SeenActor> seen;
  const auto controller = find_defect("latency")->make(std::make_unique<Probe>(&seen), 0.3);
  for (int tick = 0; tick < 10; ++tick) {
    const SeenActor actor{.id = 1, .gap_m = 50.0 - tick, .left_m = 5, .right_m = 5.5};
    static_cast<void>(controller->decide(
        {.time_s = tick * 0.1, .period_s = 0.1, .speed_mps = 9, .actors = {&actor, 1}}));
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_EQ(seen.front().gap_m, 50.0 - std::max(tick - 3, 0)) << tick;
  }
}

}  // namespace
}  // namespace jaywalk

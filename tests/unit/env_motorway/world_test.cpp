// SPDX-License-Identifier: Apache-2.0
// The motorway as what is the same in all tests: its ground, its plan, its names, its variants.

#include "env/motorway/world.h"

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/env_motorway/motorway.h"

namespace jaywalk::motorway {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::shared_ptr<const MotorwaySpec> spec_of(const MotorwayParameters& parameters = {}) {
  return std::make_shared<const MotorwaySpec>(parameters);
}

TEST(MotorwaySpec, HasALaneOfGroundForEachOfWhichOneIsTheAvs) {
  MotorwayParameters parameters;
  parameters.lanes = 4;
  parameters.lane_m = 4;
  parameters.av.lane = 3;
  parameters.length_m = 600;
  const Ground ground = spec_of(parameters)->ground();
  ASSERT_EQ(ground.areas.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Area& lane = ground.areas[i];
    EXPECT_EQ(lane.kind, AreaKind::lane);
    EXPECT_EQ(lane.of_av, i == 2) << i;
    EXPECT_TRUE(contains(lane, {4.0 * static_cast<double>(i) + 2, 300}));
    EXPECT_FALSE(contains(lane, {4.0 * static_cast<double>(i) + 2, 601}));
    EXPECT_FALSE(contains(lane, {4.0 * static_cast<double>(i) + 6, 300}));
  }
  EXPECT_EQ(ground.av_lane(), &ground.areas[2]);
  EXPECT_EQ(ground.cruise_mps, 30);
  EXPECT_TRUE(ground.moves_evenly);
  EXPECT_THAT(ground.obstacles, IsEmpty());
  EXPECT_THAT(ground.crosswalks, IsEmpty());
}

TEST(MotorwaySpec, IsPlannedInSquaresAsBroadAsALane) {
  MotorwayParameters parameters;
  parameters.lane_m = 4;
  parameters.length_m = 602;
  const GroundPlan plan = spec_of(parameters)->plan();
  EXPECT_EQ(plan.cell_m, 4);
  EXPECT_EQ(plan.grid.rows, 3);
  EXPECT_EQ(plan.grid.cells, 151) << "the last square is not full";
  EXPECT_GE(plan.length_m(), 602);
  EXPECT_EQ(plan.breadth_m(), 12);
  ASSERT_EQ(plan.cells.size(), 3U * 151U);
  EXPECT_EQ(plan.at({2, 150}), Surface::lane);
  for (int row = 0; row < 3; ++row) EXPECT_EQ(plan.band_of(row).kind, AreaKind::lane);
}

TEST(MotorwaySpec, NamesItsVehiclesByNumber) {
  EXPECT_EQ(spec_of()->agent_name(1), "v1");
  EXPECT_EQ(spec_of()->agent_name(12), "v12");
  EXPECT_EQ(spec_of()->kind(), "motorway");
  EXPECT_EQ(spec_of()->tick_s(), 0.5);
}

TEST(MotorwaySpec, HasNoSimulatorNoCellsNoCarryOver) {
  const auto spec = spec_of();
  EXPECT_EQ(spec->simulator().name, "");
  EXPECT_THAT(spec->start_cells({}), IsEmpty());
  EXPECT_FALSE(spec->carries_over());
  EXPECT_FALSE(spec->has_given_starts());
  EXPECT_EQ(spec->problem({.agents = 50}), "");
  EXPECT_THAT(spec->absent_percepts(), IsEmpty());
}

TEST(MotorwaySpec, WithAnotherVehicleIsOtherwiseTheSame) {
  MotorwayParameters parameters;
  parameters.lanes = 5;
  const auto spec = spec_of(parameters);
  VehicleParameters aeb;
  aeb.model = "aeb";
  const auto changed = spec->with(aeb, {});
  EXPECT_EQ(changed->vehicle().model, "aeb");
  EXPECT_EQ(spec->vehicle().model, "idm") << "the first one stays what it was";
  EXPECT_FALSE(changed->same_as(*spec));
  EXPECT_TRUE(changed->with(spec->vehicle(), {})->same_as(*spec));
}

TEST(MotorwaySpec, IsTheSameAsOneOfTheSameParametersAlone) {
  EXPECT_TRUE(spec_of()->same_as(*spec_of()));
  for (const auto change : {+[](MotorwayParameters& p) { p.headway_s = 2; },
                            +[](MotorwayParameters& p) { p.drivers.sight_m = 10; },
                            +[](MotorwayParameters& p) { p.av.twin = VehicleParameters{}; },
                            +[](MotorwayParameters& p) { p.reward = 1; },
                            +[](MotorwayParameters& p) { p.aftermath = 11; }}) {
    MotorwayParameters other;
    change(other);
    EXPECT_FALSE(spec_of(other)->same_as(*spec_of()));
  }
}

TEST(MotorwaySpec, IsHealthyWithoutItsDefectsOrAsItsTwin) {
  MotorwayParameters parameters;
  parameters.av.vehicle.defects = {{"latency", 0.6}};
  EXPECT_THAT(spec_of(parameters)->healthy_vehicle().defects, IsEmpty());
  EXPECT_EQ(spec_of(parameters)->healthy_vehicle().model, "idm");
  parameters.av.twin = VehicleParameters{.model = "aeb"};
  EXPECT_EQ(spec_of(parameters)->healthy_vehicle().model, "aeb");
}

TEST(MotorwaySpec, StartsTheCommandOfItsVehicleOrElseOfItsTwin) {
  MotorwayParameters parameters;
  EXPECT_THAT(spec_of(parameters)->command(), IsEmpty());
  parameters.av.twin = VehicleParameters{.model = "external", .command = {"python3", "twin.py"}};
  EXPECT_THAT(spec_of(parameters)->command(), ElementsAre("python3", "twin.py"));
  parameters.av.vehicle.model = "external";
  parameters.av.vehicle.command = {"./drive"};
  EXPECT_THAT(spec_of(parameters)->command(), ElementsAre("./drive"));
}

TEST(MotorwaySpec, MakesWorldsThatBeginWhereItsVehiclesSpawn) {
  const auto spec = spec_of();
  SymbolTable symbols;
  const auto prepared = spec->prepare(symbols);
  EXPECT_TRUE(prepared->spec().same_as(*spec));
  const WorldStart start{.agents = 3, .seed = 11};
  const auto world = prepared->make(start);
  EXPECT_EQ(world->kind(), "motorway");
  EXPECT_EQ(world->tick_ms(), 500);
  EXPECT_EQ(world->ticks(), 0);
  EXPECT_EQ(world->left_over(), 0);
  EXPECT_FALSE(world->finished());
  const auto vehicles = spec->spawn(start);
  const Scene scene = world->scene();
  ASSERT_EQ(scene.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(scene[i + 1].x_m, vehicles[i].x_m);
    EXPECT_DOUBLE_EQ(scene[i + 1].y_m, vehicles[i].front_m - 2.25);
  }
}

TEST(MotorwaySpec, SpawnsByTheSeedAloneAndThoseBeforeMoreAlike) {
  const auto spec = spec_of();
  const auto few = spec->spawn({.agents = 2, .test = 1, .seed = 5});
  const auto many = spec->spawn({.agents = 6, .test = 9, .seed = 5});
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].front_m, many[i].front_m) << "whoever comes later changes nothing";
    EXPECT_EQ(few[i].lane, many[i].lane);
  }
  EXPECT_NE(spec->spawn({.seed = 6})[0].front_m, few[0].front_m);
}

TEST(MotorwaySpec, SpawnsBehindAllOthersWhereThereIsNoRoomBetween) {
  MotorwayParameters parameters;
  parameters.lanes = 2;
  parameters.av.lane = 1;
  parameters.drivers.start_from_m = 0;
  parameters.drivers.start_to_m = 1;
  const auto vehicles = spec_of(parameters)->spawn({.agents = 4, .seed = 3});
  for (std::size_t i = 1; i < vehicles.size(); ++i) {
    EXPECT_NEAR(vehicles[i].front_m, vehicles[i - 1].front_m - 14.5, 1e-9);
    EXPECT_EQ(vehicles[i].lane, 2);
  }
}

TEST(MotorwaySpec, KeepsTheDistanceOfALongAv) {
  MotorwayParameters parameters;
  parameters.lanes = 1;
  parameters.av.lane = 1;
  parameters.av.length_m = 18;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const double front = spec_of(parameters)->spawn({.seed = seed})[0].front_m;
    EXPECT_GE(std::abs(front - 100), 28) << "18 m and a gap of 10 m";
  }
}

}  // namespace
}  // namespace jaywalk::motorway

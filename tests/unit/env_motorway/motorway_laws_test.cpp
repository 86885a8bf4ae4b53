// SPDX-License-Identifier: Apache-2.0
// What holds on the motorway whatever drivers do: they act by chance, and each tick is looked at.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "env/motorway/motorway.h"
#include "env/motorway/world.h"

namespace jaywalk {
namespace {

constexpr double kClose = 1e-9;

/// Five drivers near each other and near the AV.
class ByChance {
 public:
  explicit ByChance(unsigned seed, std::string model = "idm") : random_(seed) {
    parameters_.av.vehicle.model = std::move(model);
    parameters_.length_m = 2000;
    std::vector<MotorwayVehicle> vehicles;
    for (std::uint32_t i = 0; i < kDrivers; ++i) {
      const int lane = i % 2 == 0 ? 1 : 3;
      vehicles.push_back({.x_m = middle_of_lane(parameters_, lane),
                          .front_m = 80 + 12.0 * i,
                          .speed_mps = 25 + static_cast<double>(random_() % 10),
                          .lane = lane});
    }
    motorway.emplace(parameters_, vocabulary_, std::move(vehicles));
  }

  /// One tick in which each driver does something.
  void tick() {
    std::vector<ActionRequest> actions;
    std::vector<std::vector<Value>> args(kDrivers);
    for (std::uint32_t i = 0; i < kDrivers; ++i) {
      const auto action = static_cast<MotorwayAction>(random_() % 4);
      if (action == MotorwayAction::change_lane) args[i] = {way()};
      if (action == MotorwayAction::accelerate || action == MotorwayAction::brake) {
        args[i] = {Value::number(static_cast<double>(random_() % 12))};
      }
      actions.push_back({AgentId{i}, vocabulary_.action(action), args[i]});
    }
    results.assign(kDrivers, {});
    motorway->execute(actions, results);
    motorway->advance();
  }

  /// An agent's percepts of a name: their arguments, by the first of them.
  [[nodiscard]] std::map<double, std::vector<double>> percepts(std::string_view name,
                                                               std::uint32_t agent) const {
    Percepts all;
    motorway->perceive(AgentId{agent}, all);
    std::map<double, std::vector<double>> found;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (symbols_.functor(all.predicate(i)) != name) continue;
      std::vector<double> args;
      for (const Value value : all.args(i)) args.push_back(value.as_number());
      found[args.front()] = args;
    }
    return found;
  }
  [[nodiscard]] const MotorwayParameters& parameters() const { return parameters_; }

  static constexpr std::uint32_t kDrivers = 5;
  std::optional<Motorway> motorway;
  std::vector<ActionResult> results;

 private:
  Value way() { return random_() % 2 == 0 ? vocabulary_.left() : vocabulary_.right(); }

  SymbolTable symbols_;
  MotorwayVocabulary vocabulary_{symbols_};
  MotorwayParameters parameters_;
  std::mt19937 random_;
};

/// Calls `look` after each tick of twenty tests, until they end.
template <class Look>
void for_each_tick(Look look) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    ByChance test(seed, seed % 2 == 0 ? "idm" : "constant");
    for (int i = 0; i < 60 && !test.motorway->finished(); ++i) {
      test.tick();
      look(test);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(MotorwayByChance, VehiclesStayOnTheCarriagewayAndWithinTheirSpeeds) {
  for_each_tick([](const ByChance& test) {
    for (const MotorwayVehicle& each : test.motorway->vehicles()) {
      EXPECT_GE(each.x_m, middle_of_lane(test.parameters(), 1) - kClose);
      EXPECT_LE(each.x_m, middle_of_lane(test.parameters(), test.parameters().lanes) + kClose);
      EXPECT_GE(each.speed_mps, 0);
      EXPECT_LE(each.speed_mps, test.parameters().drivers.greatest_speed_mps);
    }
    EXPECT_LE(test.motorway->av_speed_mps(), test.parameters().av.speed_mps + kClose);
  });
}

TEST(MotorwayByChance, NoSpeedChangesByMoreThanDriversCan) {
  std::vector<double> before;
  for_each_tick([&](const ByChance& test) {
    const MotorwayParameters::Drivers& drivers = test.parameters().drivers;
    if (test.motorway->ticks() == 1) before.clear();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double change = test.motorway->vehicles()[i].speed_mps - before[i];
      EXPECT_LE(change, drivers.acceleration_mps2 * test.parameters().tick_s + kClose);
      EXPECT_GE(change, -drivers.braking_mps2 * test.parameters().tick_s - kClose);
    }
    before.clear();
    for (const MotorwayVehicle& each : test.motorway->vehicles()) before.push_back(each.speed_mps);
  });
}

TEST(MotorwayByChance, WhoKeepsALaneIsInItsMiddle) {
  for_each_tick([](const ByChance& test) {
    for (const MotorwayVehicle& each : test.motorway->vehicles()) {
      if (each.changing || each.crashed) continue;
      EXPECT_NEAR(each.x_m, middle_of_lane(test.parameters(), each.lane), kClose);
    }
  });
}

TEST(MotorwayByChance, DriversSeeEachOtherAsFarAsTheyAre) {
  for_each_tick([](const ByChance& test) {
    const auto vehicles = test.motorway->vehicles();
    const auto seen = test.percepts("vehicle", 0);
    EXPECT_FALSE(seen.contains(1)) << "itself";
    for (std::uint32_t i = 1; i < ByChance::kDrivers; ++i) {
      const double ahead = vehicles[i].front_m - vehicles[0].front_m;
      EXPECT_EQ(seen.contains(i + 1), std::fabs(ahead) <= test.parameters().drivers.sight_m);
      if (!seen.contains(i + 1)) continue;
      EXPECT_NEAR(seen.at(i + 1)[2], ahead, kClose);
      EXPECT_NEAR(test.percepts("vehicle", i).at(1)[2], -ahead, kClose);
      EXPECT_EQ(seen.at(i + 1)[1], test.percepts("lane", i).begin()->first);
    }
  });
}

TEST(MotorwayByChance, TheAvIsWhereEachDriverPerceivesIt) {
  for_each_tick([](const ByChance& test) {
    for (std::uint32_t i = 0; i < ByChance::kDrivers; ++i) {
      const auto av = test.percepts("av", i).begin()->second;
      const double front = test.percepts("front", i).begin()->first;
      EXPECT_EQ(av[0], test.parameters().av.lane);
      EXPECT_NEAR(front + av[1], test.motorway->av_front_m(), kClose);
      EXPECT_EQ(av[2], test.motorway->av_speed_mps());
      EXPECT_EQ(test.percepts("tick", i).begin()->first, test.motorway->ticks() + 1);
    }
  });
}

TEST(MotorwayByChance, AWreckStaysAWreckAndObeysNobody) {
  std::vector<bool> crashed;
  std::size_t wrecks = 0;
  for_each_tick([&](const ByChance& test) {
    if (test.motorway->ticks() == 1) crashed.assign(ByChance::kDrivers, false);
    for (std::uint32_t i = 0; i < ByChance::kDrivers; ++i) {
      const MotorwayVehicle& each = test.motorway->vehicles()[i];
      if (crashed[i]) {
        ++wrecks;
        EXPECT_TRUE(each.crashed);
        EXPECT_EQ(test.results[i].reason, "it has crashed");
        EXPECT_TRUE(test.motorway->last_action_failed(i));
        EXPECT_TRUE(test.percepts("crashed", i).contains(i + 1));
      }
      crashed[i] = each.crashed;
    }
  });
  EXPECT_GT(wrecks, 20U) << "none was looked at";
}

TEST(MotorwayByChance, TimeCostsUntilThePreconditionAlone) {
  std::size_t met = 0;
  int met_at = 0;
  for_each_tick([&](const ByChance& test) {
    const WorldResult& result = test.motorway->result();
    if (test.motorway->ticks() == 1) met_at = 1;
    if (!result.success) met_at = test.motorway->ticks() + 1;
    EXPECT_EQ(result.success, !result.met_by.empty());
    EXPECT_EQ(result.all_ticks, test.motorway->ticks());
    met += result.success ? 1 : 0;
    EXPECT_TRUE(!result.success || result.ticks == met_at);
    EXPECT_TRUE(result.success || result.ticks == result.all_ticks);
    for (std::size_t i = 0; i < ByChance::kDrivers; ++i) {
      EXPECT_EQ(result.agents[i].cost, test.parameters().cost * result.ticks);
      const bool is_it = std::ranges::count(result.met_by, i) > 0;
      EXPECT_EQ(result.agents[i].reward, is_it ? test.parameters().reward : 0);
    }
  });
  EXPECT_GT(met, 20U) << "none was looked at";
}

TEST(MotorwayByChance, TheSameActionsLeadToTheSameScenes) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    ByChance one(seed);
    ByChance other(seed);
    for (int i = 0; i < 40 && !one.motorway->finished(); ++i) {
      one.tick();
      other.tick();
      EXPECT_EQ(one.motorway->scene(), other.motorway->scene());
    }
    EXPECT_EQ(one.motorway->result().end, other.motorway->result().end);
  }
}

}  // namespace
}  // namespace jaywalk

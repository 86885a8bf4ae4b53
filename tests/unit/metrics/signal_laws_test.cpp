// SPDX-License-Identifier: Apache-2.0
// What holds of signals and metrics whatever people and the AV do: of random drives.

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "env/scene.h"
#include "experiment/judge/metrics/metrics.h"
#include "experiment/judge/signals/signals.h"
#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

constexpr int kDrives = 60;
constexpr double kHard = 0.774 * kGravityMps2;

/// The AV along x = 0 at changing speeds and two people who wander about in front of it.
std::vector<std::vector<Place>> random_ways(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> speed(0, 12);
  std::uniform_real_distribution<double> step(-2, 2);
  std::uniform_real_distribution<double> across(-6, 6);
  std::uniform_real_distribution<double> along(0, 40);
  std::vector<std::vector<Place>> ways(3);
  ways[0] = {{0, 0}};
  for (std::size_t i = 1; i < 3; ++i) ways[i] = {{across(random), along(random)}};
  for (int tick = 0; tick < 6; ++tick) {
    ways[0].push_back({0, ways[0].back().y + speed(random)});
    for (std::size_t i = 1; i < 3; ++i) {
      const Place last = ways[i].back();
      ways[i].push_back({last.x + step(random), last.y + step(random)});
    }
  }
  return ways;
}

/// Calls back with each random drive.
template <class Check>
void for_each_drive(Check check) {
  for (std::uint64_t seed = 1; seed <= kDrives; ++seed) {
    SCOPED_TRACE(seed);
    const Recording recording = drive(1, random_ways(seed));
    const Ground ground = road();
    check(TestView(recording, ground));
  }
}

TEST(SignalLaws, TheClosestIsNoFurtherThanTheDistanceAtTheTick) {
  int closer = 0;
  for_each_drive([&](const TestView& view) {
    const auto distance = view.values(SignalId::distance, 1);
    const auto closest = view.values(SignalId::closest, 1);
    for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
      EXPECT_GE(closest[tick], 0);
      EXPECT_LE(closest[tick], distance[tick] + 1e-9);
      closer += closest[tick] < distance[tick] - 0.1;
    }
  });
  EXPECT_GT(closer, 20) << "it is not the distance";
}

TEST(SignalLaws, ACollisionIsAClosestDistanceOfZero) {
  int collisions = 0;
  for_each_drive([&](const TestView& view) {
    const auto closest = view.values(SignalId::closest, 1);
    const auto collision = view.values(SignalId::collision, 1);
    for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
      EXPECT_EQ(collision[tick] != 0, closest[tick] == 0) << tick;
      collisions += collision[tick] != 0;
    }
  });
  EXPECT_GT(collisions, 5) << "or the drives show nothing";
}

TEST(SignalLaws, AnImpactIsTheBeginOfAContactNoFasterThanTheAv) {
  int impacts = 0;
  for_each_drive([&](const TestView& view) {
    const auto impact = view.values(SignalId::impact_speed, 1);
    const auto collision = view.values(SignalId::collision, 1);
    const auto distance = view.values(SignalId::distance, 1);
    for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
      if (impact[tick] == 0) continue;
      ++impacts;
      EXPECT_NE(collision[tick], 0);
      EXPECT_GT(distance[tick - 1], 0) << "who is touched already is not hit again";
      EXPECT_LE(impact[tick], 12);
    }
  });
  EXPECT_GT(impacts, 5);
}

TEST(SignalLaws, TheTimeToCollisionIsThatOfAContact) {
  int checked = 0;
  for_each_drive([&](const TestView& view) {
    const auto ttc = view.values(SignalId::ttc, 1);
    for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
      EXPECT_GE(ttc[tick], 0);
      if (std::isinf(ttc[tick]) || ttc[tick] == 0) continue;
      // After that time at constant velocities the boxes touch, shortly before they do not.
      const auto moved = [&](ActorIndex actor, double seconds) {
        ActorState state = view.state(actor, tick);
        state.x_m += seconds * state.speed_mps * std::cos(state.heading_rad);
        state.y_m += seconds * state.speed_mps * std::sin(state.heading_rad);
        return box(view.recording().actors()[actor], state);
      };
      EXPECT_NEAR(distance_m(moved(0, ttc[tick]), moved(1, ttc[tick])), 0, 1e-6);
      EXPECT_GT(distance_m(moved(0, 0.99 * ttc[tick]), moved(1, 0.99 * ttc[tick])), 0);
      ++checked;
    }
  });
  EXPECT_GT(checked, 20);
}

TEST(SignalLaws, TheBrakeThreatIsTheDecelerationByTheHardest) {
  int threats = 0;
  for_each_drive([&](const TestView& view) {
    const auto drac = view.values(SignalId::drac, 1);
    const auto btn = view.values(SignalId::btn, 1);
    for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
      EXPECT_GE(drac[tick], 0);
      if (std::isinf(drac[tick])) {
        EXPECT_TRUE(std::isinf(btn[tick]));
      } else {
        EXPECT_NEAR(btn[tick], drac[tick] / kHard, 1e-4 * (1 + btn[tick]));
        threats += drac[tick] > 0;
      }
    }
  });
  EXPECT_GT(threats, 20);
}

TEST(SignalLaws, WhoIsInPathIsAheadAndWhoIsInLaneIsInRoadAndOverLane) {
  std::map<SignalId, int> seen;
  for_each_drive([&](const TestView& view) {
    for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
      const auto is = [&](SignalId signal) { return view.values(signal, 2)[tick] != 0; };
      for (const SignalId signal : {SignalId::in_path, SignalId::in_lane, SignalId::in_zone}) {
        seen[signal] += is(signal);
      }
      if (is(SignalId::in_path)) {
        EXPECT_FALSE(std::isinf(view.values(SignalId::gap, 2)[tick]));
      }
      if (is(SignalId::in_lane)) {
        EXPECT_TRUE(is(SignalId::in_road));
        EXPECT_TRUE(is(SignalId::over_lane));
      }
      if (is(SignalId::in_zone)) {
        EXPECT_TRUE(is(SignalId::in_lane));
      }
    }
  });
  for (const auto& [signal, ticks] : seen) EXPECT_GT(ticks, 5);
}

TEST(SignalLaws, TimeAndWhatRemainsAddUpToTheRecord) {
  for_each_drive([](const TestView& view) {
    const auto time = view.values(SignalId::time);
    const auto remaining = view.values(SignalId::remaining);
    for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
      EXPECT_DOUBLE_EQ(time[tick] + remaining[tick], 6);
    }
  });
}

TEST(SignalLaws, BrakingIsTheOtherSideOfAcceleration) {
  int braking = 0;
  for_each_drive([&](const TestView& view) {
    const auto acceleration = view.values(SignalId::av_acceleration);
    const auto deceleration = view.values(SignalId::av_deceleration);
    for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
      EXPECT_DOUBLE_EQ(deceleration[tick], std::max(0.0, -acceleration[tick]));
      braking += deceleration[tick] > 0;
    }
  });
  EXPECT_GT(braking, 20);
}

TEST(SignalLaws, NothingDependsOnWhereAlongTheRoadItHappens) {
  for (std::uint64_t seed = 1; seed <= kDrives; ++seed) {
    SCOPED_TRACE(seed);
    auto ways = random_ways(seed);
    const Recording here = drive(1, ways);
    for (auto& way : ways) {
      for (Place& place : way) place.y += 128;
    }
    const Recording there = drive(1, ways);
    const Ground ground = road();
    const TestView first(here, ground);
    const TestView second(there, ground);
    for (const SignalId signal :
         {SignalId::distance, SignalId::closest, SignalId::gap, SignalId::ttc, SignalId::time_gap,
          SignalId::drac, SignalId::in_lane, SignalId::avoidable}) {
      for (std::size_t tick = 0; tick < first.ticks(); ++tick) {
        const double expected = first.values(signal, 1)[tick];
        const double found = second.values(signal, 1)[tick];
        if (std::isinf(expected)) {
          EXPECT_EQ(found, expected);
        } else {
          EXPECT_NEAR(found, expected, 1e-6 * (1 + std::fabs(expected)))
              << signals()[static_cast<std::size_t>(signal)].name;
        }
      }
    }
  }
}

TEST(SignalLaws, NoValueIsNotANumber) {
  for_each_drive([](const TestView& view) {
    for (std::size_t i = 0; i < signals().size(); ++i) {
      for (const double value : view.values(static_cast<SignalId>(i), 1)) {
        EXPECT_FALSE(std::isnan(value)) << signals()[i].name;
      }
    }
  });
}

/// The value of a metric; nothing if it has none.
std::optional<double> value(std::string_view name, const TestView& view) {
  const auto found = measured(*find_metric(name), view);
  return found ? std::optional(found->value) : std::nullopt;
}

TEST(MetricLaws, TheLeastDistanceIsThatOfSomeTickOrLess) {
  for_each_drive([](const TestView& view) {
    double least = 1e9;
    for (const ActorIndex user : view.road_users()) {
      for (const double each : view.values(SignalId::closest, user)) least = std::min(least, each);
    }
    EXPECT_DOUBLE_EQ(value("min_distance", view).value(), least);
  });
}

TEST(MetricLaws, ACollisionHasAnImpactAndNoDistance) {
  std::uint64_t collisions = 0;
  for_each_drive([&](const TestView& view) {
    const bool collided = value("impact_speed", view).has_value();
    EXPECT_EQ(collided, value("min_distance", view) == 0);
    collisions += collided;
  });
  EXPECT_GT(collisions, 0U);
  EXPECT_LT(collisions, kDrives);
}

TEST(MetricLaws, TheExposedTimeIsNoLessThanItsIntegral) {
  int exposures = 0;
  for_each_drive([&](const TestView& view) {
    const auto exposed = value("tet", view);
    const auto integral = value("tit", view);
    ASSERT_EQ(exposed.has_value(), integral.has_value());
    if (exposed) {
      EXPECT_GE(*exposed, *integral);
      EXPECT_GE(*integral, 0);
      EXPECT_LE(*exposed, 7);
      exposures += *integral > 0 && *exposed > *integral;
    }
  });
  EXPECT_GT(exposures, 5);
}

TEST(MetricLaws, TheTimeInTheRoadIsNoLongerThanTheTest) {
  std::set<double> times;
  for_each_drive([&](const TestView& view) {
    times.insert(value("time_in_road", view).value());
    EXPECT_GE(value("time_in_road", view).value(), 0);
    EXPECT_LE(value("time_in_road", view).value(), 6);
    EXPECT_GE(value("natural_steps", view).value(), 0);
    EXPECT_LE(value("natural_steps", view).value(), 1);
  });
  EXPECT_GT(times.size(), 3U);
}

TEST(MetricLaws, AnotherRoadUserMakesNothingLessCritical) {
  std::map<std::string, int> worse;
  for (std::uint64_t seed = 1; seed <= kDrives; ++seed) {
    SCOPED_TRACE(seed);
    auto ways = random_ways(seed);
    const Recording both = drive(1, ways);
    ways.pop_back();
    const Recording one = drive(1, ways);
    const Ground ground = road();
    const TestView more(both, ground);
    const TestView less(one, ground);
    for (const char* least : {"min_distance", "min_ttc", "min_ttb", "pet", "min_pret"}) {
      if (!value(least, less)) continue;
      EXPECT_LE(value(least, more).value(), value(least, less).value()) << least;
      worse[least] += value(least, more).value() < value(least, less).value();
    }
    for (const char* greatest : {"max_drac", "max_btn", "tet", "tit", "time_in_road"}) {
      if (!value(greatest, less)) continue;
      EXPECT_GE(value(greatest, more).value(), value(greatest, less).value()) << greatest;
      worse[greatest] += value(greatest, more).value() > value(greatest, less).value();
    }
  }
  EXPECT_EQ(worse.size(), 10U);
  for (const auto& [metric, times] : worse) EXPECT_GT(times, 0) << metric;
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// The physical limit: the case study's proximity behaviour written by hand as one C++ loop, without
// agents, beliefs and plans, beside the same tests run by the engine. Both begin with the same
// cells and draw the same numbers, so each test must end alike; then their times can be compared.
//
//   jaywalk_bench_crossing_limit [TESTS] [AGENTS]

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "env/crossing/spawn.h"
#include "env/crossing/world.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/support/random.h"

namespace jaywalk {
namespace {

constexpr int kRadius = 15;
constexpr int kSamples = 7;

struct Ending {
  bool success = false;
  int ticks = 0;
  friend bool operator==(const Ending&, const Ending&) = default;
};

/// The constant parts of the world.
struct HandWorld {
  explicit HandWorld(const CrossingParameters& parameters)
      : own(parameters),
        all(grid(parameters)),
        lane(av_lane(parameters)),
        zone(zone_rows(parameters)),
        ahead(zone_ahead(parameters)) {}

  const CrossingParameters& own;
  Grid all;
  Interval lane;
  Interval zone;
  Interval ahead;
};

struct Pedestrian {
  Position at;
  int along = 0;   // the way along the pavement, +1 or -1
  int across = 0;  // the way across the road; 0: not yet
};

void step(Pedestrian& one, const HandWorld& world, int av_cell, bool first_tick) {
  const int rows = std::max({world.lane.first - one.at.x, one.at.x - world.lane.last, 0});
  if (one.across == 0 && !first_tick && std::abs(one.at.y - av_cell) + rows < kRadius) {
    one.across = one.at.x < world.zone.first ? 1 : -1;
  }
  if (one.across != 0) {
    const int next = one.at.x + one.across;
    if (next >= 0 && next < world.all.rows) one.at.x = next;
    return;
  }
  const int next = one.at.y + one.along;
  if (next < 0 || next >= world.all.cells) one.along = -one.along;
  one.at.y += one.along;
}

Ending run_by_hand(const HandWorld& world, std::uint32_t agents, std::uint64_t test) {
  const std::uint64_t seed = mix(0, test);
  std::vector<Pedestrian> pedestrians;
  for (const Position cell : spawn(world.own, agents, mix(seed, 0))) pedestrians.push_back({cell});
  for (std::size_t i = 0; i < pedestrians.size(); ++i) {
    const std::uint64_t stream = mix_seed(mix(seed, 1) ^ mix_seed(i));
    JavaRandom random(static_cast<std::int64_t>(stream));
    pedestrians[i].along = random.next_int(2) == 0 ? 1 : -1;
  }
  for (int tick = 1;; ++tick) {
    const int origin = zone_origin(world.own, tick - 1);
    for (Pedestrian& one : pedestrians) step(one, world, origin, tick == 1);
    const Interval cells{
        std::max(origin + world.ahead.first, 0),
        std::min({origin + world.ahead.last, world.own.road_end, world.all.cells - 1})};
    const bool met = std::any_of(pedestrians.begin(), pedestrians.end(), [&](const auto& one) {
      return world.zone.contains(one.at.x) && cells.contains(one.at.y);
    });
    if (met) return {true, tick};
    if (zone_origin(world.own, tick) >= world.own.road_end) return {false, tick};
  }
}

Ending run_by_engine(TestRunner& runner, std::uint32_t agents, std::uint64_t test) {
  const TestRun result = runner.run({.agents = agents, .test = test});
  return {result.outcome.success, result.outcome.ticks};
}

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// All endings, and the median time of a test in microseconds.
template <class Run>
std::pair<std::vector<Ending>, double> measure(std::uint64_t tests, int repeat, Run run) {
  std::vector<Ending> endings(tests);
  std::vector<double> times;
  for (int sample = 0; sample < kSamples; ++sample) {
    const double start = cpu_s();
    for (int i = 0; i < repeat; ++i) {
      for (std::uint64_t test = 0; test < tests; ++test) endings[test] = run(test);
    }
    times.push_back((cpu_s() - start) * 1e6 / (static_cast<double>(tests) * repeat));
  }
  std::sort(times.begin(), times.end());
  return {endings, times[kSamples / 2]};
}

int compare(std::uint64_t tests, std::uint32_t agents) {
  Scenario scenario;
  scenario.behaviours.push_back(
      {.name = "proximity",
       .program = std::string(JAYWALK_SOURCE_DIR) + "/agents/crossing/proximity.asl"});
  Diagnostics warnings;
  const auto prepared = PreparedScenario::prepare(std::move(scenario), warnings);
  if (!prepared) return EXIT_FAILURE;
  const HandWorld world(crossing_parameters(*prepared.value()->scenario().world));
  constexpr int kRepeatByHand = 50;  // it takes microseconds
  const auto [by_hand, hand_us] = measure(
      tests, kRepeatByHand, [&](std::uint64_t test) { return run_by_hand(world, agents, test); });
  TestRunner runner(*prepared.value());
  const auto [by_engine, engine_us] =
      measure(tests, 1, [&](std::uint64_t test) { return run_by_engine(runner, agents, test); });
  if (by_hand != by_engine) {
    fmt::print(stderr, "the engine and the model written by hand disagree\n");
    return EXIT_FAILURE;
  }
  const auto successes = std::count_if(by_hand.begin(), by_hand.end(),
                                       [](const Ending& ending) { return ending.success; });
  fmt::print("{} tests of {} agents, accuracy {:.1f} % by both\n", tests, agents,
             100.0 * static_cast<double>(successes) / static_cast<double>(tests));
  fmt::print("by hand {:.2f} µs a test, engine {:.2f} µs a test, ratio {:.1f}\n", hand_us,
             engine_us, engine_us / hand_us);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace jaywalk

int main(int argc, char** argv) {
  const std::uint64_t tests = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000;
  const auto agents =
      static_cast<std::uint32_t>(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 10);
  return jaywalk::compare(tests, agents);
}

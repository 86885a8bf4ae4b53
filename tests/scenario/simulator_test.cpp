// SPDX-License-Identifier: Apache-2.0
// Simulators that move the AV: the same tests as without where it drives alike, one test lost for
// whatever a simulator does wrong.

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiment/test_run/simulator_version.h"
#include "tests/scenario/scenarios.h"

namespace jaywalk {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using testing_scenario::project_file;

std::string simulator_of(const std::vector<std::string>& command, const std::string& more = {}) {
  return "world.simulator={name: process, command: " + json(command).dump() + more + "}";
}

std::vector<std::string> constant(const std::string& fault = {}) {
  std::vector<std::string> command{"python3", project_file("tests/scenario/constant_simulator.py")};
  if (!fault.empty()) command.push_back(fault);
  return command;
}

struct Fault {
  std::string name;
  std::string message;
};

class FaultySimulator : public ::testing::TestWithParam<Fault> {};

TEST_P(FaultySimulator, CostsOneTestAndSaysWhy) {
  const auto prepared = testing_scenario::paper(
      {.sets = {simulator_of(constant(GetParam().name), ", step: 0.25, timeout: 1"),
                "world.until=road_end"}});
  TestRunner runner(*prepared);
  for (const std::uint64_t test : {0U, 1U, 2U}) {
    const TestRun result = runner.run({.agents = 2, .test = test});
    EXPECT_EQ(result.completed, test != 1) << result.message;
    if (test == 1) {
      EXPECT_THAT(result.message, HasSubstr("the simulator 'process': "));
      EXPECT_THAT(result.message, HasSubstr(GetParam().message));
    } else {
      EXPECT_EQ(result.outcome.end, "road_end");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    AllKinds, FaultySimulator,
    ::testing::Values(Fault{"hangs", "no answer within 1"}, Fault{"dies", "exit"},
                      Fault{"nonsense", "expected a JSON object"},
                      Fault{"back", "its time is 0.05 s, expected 0.75 s"},
                      Fault{"early", "its time is 0.7 s, expected 0.75 s"},
                      Fault{"other_test", "it answers for test 2, expected 1"},
                      Fault{"no_test", "there is no 'test' in its answer"},
                      Fault{"other_step", "it answers step 4, expected 3"},
                      Fault{"no_step", "there is no 'step'"},
                      Fault{"no_av", "there is no 'av' in its scene"},
                      Fault{"no_speed", "there is no 'speed' in its AV"},
                      Fault{"word", "'x' in its AV is not a number"},
                      Fault{"reverse", "the speed of 'av' is -3"},
                      Fault{"far", "the y of 'av' is 1e+300"},
                      Fault{"gone", "the AV has left the simulation at 0.75 s"},
                      Fault{"complains", "it reports 'no engine'"},
                      Fault{"traffic", "there are 1 states for the 0 vehicles of its traffic"},
                      Fault{"contact", "the contact 99 is the index of no actor"},
                      Fault{"two_lines", "one line is an answer"},
                      Fault{"start", "the front of the AV begins at y = "}),
    [](const auto& tested) { return tested.param.name; });

TEST(ASimulator, OfAnotherVersionOfTheProtocolIsRefused) {
  const auto prepared = testing_scenario::paper({.sets = {simulator_of(constant("protocol"))}});
  EXPECT_THAT(run_test(*prepared, {.agents = 1}).message,
              HasSubstr("it speaks version 2 of the protocol, this is version 1"));
}

TEST(ASimulator, ThatPromisesNoRepeatabilityIsNoted) {
  for (const std::string promise : {"", "random"}) {
    const auto prepared = testing_scenario::paper({.sets = {simulator_of(constant(promise))}});
    const TestRun result = run_test(*prepared, {.agents = 1});
    ASSERT_EQ(result.message, "");
    EXPECT_EQ(result.notes.empty(), promise.empty());
    for (const std::string& note : result.notes) {
      EXPECT_THAT(note, HasSubstr("does not promise the same results"));
    }
  }
}

TEST(ASimulator, WhoseAvKeepsItsSpeedGivesTheTestsOfTheWorldByItself) {
  const auto alone = testing_scenario::paper();
  const auto simulated =
      testing_scenario::paper({.sets = {simulator_of(constant(), ", step: 0.5")}});
  TestRunner ours(*alone);
  TestRunner theirs(*simulated);
  int met = 0;
  for (std::size_t behaviour = 0; behaviour < alone->behaviours().size(); ++behaviour) {
    for (std::uint64_t test = 0; test < 10; ++test) {
      const TestSetup setup{.behaviour = behaviour, .agents = 3, .seed = 4, .test = test};
      Recording by_us;
      Recording by_them;
      CrossingResult our_end;
      CrossingResult their_end;
      const TestRun expected =
          ours.run(setup, {.observe = testing_scenario::observing(our_end), .record = &by_us});
      const TestRun found = theirs.run(
          setup, {.observe = testing_scenario::observing(their_end), .record = &by_them});
      ASSERT_EQ(found.message, "");
      EXPECT_EQ(found.outcome.success, expected.outcome.success);
      EXPECT_EQ(found.outcome.ticks, expected.outcome.ticks);
      EXPECT_EQ(their_end.hit_cell, our_end.hit_cell);
      EXPECT_EQ(found.outcome.score(), expected.outcome.score());
      ASSERT_EQ(by_them.scenes(), by_us.scenes());
      EXPECT_NEAR(by_them.scene(by_them.scenes() - 1)[0].y_m,
                  by_us.scene(by_us.scenes() - 1)[0].y_m, 1e-9);
      met += expected.outcome.success ? 1 : 0;
    }
  }
  EXPECT_GT(met, 5);
}

TEST(ASimulator, IsOneProcessForEachWorkerAndSeesWhereEverybodyGoes) {
  const std::filesystem::path log =
      std::filesystem::temp_directory_path() / ("jaywalk-simulator-" + std::to_string(::getpid()));
  std::filesystem::remove(log);
  // Everything that it is asked passes through `tee`.
  const auto prepared = testing_scenario::paper(
      {.sets = {simulator_of({"sh", "-c",
                              "tee -a " + log.string() + " | python3 " +
                                  project_file("tests/scenario/constant_simulator.py")},
                             ", step: 0.5, options: {town: Town01, gap: 3}")}});
  Recording recording;
  {
    TestRunner runner(*prepared);
    ASSERT_EQ(runner.run({.agents = 2, .seed = 6, .test = 8}, {.record = &recording}).message, "");
    ASSERT_EQ(runner.run({.agents = 2, .seed = 6, .test = 9}).message, "");
  }
  std::vector<json> lines;
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line));
  std::filesystem::remove(log);
  ASSERT_GT(lines.size(), 6U);
  EXPECT_EQ(std::ranges::count(lines, "hello", [](const json& each) { return each["type"]; }), 1);
  EXPECT_EQ(lines[1]["type"], "reset");
  EXPECT_EQ(lines[1]["test"], 8);
  EXPECT_EQ(lines[1]["seed"], 6);
  EXPECT_EQ(lines[1]["options"], (json{{"town", "Town01"}, {"gap", "3"}}));
  EXPECT_EQ(lines[1]["road"]["bands"].size(), 4U);
  EXPECT_EQ(lines[1]["actors"][1]["name"], "p2");
  EXPECT_EQ(lines.back()["type"], "bye");
  // Two steps of half a second in the first tick: half of the way, then all of it.
  const ActorState before = recording.scene(0)[1];
  const ActorState after = recording.scene(1)[1];
  EXPECT_NEAR(lines[2]["actors"][0]["x"].get<double>(), (before.x_m + after.x_m) / 2, 1e-9);
  EXPECT_NEAR(lines[3]["actors"][0]["x"].get<double>(), after.x_m, 1e-9);
  EXPECT_NEAR(lines[3]["actors"][0]["y"].get<double>(), after.y_m, 1e-9);
}

TEST(ASimulator, GivesTheSameForAnyNumberOfThreads) {
  const auto prepared = testing_scenario::scenario("simulators/simulator");
  const auto results = [&](unsigned threads) {
    std::vector<std::string> texts;
    TestRunners runners(*prepared);
    std::vector<TestRun> all(6);
    std::vector<Recording> recordings(all.size());
    std::vector<std::thread> workers;
    std::atomic<std::size_t> next = 0;
    for (unsigned i = 0; i < threads; ++i) {
      workers.emplace_back([&] {
        for (std::size_t test = next++; test < all.size(); test = next++) {
          all[test] = runners.run({.agents = 3, .test = test}, {.record = &recordings[test]});
        }
      });
    }
    for (std::thread& worker : workers) worker.join();
    for (const TestRun& each : all) EXPECT_EQ(each.message, "");
    return recordings;
  };
  const auto one = results(1);
  EXPECT_TRUE(results(2) == one);
  EXPECT_TRUE(results(8) == one);
}

TEST(TheSimulatorToCopy, BrakesForPedestriansAndHasTrafficOfItsOwn) {
  const auto prepared = testing_scenario::scenario("simulators/simulator");
  double slowest = 100;
  double fastest_before_anybody = 0;
  for (std::uint64_t test = 0; test < 10; ++test) {
    Recording recording;
    ASSERT_EQ(run_test(*prepared,
                       {.behaviour = testing_scenario::behaviour(*prepared, "proximity"),
                        .agents = 3,
                        .test = test},
                       {.record = &recording})
                  .message,
              "");
    ASSERT_EQ(recording.actors().size(), 5U);
    EXPECT_EQ(recording.actors()[4].name, "car1");
    EXPECT_LT(recording.scene(1)[4].y_m, recording.scene(0)[4].y_m);
    for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
      slowest = std::min(slowest, recording.scene(tick)[0].speed_mps);
      fastest_before_anybody = std::max(fastest_before_anybody, recording.scene(tick)[0].speed_mps);
    }
  }
  EXPECT_LT(slowest, 2);
  EXPECT_NEAR(fastest_before_anybody, 9, 0.1);
}

TEST(Esmini, BrakesForPedestriansAndGivesTheSameAgain) {
  if (std::getenv("ESMINI_LIB") == nullptr) GTEST_SKIP() << "ESMINI_LIB names no esmini library";
  const auto slowest_mps = [](const std::string& options) {
    const auto prepared = testing_scenario::scenario("simulators/esmini", {options});
    EXPECT_THAT(simulator_version(prepared->scenario()).value(), ::testing::StartsWith("esmini 3"));
    TestRunner runner(*prepared);
    std::vector<double> slowest;
    for (const std::uint64_t test : {0U, 1U, 2U, 3U, 0U}) {
      Recording recording;
      const auto behaviour = testing_scenario::behaviour(*prepared, "proximity");
      const TestRun result =
          runner.run({.behaviour = behaviour, .agents = 3, .test = test}, {.record = &recording});
      EXPECT_EQ(result.message, "");
      slowest.push_back(100);
      for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
        slowest.back() = std::min(slowest.back(), recording.scene(tick)[0].speed_mps);
      }
    }
    EXPECT_EQ(slowest.front(), slowest.back());  // the same test again, after others
    return std::ranges::min(slowest);
  };
  EXPECT_LT(slowest_mps("world.simulator.options.model=ReferenceDriver"), 4);
  EXPECT_LT(slowest_mps("world.simulator.options.controller=ACCController"), 4);
  EXPECT_NEAR(slowest_mps("world.simulator.options.controller=none"), 9, 1e-3);
}

TEST(Esmini, SaysWhatIsMissing) {
  const auto prepared = testing_scenario::scenario(
      "simulators/esmini",
      {simulator_of({"env", "-u", "ESMINI_LIB", "python3",
                     project_file("scenarios/simulators/esmini.py"), "/no/library.so"})});
  const auto version = simulator_version(prepared->scenario());
  ASSERT_FALSE(version.ok());
  EXPECT_THAT(version.diagnostics().render(), HasSubstr("cannot load esmini's library"));
}

TEST(AScenario, SaysWhatItsSimulatorNeeds) {
  const auto wrong = [](std::vector<std::string> sets) {
    const auto scenario =
        read_scenario(project_file("scenarios/paper.yaml"), {.sets = std::move(sets)});
    return scenario ? std::string("nothing is wrong") : scenario.diagnostics().render();
  };
  EXPECT_THAT(wrong({"world.simulator=proces"}), HasSubstr("unknown simulator 'proces'"));
  EXPECT_THAT(wrong({"world.simulator=proces"}), HasSubstr("did you mean 'process'?"));
  EXPECT_THAT(wrong({"world.simulator=process"}), HasSubstr("no 'command' to start the simulator"));
  EXPECT_THAT(wrong({"world.simulator={command: [true]}"}), HasSubstr("'name' is missing"));
  EXPECT_THAT(wrong({"world.simulator={name: process, comand: [true]}"}), HasSubstr("comand"));
  EXPECT_THAT(wrong({"world.simulator={name: process, command: [true], timeout: 0}"}),
              HasSubstr("0.01"));
  EXPECT_THAT(wrong({"world.simulator={name: process, command: [true]}", "world.av.model=braking"}),
              HasSubstr("drives the AV, so that 'model' has no meaning"));
  EXPECT_THAT(wrong({"world.simulator={name: process, command: [true]}", "world.simulator=none"}),
              HasSubstr("nothing is wrong"));
}

}  // namespace
}  // namespace jaywalk

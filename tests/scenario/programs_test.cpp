// SPDX-License-Identifier: Apache-2.0
// User-provided programs in a scenario: their errors are reported in the user's words.

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "scenarios.h"

namespace jaywalk {
namespace {

class ProgramsTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Prepares the program `walker.asl` with that text in a scenario with that ending.
  Result<std::shared_ptr<const PreparedScenario>> prepare(const std::string& program,
                                                          const std::string& settings = "") {
    std::ofstream(folder_ + "/walker.asl") << program;
    const auto source = std::make_shared<const Source>(
        folder_ + "/test.yaml", "behaviours:\n  - program: walker.asl\n" + settings);
    Result<Scenario> scenario = parse_scenario(source);
    if (!scenario.ok()) return scenario.diagnostics();
    Diagnostics warnings;
    return PreparedScenario::prepare(std::move(scenario).value(), warnings);
  }

  /// The diagnostics, with the folder's name left out.
  std::string errors(const Result<std::shared_ptr<const PreparedScenario>>& prepared) const {
    if (prepared.ok()) return "";
    std::string text = prepared.diagnostics().render();
    for (std::size_t at = text.find(folder_); at != std::string::npos; at = text.find(folder_)) {
      text.erase(at, folder_.size() + 1);
    }
    return text;
  }

  /// Runs one test and collects what agents print and log.
  TestRun run(const PreparedScenario& prepared, std::uint32_t agents) {
    TestOptions options;
    options.print = [&](std::string_view line) { printed_.emplace_back(line); };
    options.log = [&](std::string_view line) { logged_.emplace_back(line); };
    options.max_cycles_per_tick = 10'000;
    return run_test(prepared, {.agents = agents}, options);
  }

  std::string folder_ = testing::TempDir() + "jaywalk_" +
                        testing::UnitTest::GetInstance()->current_test_info()->name();
  std::vector<std::string> printed_;
  std::vector<std::string> logged_;
};

TEST_F(ProgramsTest, GetAMisspeltParameterSuggested) {
  EXPECT_EQ(errors(prepare("radius(15).\n!walk.\n+!walk.\n", "    parameters: {raduis: 3}\n")),
            "test.yaml:3:18: error: the program has no initial belief 'raduis' to set\n"
            "      parameters: {raduis: 3}\n"
            "                   ^~~~~~\n"
            "  hint: did you mean 'radius'?\n");
}

TEST_F(ProgramsTest, TakeAsManyValuesAsTheBeliefHas) {
  EXPECT_EQ(errors(prepare("radius(15).\n", "    parameters: {radius: [1, 2]}\n")),
            "test.yaml:3:18: error: 'radius' takes 1 values, 2 given\n"
            "      parameters: {radius: [1, 2]}\n"
            "                   ^~~~~~\n");
}

TEST_F(ProgramsTest, AreMissedWhereTheyAreNamed) {
  const auto source =
      std::make_shared<const Source>(folder_ + "/test.yaml", "behaviours: [nowhere.asl]\n");
  Diagnostics warnings;
  const auto prepared =
      PreparedScenario::prepare(std::move(parse_scenario(source)).value(), warnings);
  EXPECT_EQ(errors(prepared),
            "test.yaml:1:14: error: no AgentSpeak program is at 'nowhere.asl'\n"
            "  behaviours: [nowhere.asl]\n"
            "               ^~~~~~~~~~~\n");
}

TEST_F(ProgramsTest, ReportTheirOwnErrors) {
  const auto prepared = prepare("!walk.\n+!walk <- move(.\n");
  ASSERT_FALSE(prepared.ok());
  EXPECT_TRUE(errors(prepared).starts_with("walker.asl:2:")) << errors(prepared);
}

TEST_F(ProgramsTest, GetParametersOfTheirOwn) {
  const auto prepared = prepare("mood(calm). !speak. +!speak : mood(M) <- .print(M).\n",
                                "    parameters: {mood: brisk}\n"
                                "    agents: {2: {mood: bold}}\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  EXPECT_TRUE(run(*prepared.value(), 3).completed);
  EXPECT_EQ(printed_, (std::vector<std::string>{"[p1] brisk", "[p2] bold", "[p3] brisk"}));
}

TEST_F(ProgramsTest, LearnThatThePreconditionWasMet) {
  const auto prepared = prepare(
      "!meet. +!meet : at(X, _) & X < 2 <- move(right); !meet. +!meet.\n"
      "+precondition_met(Id) : tick(T) <- .print(Id, \" in tick \", T - 1).\n",
      "world:\n"
      "  aftermath: 1\n"
      "  bands: [{kind: pavement, rows: 2}, {kind: lane, rows: 4}]\n"
      "  zone: {ahead: [1, 66]}\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  const TestRun result = run(*prepared.value(), 1);
  EXPECT_TRUE(result.outcome.success);
  EXPECT_EQ(printed_,
            (std::vector<std::string>{"[p1] 1 in tick " + std::to_string(result.outcome.ticks)}));
}

TEST_F(ProgramsTest, MayDoNothing) {
  const auto prepared = prepare("idle.\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  const TestRun result = run(*prepared.value(), 2);
  EXPECT_TRUE(result.completed);
  EXPECT_EQ(result.outcome.ticks, 11);
}

TEST_F(ProgramsTest, AreStoppedWhenTheyLoop) {
  const auto prepared = prepare("!loop. +!loop <- !loop.\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  const TestRun result = run(*prepared.value(), 1);
  EXPECT_FALSE(result.completed);
  EXPECT_NE(result.message.find("p1"), std::string::npos) << result.message;
  EXPECT_EQ(outcome_of(result).ended_by, kErrored);
}

TEST_F(ProgramsTest, MayStopTheTest) {
  const auto prepared = prepare("!quit. +!quit <- stay; .stopMAS.\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  const TestRun result = run(*prepared.value(), 1);
  EXPECT_FALSE(result.completed);
  EXPECT_EQ(result.message, "agent p1 stopped the system");
  EXPECT_EQ(outcome_of(result).ended_by, kErrored);
}

TEST_F(ProgramsTest, EndTestsErroredThatTakeTooManyInferences) {
  const auto prepared = prepare(
      "n(0). n(N) :- N > 0 & n(N - 1).\n"
      "!count.\n+!count <- stay; ?n(300); !count.\n-!count <- stay; !count.\n",
      "experiment: {limits: {inferences: 1000}}\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  const TestRun result = run(*prepared.value(), 1);
  EXPECT_FALSE(result.completed);
  EXPECT_NE(result.message.find("1000 inferences"), std::string::npos) << result.message;
  EXPECT_NE(result.message.find("walker.asl:3:"), std::string::npos) << result.message;
}

TEST_F(ProgramsTest, EndTestsErroredThatTakeTooMuchMemory) {
  const auto prepared =
      prepare("!grow([1]).\n+!grow(L) <- .concat(L, L, M); !grow(M).\n-!grow(_).\n",
              "experiment: {limits: {memory_mb: 4}}\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  const TestRun result = run(*prepared.value(), 1);
  EXPECT_FALSE(result.completed);
  EXPECT_NE(result.message.find("walker.asl:2:"), std::string::npos) << result.message;
}

TEST_F(ProgramsTest, EndTestsErroredThatTakeTooManyCycles) {
  const auto prepared =
      prepare("!stay. +!stay <- stay; !stay.\n", "experiment: {limits: {cycles: 5}}\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  const TestRun result = run(*prepared.value(), 1);
  EXPECT_FALSE(result.completed);
  EXPECT_NE(result.message.find("5 cycles"), std::string::npos) << result.message;
}

/// The query would take longer by far.
TEST_F(ProgramsTest, EndTestsErroredThatTakeTooLong) {
  const auto prepared = prepare(
      "d(1). d(2). d(3). d(4). d(5). d(6). d(7). d(8). d(9).\n"
      "far :- d(A) & d(B) & d(C) & d(D) & d(E) & d(F) & d(G) & d(H) & A + B + C + D + E + F > 99.\n"
      "!go. +!go <- ?far.\n",
      "experiment: {limits: {inferences: 0, time_s: 0.2}}\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  const TestRun result = run(*prepared.value(), 1);
  EXPECT_FALSE(result.completed);
  EXPECT_EQ(result.message, "the test took longer than its limit of 0.2 s");
}

TEST_F(ProgramsTest, FailWhenTheyLeaveTheGrid) {
  const auto prepared = prepare(
      "!west. +!west <- move(left); !west.\n"
      "-!west[error_msg(Why)] <- .print(Why).\n",
      "world: {bands: [{kind: pavement, rows: 2}, {kind: lane, rows: 4}]}\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  EXPECT_TRUE(run(*prepared.value(), 1).completed);
  ASSERT_EQ(printed_.size(), 1U);
  EXPECT_NE(printed_[0].find("leaves the grid"), std::string::npos) << printed_[0];
}

TEST_F(ProgramsTest, FailWhenTheyActTheUnknown) {
  const auto prepared = prepare("!fly. +!fly <- fly(up). -!fly[error(Kind)] <- .print(Kind).\n");
  ASSERT_TRUE(prepared.ok()) << errors(prepared);
  EXPECT_TRUE(run(*prepared.value(), 1).completed);
  EXPECT_EQ(printed_, (std::vector<std::string>{"[p1] action_failed"}));
}

}  // namespace
}  // namespace jaywalk

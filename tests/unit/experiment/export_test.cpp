// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiment/export/comparison_files.h"
#include "experiment/scenario/files/write_file.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

Comparison one_row(const char* behaviour, std::uint64_t successes) {
  Summary summary{.behaviour = behaviour, .agents = 3, .tests = 4, .successes = successes};
  if (successes > 0) {
    summary.score = {.count = successes, .mean = 30.25, .squares = 2};
    summary.ticks_success = {.count = successes, .mean = 2, .squares = 0};
  }
  summary.ticks_all = {.count = 4, .mean = 11, .squares = 0};
  summary.cpu_us = {.count = 4, .mean = 12.5};
  summary.wall_us = {.count = 4, .mean = 20};
  summary.code_lines = 17;
  return {.scenario = "s.yaml", .seed = 7, .tests = 4, .summaries = {summary}};
}

TEST(Csv, HasTheHeaderOfTheContract) {
  EXPECT_EQ(to_csv({}),
            "behaviour,agents,tests,successes,errored,accuracy_pct,accuracy_low,accuracy_high,"
            "score_mean,score_low,score_high,combined,combined_normalised,ticks_success_mean,"
            "ticks_success_low,ticks_success_high,ticks_all_mean,ticks_all_low,ticks_all_high,"
            "cpu_us_per_test,wall_us_per_test,code_lines\n");
}

TEST(Csv, WritesSixDecimalsWithoutTrailingZeros) {
  // Two successes: t(1; 0.975) = 12.706205 and a standard error of 1 give the score's interval.
  EXPECT_THAT(to_csv(one_row("walk", 2)),
              testing::EndsWith("\nwalk,3,4,2,0,50,15.003899,84.996101,30.25,17.543795,42.956205,"
                                "1.5125,0.416667,2,2,2,11,11,11,12.5,20,17\n"));
}

TEST(Csv, LeavesEmptyWhatDoesNotExist) {
  EXPECT_THAT(to_csv(one_row("walk", 0)),
              testing::EndsWith("\nwalk,3,4,0,0,0,0,48.989084,,,,,,,,,11,11,11,12.5,20,17\n"));
}

TEST(Csv, MeasuresTheTestsThatDidNotEndErrored) {
  Comparison comparison = one_row("walk", 2);
  comparison.summaries[0].tests = 7;
  comparison.summaries[0].errored = 3;
  EXPECT_THAT(to_csv(comparison), testing::HasSubstr("\nwalk,3,7,2,3,50,15.003899,84.996101,"));
}

TEST(Csv, HasNoShareOfSuccessesIfEveryTestEndedErrored) {
  Comparison comparison = one_row("walk", 0);
  comparison.summaries[0].errored = 4;
  EXPECT_THAT(to_csv(comparison), testing::HasSubstr("\nwalk,3,4,0,4,,,,"));
}

TEST(Csv, QuotesNamesWithSeparators) {
  EXPECT_THAT(to_csv(one_row("a,\"b\"", 0)), testing::HasSubstr("\n\"a,\"\"b\"\"\",3,"));
}

TEST(Json, HasTheFieldsOfTheCsvAndThePublishedOnes) {
  Comparison comparison = one_row("proximity", 2);
  comparison.published.behaviours = {"proximity"};
  const auto document = nlohmann::json::parse(to_json(comparison));
  EXPECT_EQ(document["scenario"], "s.yaml");
  EXPECT_EQ(document["seed"], 7);
  EXPECT_EQ(document["complete"], true);
  const auto& row = document["results"].at(0);
  EXPECT_EQ(row["agents"], 3);
  EXPECT_EQ(row["accuracy_pct"], 50.0);
  EXPECT_TRUE(row["code_lines"].is_number_unsigned());
  EXPECT_TRUE(row["errored"].is_number_unsigned());
  EXPECT_EQ(row["score_mean"], 30.25);
  EXPECT_TRUE(row["published"]["accuracy_pct"].is_number());
}

TEST(Json, LeavesOutPublishedFiguresOfAnotherWorldAndSaysSo) {
  Comparison comparison = one_row("proximity", 2);
  comparison.published.left_out = "another world";
  const auto document = nlohmann::json::parse(to_json(comparison));
  EXPECT_FALSE(document["results"].at(0).contains("published"));
  EXPECT_EQ(document["published_left_out"], "another world");
  EXPECT_FALSE(nlohmann::json::parse(to_json(one_row("walk", 1))).contains("published_left_out"));
}

TEST(Json, SaysNullWhatDoesNotExist) {
  const auto document = nlohmann::json::parse(to_json(one_row("walk", 0)));
  EXPECT_TRUE(document["results"].at(0)["score_mean"].is_null());
  EXPECT_FALSE(document["results"].at(0).contains("published"));
}

class WriteFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directory(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const char* name) const { return folder_ / name; }

  static std::string content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }

  fs::path folder_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(WriteFile, ReplacesTheFileAndLeavesNothingElse) {
  EXPECT_EQ(write_file(path("a.csv"), "old and longer"), std::nullopt);
  EXPECT_EQ(write_file(path("a.csv"), "new"), std::nullopt);
  EXPECT_EQ(content(path("a.csv")), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(WriteFile, FollowsALinkThatTheUserNamedAndReplacesOthers) {
  EXPECT_EQ(write_file(path("target"), "mine"), std::nullopt);
  fs::create_symlink("target", path("link"));
  EXPECT_EQ(write_file(path("link"), "theirs", Links::replaced), std::nullopt);
  EXPECT_EQ(content(path("target")), "mine");
  EXPECT_EQ(content(path("link")), "theirs");
  EXPECT_FALSE(fs::is_symlink(path("link")));
  fs::create_symlink("target", path("named"));
  EXPECT_EQ(write_file(path("named"), "new"), std::nullopt);
  EXPECT_EQ(content(path("target")), "new");
  fs::create_directory_symlink(".", path("folder"));
  EXPECT_EQ(write_file(path("folder"), "a file", Links::replaced), std::nullopt);
  EXPECT_EQ(content(path("folder")), "a file");
}

TEST(OutputPath, StaysInTheFolderWhateverTheNameIs) {
  using namespace std::string_literals;
  EXPECT_EQ(output_path("out", "proximity_25-10-test-7.xosc"), "out/proximity_25-10-test-7.xosc");
  EXPECT_EQ(output_path("out", "../x.json"), "out/_._x.json");
  EXPECT_EQ(output_path("out", "/etc/passwd"), "out/_etc_passwd");
  EXPECT_EQ(output_path("out", ".."), "out/_.");
  EXPECT_EQ(output_path("out", ".bashrc"), "out/_bashrc");
  EXPECT_EQ(output_path("out", ""), "out/_");
  EXPECT_EQ(output_path("out", "a\0b\x1b[2J=\xC3\xA4"s), "out/a_b__2J___");
}

TEST_F(WriteFile, SaysWhyItCannot) {
  EXPECT_EQ(write_file(path("missing/a.csv"), "x"), "No such file or directory");
  EXPECT_EQ(write_file(folder_.string(), "x"), "it is a folder");
  EXPECT_EQ(write_file("/dev/full", "x"), "No space left on device");
  EXPECT_EQ(write_file(path("a") + std::string(1, '\0'), "x"), "Invalid argument");
}

}  // namespace
}  // namespace jaywalk

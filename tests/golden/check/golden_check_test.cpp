// SPDX-License-Identifier: Apache-2.0
// The exact diagnostics of the faulty programs in this folder's: NAME.asl → NAME.expected. With
// UPDATE_GOLDEN=1 the expected files are rewritten, for review by their difference.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/check/check.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(JAYWALK_SOURCE_DIR) / "tests" / "golden" / "check";

const Vocabulary kVocabulary = {
    .environment_known = true,
    .percepts = {{.name = "at", .least_args = 2, .most_args = 2, .summary = {}},
                 {.name = "grid", .least_args = 2, .most_args = 2, .summary = {}},
                 {.name = "ground",
                  .least_args = 1,
                  .most_args = 1,
                  .summary = {},
                  .values = {{"lane", "pavement"}}}},
    .actions = {{.name = "move",
                 .least_args = 1,
                 .most_args = 1,
                 .summary = {},
                 .values = {{"left", "right"}}},
                {.name = "stay", .least_args = 0, .most_args = 0, .summary = {}}},
    .internal_actions =
        {{.name = ".print", .least_args = 0, .most_args = -1, .summary = {}},
         {.name = ".wait", .least_args = 1, .most_args = 3, .summary = {}},
         {.name = ".fail", .least_args = 0, .most_args = -1, .summary = {}},
         {.name = ".findall", .least_args = 3, .most_args = 3, .summary = {}},
         {.name = ".range", .least_args = 3, .most_args = 4, .summary = {}},
         {.name = ".random", .least_args = 1, .most_args = 3, .summary = {}},
         {.name = ".concat", .least_args = 1, .most_args = -1, .summary = {}},
         {.name = ".length", .least_args = 2, .most_args = 2, .summary = {}},
         {.name = ".length", .least_args = 1, .most_args = 1, .summary = {}, .is_function = true},
         {.name = ".send", .least_args = 3, .most_args = 5, .summary = {}},
         {.name = ".broadcast", .least_args = 2, .most_args = 2, .summary = {}}},
    .performatives = {"achieve", "askOne", "tell", "untell"}};

std::vector<std::string> programs() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kFolder)) {
    if (entry.path().extension() != ".asl") continue;
    names.push_back(entry.path().lexically_relative(kFolder).replace_extension().generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string content_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// The diagnostics with the file's bare name, wherever the project lies.
std::string diagnostics_of(const std::string& name) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>(fs::path(name).filename().string() + ".asl",
                                                     content_of(kFolder / (name + ".asl")));
  const SourceTree program = load_agent(source, {}, diagnostics);
  if (!diagnostics.has_errors()) check_program(program, kVocabulary, diagnostics);
  return diagnostics.render();
}

class GoldenCheck : public testing::TestWithParam<std::string> {};

TEST_P(GoldenCheck, TellsExactlyWhatIsExpected) {
  const fs::path expected = kFolder / (GetParam() + ".expected");
  const std::string found = diagnostics_of(GetParam());
  if (std::getenv("UPDATE_GOLDEN") != nullptr) {
    std::ofstream(expected, std::ios::binary) << found;
    return;
  }
  ASSERT_TRUE(fs::exists(expected)) << "run with UPDATE_GOLDEN=1 to write it";
  EXPECT_EQ(found, content_of(expected));
}

INSTANTIATE_TEST_SUITE_P(Programs, GoldenCheck, testing::ValuesIn(programs()),
                         [](const auto& test) { return fs::path(test.param).filename().string(); });

}  // namespace
}  // namespace jaywalk

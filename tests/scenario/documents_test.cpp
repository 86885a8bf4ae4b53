// SPDX-License-Identifier: Apache-2.0
// Documents about worlds and scenarios agree with them.

#include <filesystem>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "env/environments.h"
#include "scenarios.h"

namespace jaywalk {
namespace {

using testing_scenario::paper;
using testing_scenario::project_file;

std::string text_of(const std::string& path) {
  const Result<SourcePtr> source = read_source(project_file(path));
  EXPECT_TRUE(source.ok()) << path;
  return source.ok() ? std::string(source.value()->text()) : "";
}

TEST(Documents, ListEveryWordOfTheWorlds) {
  for (const EnvironmentKind& kind : environments()) {
    const std::string readme = text_of("env/" + std::string(kind.name) + "/README.md");
    for (const auto& words : {kind.percepts, kind.actions}) {
      for (const EnvironmentWord& word : words) {
        const std::string row = "| `" + std::string(word.form) + "` | " +
                                std::string(word.meaning) + " |" +
                                (word.needs.empty() ? "" : " " + std::string(word.needs) + " |");
        EXPECT_NE(readme.find(row), std::string::npos) << row;
      }
    }
  }
}

TEST(Documents, NameKeysThatScenariosHaveWherePerceptsNeedThem) {
  const std::string readme = text_of("docs/reference/scenarios.md");
  int keys = 0;
  for (const EnvironmentKind& kind : environments()) {
    for (const EnvironmentWord& word : kind.percepts) {
      std::istringstream words{std::string(word.needs)};
      for (std::string key; words >> key;) {
        if (!key.starts_with("world.")) continue;
        ++keys;
        EXPECT_NE(readme.find("| `" + key + "` |"), std::string::npos) << key;
      }
    }
  }
  EXPECT_GT(keys, 0);
}

TEST(Documents, ListEveryPreset) {
  const std::string readme = text_of("docs/reference/paper.md");
  for (const Preset& preset : presets()) {
    EXPECT_NE(readme.find("| `" + std::string(preset.name) + "` |"), std::string::npos)
        << preset.name;
  }
}

TEST(Documents, NameTheParametersOfTheBehaviours) {
  const std::string readme = text_of("agents/crossing/README.md");
  const auto prepared = paper();
  ASSERT_NE(prepared, nullptr);
  for (const PreparedBehaviour& behaviour : prepared->behaviours()) {
    EXPECT_NE(readme.find("| `" + behaviour.name + "` |"), std::string::npos) << behaviour.name;
  }
}

TEST(Documents, HoldThePapersExperiment) {
  const auto prepared = paper();
  ASSERT_NE(prepared, nullptr);
  EXPECT_EQ(prepared->behaviours().size(), 7U);
  EXPECT_EQ(prepared->scenario().experiment.tests, 1000U);
  EXPECT_EQ(prepared->scenario().experiment.agents.size(), 12U);
}

TEST(Documents, BeginWithAScenarioThatWorks) {
  Result<Scenario> scenario = read_scenario(project_file("scenarios/first.yaml"));
  ASSERT_TRUE(scenario.ok()) << scenario.diagnostics().render();
  Diagnostics warnings;
  const auto prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings);
  ASSERT_TRUE(prepared.ok()) << prepared.diagnostics().render();
  EXPECT_TRUE(warnings.empty()) << warnings.render();
}

/// What stands between two marks, from the last place of the first one; empty if nothing does.
std::string between(const std::string& text, const std::string& open, const std::string& close) {
  const std::size_t begin = text.rfind(open);
  if (begin == std::string::npos) return "";
  const std::size_t end = text.find(close, begin + open.size());
  if (end == std::string::npos) return "";
  return text.substr(begin + open.size(), end - begin - open.size());
}

// Rows `| F2 | what | [file.yaml](file.yaml) | `Suite.Name` |`.
TEST(Documents, NameScenariosAndTestsThatExistForEachRequirement) {
  const std::string readme = text_of("scenarios/README.md");
  std::string tests;
  for (const std::string folder : {"tests/scenario/", "tests/figures/"}) {
    for (const auto& file : std::filesystem::directory_iterator(project_file(folder))) {
      if (file.path().extension() != ".cpp") continue;
      tests += text_of(folder + file.path().filename().string());
    }
  }
  std::set<std::string> found;
  std::istringstream lines(readme);
  for (std::string row; std::getline(lines, row);) {
    if (!row.starts_with("| F")) continue;
    found.insert(row.substr(2, row.find(' ', 2) - 2));
    EXPECT_TRUE(read_scenario(project_file("scenarios/" + between(row, "](", ")"))).ok()) << row;
    std::string test = between(row, "| `", "` |");
    if (const std::size_t dot = test.find('.'); dot != std::string::npos)
      test.replace(dot, 1, ", ");
    EXPECT_NE(tests.find("TEST(" + test + ")"), std::string::npos) << row;
  }
  const std::set<std::string> wanted{"F1",  "F2",  "F3",  "F4",  "F5",  "F6",  "F9",  "F10",
                                     "F12", "F14", "F15", "F16", "F17", "F18", "F22", "F23"};
  EXPECT_EQ(found, wanted);
}

}  // namespace
}  // namespace jaywalk

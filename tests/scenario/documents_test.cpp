// What is written about worlds and scenarios agrees with what they are.

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
  const std::string readme = text_of("env/README.md");
  for (const EnvironmentKind& kind : environments()) {
    for (const auto& words : {kind.percepts, kind.actions}) {
      for (const EnvironmentWord& word : words) {
        const std::string row =
            "| `" + std::string(word.form) + "` | " + std::string(word.meaning) + " |";
        EXPECT_NE(readme.find(row), std::string::npos) << row;
      }
    }
  }
}

TEST(Documents, ListEveryPreset) {
  const std::string readme = text_of("scenarios/README.md");
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

}  // namespace
}  // namespace jaywalk

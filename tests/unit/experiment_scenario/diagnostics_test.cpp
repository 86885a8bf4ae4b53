// SPDX-License-Identifier: Apache-2.0
// The errors about mistakes in a scenario.

#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "parse.h"

namespace jaywalk {
namespace {

using ::testing::HasSubstr;
using testing_scenario::errors;
using testing_scenario::parse;
using testing_scenario::with;

constexpr const char* kWalk = "behaviours: [walk.asl]\n";

TEST(ScenarioDiagnostics, PointAtAnUnknownKeyAndSuggestTheRightOne) {
  EXPECT_EQ(errors(parse("behaviours: [a.asl]\nworld:\n  lenght: 70\n")),
            "folder/test.yaml:3:3: error: unknown key 'lenght' in 'world'\n"
            "    lenght: 70\n"
            "    ^~~~~~\n"
            "  hint: did you mean 'length'?\n");
}

TEST(ScenarioDiagnostics, GiveTheSpeedInMetresASecondForOneWithAUnit) {
  EXPECT_EQ(errors(parse("behaviours: [a.asl]\nworld: {av: {speed: 50 km/h}}\n")),
            "folder/test.yaml:2:21: error: expected a number from 0.01 to 10000, found '50 km/h'\n"
            "  world: {av: {speed: 50 km/h}}\n"
            "                      ^~~~~~~\n"
            "  hint: for that speed write 'speed_mps: 13.89', in m/s\n");
  EXPECT_THAT(errors(parse("behaviours: [a.asl]\nworld: {pedestrians: {speed_mps: 3 mph}}\n")),
              HasSubstr("write 'speed_mps: 1.341', in m/s"));
  EXPECT_THAT(errors(parse("behaviours: [a.asl]\n"
                           "world: {environment: motorway, av: {speed: 130km/h}}\n")),
              HasSubstr("write 'speed: 36.11', in m/s"));
  EXPECT_THAT(errors(parse("behaviours: [a.asl]\nworld: {tick: 0.5 s}\n")),
              HasSubstr("hint: write the number alone, without its unit"));
}

TEST(ScenarioDiagnostics, WarnOfAVehicleThatIsFasterThanCarsAre) {
  const auto fast = parse("behaviours: [a.asl]\nworld: {av: {speed: 50}}\n");
  ASSERT_TRUE(fast.ok());
  EXPECT_EQ(fast.value().warnings.render(),
            "folder/test.yaml:2:21: warning: the AV drives at 75 m/s (270 km/h)\n"
            "  world: {av: {speed: 50}}\n"
            "                      ^~\n"
            "  hint: 'speed' is in cells of 1.5 m and ticks of 1 s\n");
  EXPECT_TRUE(parse("behaviours: [a.asl]\nworld: {av: {speed: 40}}\n").value().warnings.empty());
  EXPECT_THAT(
      parse("behaviours: [a.asl]\nworld: {av: {speed_mps: 61}}\n").value().warnings.render(),
      HasSubstr("the AV drives at 61 m/s (219.6 km/h)"));
}

TEST(ScenarioDiagnostics, PointAtAColonThatABlankIsMissingBehind) {
  EXPECT_EQ(errors(parse("behaviours: [a.asl]\nworld:\n  length:60\n")),
            "folder/test.yaml:3:3: error: expected a blank behind the ':' of a key\n"
            "    length:60\n"
            "    ^~~~~~~~~\n"
            "  hint: write 'length: 60'\n");
  for (const char* text : {
           "world:\n  length:60\n  cell: 1\nbehaviours: [a.asl]\n",
           "world:\n  cell: 1\n  length:60\nbehaviours: [a.asl]\n",
           "length:60\nbehaviours: [a.asl]\n",
           "behaviours: [{program: a.asl, parameters: {first_way:forward}}]\n",
           "behaviours:\n  - program:a.asl\n    parameters: {}\n",
       }) {
    const std::string found = errors(parse(text));
    EXPECT_NE(found.find("expected a blank behind the ':' of a key"), std::string::npos)
        << text << found;
  }
}

TEST(ScenarioDiagnostics, PointAtAnExternalModelWithoutACommand) {
  EXPECT_EQ(errors(parse("world:\n  av: {model: external}\nbehaviours: [a.asl]\n")),
            "folder/test.yaml:2:15: error: no 'command' to start the controller with\n"
            "    av: {model: external}\n"
            "                ^~~~~~~~\n"
            "  hint: for example command: [python3, controller.py]\n");
  EXPECT_EQ(errors(parse("world:\n  av: {model: idm, twin: external}\nbehaviours: [a.asl]\n")),
            "folder/test.yaml:2:26: error: no 'command' to start the controller with\n"
            "    av: {model: idm, twin: external}\n"
            "                           ^~~~~~~~\n"
            "  hint: for example command: [python3, controller.py]\n");
}

TEST(ScenarioDiagnostics, PointAtTabs) {
  EXPECT_EQ(errors(parse("world:\n\tlength: 60\nbehaviours: [a.asl]\n")),
            "folder/test.yaml:2:1: error: a tab in the indentation\n"
            "  \tlength: 60\n"
            "  ^\n"
            "  hint: YAML wants blanks there\n");
}

TEST(ScenarioDiagnostics, ListTheKeysWhenNoneIsClose) {
  EXPECT_EQ(
      errors(parse("behaviours: [a.asl]\nexperiment: {repetitions: 5}\n")),
      "folder/test.yaml:2:14: error: unknown key 'repetitions' in 'experiment'\n"
      "  experiment: {repetitions: 5}\n"
      "               ^~~~~~~~~~~\n"
      "  hint: the keys here are tests, agents, seed, feedback, reachable, defects, avs, limits\n");
}

TEST(ScenarioDiagnostics, NameTheOptionThatIsWrong) {
  EXPECT_EQ(errors(with({"world.av.sped=8"})),
            "--set world.av.sped=8: error: unknown key 'sped' in 'world.av'\n"
            "  hint: did you mean 'speed'?\n");
  EXPECT_EQ(errors(with({"world.length"})),
            "--set world.length: error: expected KEY=VALUE, the key a dotted path\n"
            "  hint: for example --set world.av.speed=8\n");
  EXPECT_EQ(errors(with({"world..length=3"})),
            "--set world..length=3: error: expected KEY=VALUE, the key a dotted path\n"
            "  hint: for example --set world.av.speed=8\n");
}

TEST(ScenarioDiagnostics, ReportAllMistakesOfARun) {
  const Result<Scenario> result = parse(R"(
preset: drfat
world:
  length: long
  av: {rows: [4, 3]}
behaviours: 7
experiment: {tests: 0}
)",
                                        {.preset = {}, .sets = {"world.cell=0"}, .behaviours = {}});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.diagnostics().error_count(), 6U) << errors(result);
}

// One mistake each, and the line that reports it.
struct Mistake {
  std::string text;
  std::string message;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.message; }

class ScenarioMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(ScenarioMistakes, AreReportedOnceWithTheirPlace) {
  const Result<Scenario> result = parse(GetParam().text);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.diagnostics().error_count(), 1U);
  const std::string rendered = errors(result);
  // yaml-cpp 0.8 names the anchor, too, that is not defined.
  EXPECT_THAT(rendered.substr(0, rendered.find('\n')),
              testing::AnyOf(GetParam().message, GetParam().message + ": nowhere"));
}

std::string world(const std::string& content) {
  return std::string(kWalk) + "world: {" + content + "}\n";
}

INSTANTIATE_TEST_SUITE_P(
    Values, ScenarioMistakes,
    testing::Values(
        Mistake{world("length: 0"),
                "folder/test.yaml:2:17: error: expected a whole number from 1 to 100000, "
                "found '0'"},
        Mistake{world("length: 6.5"),
                "folder/test.yaml:2:17: error: expected a whole number from 1 to 100000, "
                "found '6.5'"},
        Mistake{world("length: [1]"),
                "folder/test.yaml:2:17: error: expected a whole number from 1 to 100000, "
                "found a list"},
        Mistake{world("tick: .inf"),
                "folder/test.yaml:2:15: error: expected a number from 0.001 to 3600, "
                "found '.inf'"},
        Mistake{world("environment: crosing"),
                "folder/test.yaml:2:22: error: unknown environment 'crosing'"},
        Mistake{world("bands: []"),
                "folder/test.yaml:2:16: error: expected a list of 1 to 50 bands, found a list"},
        Mistake{world("bands: [{kind: road}]"),
                "folder/test.yaml:2:24: error: expected pavement or lane, found 'road'"},
        Mistake{world("av: {rows: [4, 3]}"),
                "folder/test.yaml:2:20: error: the first number, 4, is greater than the last, 3"},
        Mistake{world("av: {rows: 4}"),
                "folder/test.yaml:2:20: error: expected two whole numbers, [first, last], "
                "found '4'"},
        Mistake{world("av: {rows: [3, 12]}"),
                "folder/test.yaml:2:20: error: rows 3 to 12 are not within the grid's 0 to 11"},
        Mistake{world("av: {speed: 6, speed_mps: 9}"),
                "folder/test.yaml:2:13: error: give either 'speed' or 'speed_mps'"},
        Mistake{world("zone: {ttc: [0, 1], ahead: [1, 6]}"),
                "folder/test.yaml:2:15: error: give either 'ttc' or 'ahead'"},
        Mistake{world("zone: {rows: middle}"),
                "folder/test.yaml:2:22: error: expected lane, av or rows as [first, last], "
                "found 'middle'"},
        Mistake{world("zone: {ttc: [0, 0.05]}"),
                "folder/test.yaml:2:21: error: no cell lies in the zone: its first is 1, "
                "its last 0 ahead"},
        Mistake{world("zone: 5"),
                "folder/test.yaml:2:15: error: expected keys and values (rows, from, ttc, ahead), "
                "found '5'"},
        Mistake{world("spawn: {dead_zones: {x: 3}}"),
                "folder/test.yaml:2:30: error: expected the number of a row, found 'x'"},
        Mistake{world("spawn: {dead_zones: {5: 3}}"),
                "folder/test.yaml:2:29: error: row 5 is not a row of a pavement, where agents "
                "spawn"},
        Mistake{world("scoring: {costs: ad}"),
                "folder/test.yaml:2:26: error: expected replace or add, found 'ad'"}));

INSTANTIATE_TEST_SUITE_P(
    Behaviours, ScenarioMistakes,
    testing::Values(
        Mistake{"world: {length: 70}\n", "folder/test.yaml: error: no behaviour to run"},
        Mistake{"behaviours: []\n", "folder/test.yaml: error: no behaviour to run"},
        Mistake{"behaviours: [a.asl, b/a.asl]\n",
                "folder/test.yaml:1:21: error: a second behaviour with the name 'a'"},
        Mistake{"behaviours: [a b.asl]\n",
                "folder/test.yaml:1:14: error: 'a b' cannot be the name of a behaviour"},
        Mistake{"behaviours: [{name: -a, program: a.asl}]\n",
                "folder/test.yaml:1:14: error: '-a' cannot be the name of a behaviour"},
        Mistake{"behaviours: [{name: a}]\n",
                "folder/test.yaml:1:14: error: a behaviour without 'program', the path of its "
                ".asl file"},
        Mistake{"behaviours: [{program: a.asl, parameters: {radius: true}}]\n",
                "folder/test.yaml:1:52: error: expected a number or an atom, found 'true'"},
        Mistake{"behaviours: [{program: a.asl, parameters: {radius: 1/0}}]\n",
                "folder/test.yaml:1:52: error: expected a number (15, 0.5, 1/11) or an atom "
                "(back), found '1/0'"},
        Mistake{"behaviours: [{program: a.asl, parameters: {Radius: 1}}]\n",
                "folder/test.yaml:1:44: error: expected the name of a belief, found 'Radius'"},
        Mistake{"behaviours: [{program: a.asl, agents: {0: {radius: 1}}}]\n",
                "folder/test.yaml:1:40: error: expected a number from 1 to 10000 or a range, "
                "found '0'"},
        Mistake{"behaviours: [a.asl]\nexperiment: {agents: 1..100000}\n",
                "folder/test.yaml:2:22: error: expected a number from 1 to 10000 or a range, "
                "found '1..100000'"},
        Mistake{"behaviours: [a.asl]\nexperiment: {agents: 20000}\n",
                "folder/test.yaml:2:22: error: expected a number from 1 to 10000 or a range, "
                "found '20000'"}));

INSTANTIATE_TEST_SUITE_P(
    Yaml, ScenarioMistakes,
    testing::Values(
        Mistake{"", "folder/test.yaml: error: the scenario is empty"},
        Mistake{"# nothing\n", "folder/test.yaml: error: the scenario is empty"},
        Mistake{"- a\n",
                "folder/test.yaml:1:1: error: expected keys and values (preset, world, behaviours, "
                "assertions, experiment, learning, policy), found a list"},
        Mistake{"world: {length: 1\n", "folder/test.yaml:2:1: error: end of map flow not found"},
        Mistake{"behaviours: [a.asl]\nbehaviours: [b.asl]\n",
                "folder/test.yaml:2:1: error: the key 'behaviours' is given twice"},
        Mistake{"behaviours: [a.asl]\n---\nworld: {}\n",
                "folder/test.yaml:2:1: error: a second document, only one is expected"},
        Mistake{", a\n", "folder/test.yaml:1:1: error: expected keys and values"},
        Mistake{"behaviours: *nowhere\n",
                "folder/test.yaml:1:13: error: the referenced anchor is not defined"},
        Mistake{"preset: drfat\nbehaviours: [a.asl]\n",
                "folder/test.yaml:1:9: error: unknown preset 'drfat'"},
        Mistake{"? [a, b]\n: c\n", "folder/test.yaml:1:3: error: a key is a single word or number"},
        Mistake{"world: &w\n  av: *w\n",
                "folder/test.yaml:1:8: error: nested more than 32 levels deep"}));

TEST(ScenarioDiagnostics, RefuseAnAliasBomb) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 9; ++i) {
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int j = 0; j < 10; ++j) bomb += (j > 0 ? ", *a" : "*a") + std::to_string(i - 1);
    bomb += "]\n";
  }
  const Result<Scenario> result = parse(bomb);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(errors(result).find("more than 20000 values"), std::string::npos) << errors(result);
}

TEST(ScenarioDiagnostics, RefuseDeepNesting) {
  const Result<Scenario> flow = parse("world: " + std::string(100'000, '['));
  ASSERT_FALSE(flow.ok());
  const Result<Scenario> map = parse("world: " + std::string(400, '{'));
  ASSERT_FALSE(map.ok());
}

TEST(ScenarioDiagnostics, SuggestABehaviour) {
  ScenarioOptions options;
  options.behaviours = {"wlak"};
  EXPECT_EQ(errors(parse(kWalk, options)),
            "behaviour wlak: error: neither a behaviour of the scenario, an installed one nor an "
            ".asl file\n"
            "  hint: did you mean 'walk'?\n");
  EXPECT_EQ(errors(with({"behaviours.wlak.parameters.radius=3"})),
            "--set behaviours.wlak.parameters.radius=3: error: no behaviour 'wlak' has been "
            "listed\n"
            "  hint: did you mean 'walk'?\n");
}

TEST(ScenarioDiagnostics, SayThatAPathIsNoScenario) {
  EXPECT_EQ(errors(read_scenario("nowhere.yaml")), "nowhere.yaml: error: no such file\n");
  EXPECT_EQ(errors(read_scenario("/")), "/: error: this is a folder, a file was expected\n");
}

}  // namespace
}  // namespace jaywalk

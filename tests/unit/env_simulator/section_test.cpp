// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/simulator/simulator.h"
#include "env/simulator/simulator_section.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

ConfigNode scalar(std::string text) {
  return {.kind = ConfigNode::Kind::scalar, .text = std::move(text), .origin = {{}, "here"}};
}
ConfigNode list(std::vector<ConfigNode> items) {
  ConfigNode node{.kind = ConfigNode::Kind::list, .origin = {{}, "here"}};
  node.items = std::move(items);
  return node;
}
ConfigNode map(std::vector<std::pair<std::string, ConfigNode>> entries) {
  ConfigNode node{.kind = ConfigNode::Kind::map, .origin = {{}, "here"}};
  for (auto& [key, value] : entries) node.entries.push_back({key, {{}, "key " + key}, value});
  return node;
}

/// The key `world.simulator`, layer after layer.
struct Section {
  Section& read(const ConfigNode& node) {
    const SectionContext context{folder, files, origins, diagnostics};
    read_simulator(node, "world.simulator", context, parameters);
    return *this;
  }
  [[nodiscard]] std::string said() const { return diagnostics.render(); }

  std::string folder;
  SourceFiles files;
  ValueOrigins origins;
  Diagnostics diagnostics;
  SimulatorParameters parameters;
};

TEST(SimulatorSection, IsANameOrAMapWithOne) {
  EXPECT_EQ(Section().read(scalar("sumo")).parameters.name, "sumo");
  EXPECT_EQ(Section().read(map({{"name", scalar("process")}})).parameters.name, "process");
}

TEST(SimulatorSection, IsNoneByItsName) {
  Section section;
  section.read(scalar("sumo")).read(scalar("none"));
  EXPECT_EQ(section.parameters.name, "");
  EXPECT_EQ(section.said(), "");
}

TEST(SimulatorSection, SuggestsTheNameThatWasMeant) {
  EXPECT_THAT(Section().read(scalar("summo")).said(), HasSubstr("unknown simulator 'summo'"));
  EXPECT_THAT(Section().read(scalar("summo")).said(), HasSubstr("did you mean 'sumo'?"));
}

TEST(SimulatorSection, NeedsAName) {
  EXPECT_THAT(Section().read(map({{"step", scalar("0.1")}})).said(),
              HasSubstr("the key 'name' is missing"));
}

TEST(SimulatorSection, ReadsItsStep) {
  Section section;
  section.read(map({{"name", scalar("sumo")}, {"step", scalar("0.25")}}));
  EXPECT_EQ(section.parameters.step_s, 0.25);
  EXPECT_THAT(section.read(map({{"step", scalar("0")}})).said(),
              HasSubstr("expected a number from 0.001 to 3600"));
}

TEST(SimulatorSection, ReadsNumbersWithinTheirKeysRange) {
  Section section;
  section.read(map({{"name", scalar("sumo")}, {"sigma", scalar("0.5")}}));
  EXPECT_EQ(section.parameters.number("sigma", -1), 0.5);
  section.read(map({{"sigma", scalar("1.5")}}));
  EXPECT_THAT(section.said(), HasSubstr("expected a number from 0 to 1, found '1.5'"));
  EXPECT_EQ(section.parameters.number("sigma", -1), 0.5) << "what was there stays";
}

TEST(SimulatorSection, ReadsChoicesAndFlags) {
  Section section;
  section.read(map({{"name", scalar("sumo")},
                    {"model", scalar("IDM")},
                    {"brakes_for_pedestrians", scalar("false")}}));
  EXPECT_EQ(section.said(), "");
  EXPECT_EQ(section.parameters.text("model"), "IDM");
  EXPECT_EQ(section.parameters.number("brakes_for_pedestrians", 1), 0);
  EXPECT_THAT(Section().read(map({{"name", scalar("sumo")}, {"model", scalar("IDN")}})).said(),
              HasSubstr("found 'IDN'"));
  EXPECT_THAT(Section()
                  .read(map({{"name", scalar("sumo")}, {"brakes_for_pedestrians", scalar("no")}}))
                  .said(),
              HasSubstr("expected true or false, found 'no'"));
}

TEST(SimulatorSection, RefusesKeysOfAnotherSimulator) {
  EXPECT_THAT(Section().read(map({{"name", scalar("process")}, {"sigma", scalar("0")}})).said(),
              HasSubstr("unknown key 'sigma'"));
}

TEST(SimulatorSection, ForgetsTheKeysOfAnotherSimulator) {
  Section section;
  section.read(map({{"name", scalar("sumo")}, {"sigma", scalar("0.5")}, {"step", scalar("1")}}));
  section.read(scalar("process"));
  EXPECT_THAT(section.parameters.settings, IsEmpty());
  EXPECT_EQ(section.parameters.step_s, 0.1);
}

TEST(SimulatorSection, KeepsKeysWhenTheSameNameIsGivenAgain) {
  Section section;
  section.read(map({{"name", scalar("sumo")}, {"sigma", scalar("0.5")}})).read(scalar("sumo"));
  EXPECT_EQ(section.parameters.number("sigma", -1), 0.5);
}

TEST(SimulatorSection, AddsToAMapWhatALaterLayerSays) {
  Section section;
  section.read(map({{"name", scalar("process")},
                    {"options", map({{"tau", scalar("1")}, {"style", scalar("calm")}})}}));
  section.read(map({{"options", map({{"tau", scalar("2")}})}}));
  EXPECT_THAT(section.parameters.find("options")->maps.at(0),
              ElementsAre(Pair("style", "calm"), Pair("tau", "2")));
}

TEST(SimulatorSection, ReplacesAListByWhatALaterLayerSays) {
  Section section;
  section.read(
      map({{"name", scalar("sumo")},
           {"traffic", list({map({{"every", scalar("5")}}), map({{"every", scalar("7")}})})}}));
  EXPECT_EQ(section.parameters.find("traffic")->maps.size(), 2U);
  section.read(map({{"traffic", list({map({{"every", scalar("9")}})})}}));
  ASSERT_EQ(section.parameters.find("traffic")->maps.size(), 1U);
  EXPECT_EQ(section.parameters.find("traffic")->maps[0].at("every"), "9");
}

TEST(SimulatorSection, SaysWhatIsNoMapOrList) {
  EXPECT_THAT(Section().read(map({{"name", scalar("process")}, {"options", scalar("x")}})).said(),
              HasSubstr("expected names and values, {tau: 1}"));
  EXPECT_THAT(Section().read(map({{"name", scalar("sumo")}, {"traffic", scalar("x")}})).said(),
              HasSubstr("expected a list of names and values, [{every: 10}]"));
}

TEST(SimulatorSection, WantsFilesThatAreThere) {
  EXPECT_THAT(Section().read(map({{"name", scalar("sumo")}, {"net", scalar("no.net.xml")}})).said(),
              HasSubstr("no file is at 'no.net.xml'"));
}

TEST(SimulatorSection, ReportsWhatDoesNotFitWhereTheKeyIs) {
  Section section;
  section.read(map({{"name", scalar("sumo")}, {"begin", scalar("5")}}));
  const SectionContext context{section.folder, section.files, section.origins, section.diagnostics};
  check_simulator(section.parameters, nullptr, "s.yaml", context);
  EXPECT_THAT(section.said(), HasSubstr("here: error: 'begin' is of a map, 'net'"));
}

}  // namespace
}  // namespace jaywalk

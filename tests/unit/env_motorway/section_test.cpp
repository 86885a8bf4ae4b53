// SPDX-License-Identifier: Apache-2.0
// The key `world` of a scenario on the motorway.

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/motorway/world.h"
#include "env/world/world_section.h"
#include "tests/helpers/config_nodes.h"

namespace jaywalk::motorway {
namespace {

using test::list;
using test::map;
using test::scalar;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pointee;

/// The section, layer after layer.
struct Section {
  Section& read(const ConfigNode& node) {
    section->read(node, "world", context(), {});
    return *this;
  }
  Section& check() {
    section->check("scenario", context());
    return *this;
  }
  [[nodiscard]] std::string said() const { return diagnostics.render(); }
  [[nodiscard]] MotorwayParameters parameters() const {
    return std::dynamic_pointer_cast<const MotorwaySpec>(section->finish())->parameters();
  }

  std::string folder;
  SourceFiles files;
  ValueOrigins origins;
  Diagnostics diagnostics;
  std::unique_ptr<WorldSection> section = motorway_section();

 private:
  SectionContext context() { return {folder, files, origins, diagnostics}; }
};

TEST(MotorwaySection, HasTheDefaultsOfTheWorldWhereNothingIsSaid) {
  Section section;
  EXPECT_EQ(section.read(map({})).check().said(), "");
  EXPECT_EQ(section.parameters(), MotorwayParameters{});
}

TEST(MotorwaySection, ReadsEveryKey) {
  Section section;
  section.read(map({{"lanes", scalar("4")},
                    {"lane_width", scalar("3.75")},
                    {"length", scalar("1500")},
                    {"tick", scalar("0.25")},
                    {"av", map({{"lane", scalar("3")},
                                {"start", scalar("150")},
                                {"speed", scalar("25")},
                                {"length", scalar("12")},
                                {"width", scalar("2.5")},
                                {"model", scalar("aeb")}})},
                    {"drivers", map({{"greatest_speed", scalar("50")},
                                     {"acceleration", scalar("4")},
                                     {"braking", scalar("9")},
                                     {"lane_change", scalar("3")},
                                     {"sight", scalar("90")},
                                     {"start", list({"-20", "70"})}})},
                    {"headway", scalar("1.2")},
                    {"aftermath", scalar("7")},
                    {"time_limit", scalar("45")},
                    {"scoring", map({{"cost", scalar("2")}, {"reward", scalar("50")}})}}));
  EXPECT_EQ(section.check().said(), "");
  MotorwayParameters expected;
  expected.lanes = 4;
  expected.lane_m = 3.75;
  expected.length_m = 1500;
  expected.tick_s = 0.25;
  expected.av.lane = 3;
  expected.av.start_m = 150;
  expected.av.speed_mps = 25;
  expected.av.length_m = 12;
  expected.av.width_m = 2.5;
  expected.av.vehicle.model = "aeb";
  expected.drivers = {50, 4, 9, 3, 90, -20, 70};
  expected.headway_s = 1.2;
  expected.aftermath = 7;
  expected.time_limit_s = 45;
  expected.cost = 2;
  expected.reward = 50;
  EXPECT_EQ(section.parameters(), expected);
}

TEST(MotorwaySection, LetsALaterLayerChangeWhatItNamesAlone) {
  Section section;
  section.read(map({{"lanes", scalar("5")}, {"av", map({{"speed", scalar("20")}})}}))
      .read(map({{"av", map({{"lane", scalar("1")}})}}));
  EXPECT_EQ(section.said(), "");
  EXPECT_EQ(section.parameters().lanes, 5);
  EXPECT_EQ(section.parameters().av.speed_mps, 20);
  EXPECT_EQ(section.parameters().av.lane, 1);
}

TEST(MotorwaySection, SuggestsTheKeyThatWasMeant) {
  EXPECT_THAT(Section().read(map({{"lane", scalar("4")}})).said(), HasSubstr("'lanes'"));
  EXPECT_THAT(Section().read(map({{"drivers", map({{"breaking", scalar("4")}})}})).said(),
              HasSubstr("'braking'"));
}

TEST(MotorwaySection, WantsAStartAsTwoNumbersInOrder) {
  const auto start = [](const std::vector<std::string>& texts) {
    return Section().read(map({{"drivers", map({{"start", list(texts)}})}})).said();
  };
  EXPECT_EQ(start({"-60", "40"}), "");
  EXPECT_THAT(start({"-60"}), Not(IsEmpty()));
  EXPECT_THAT(start({"-60", "40", "50"}), Not(IsEmpty()));
  EXPECT_THAT(start({"-60", "near"}), Not(IsEmpty()));
  EXPECT_THAT(start({"40", "-60"}), Not(IsEmpty()));
  EXPECT_THAT(start({"-60", "10001"}), Not(IsEmpty()));
}

TEST(MotorwaySection, ReportsWhatDoesNotFitTogetherOnceAllIsRead) {
  Section section;
  section.read(map({{"lanes", scalar("2")}, {"av", map({{"lane", scalar("3")}})}}));
  EXPECT_EQ(section.said(), "") << "another layer may mend it";
  EXPECT_THAT(section.check().said(), HasSubstr("the AV's lane 3 is none of the 2"));
  EXPECT_THAT(section.said(), HasSubstr("the key is world.av.lane"));
  Section mended;
  mended.read(map({{"lanes", scalar("2")}, {"av", map({{"lane", scalar("3")}})}}))
      .read(map({{"lanes", scalar("3")}}));
  EXPECT_EQ(mended.check().said(), "");
}

TEST(MotorwaySection, PointsAtTheLayerThatIsWrong) {
  Section section;
  section.read(map({{"av", map({{"lane", scalar("9")}})}})).check();
  EXPECT_THAT(section.said(), HasSubstr("here"));
  EXPECT_THAT(section.said(), Not(HasSubstr("scenario")));
}

TEST(MotorwaySection, WantsAnExternalVehicleToHaveACommand) {
  Section section;
  section.read(map({{"av", map({{"model", scalar("external")}})}}));
  EXPECT_THAT(section.check().said(), HasSubstr("command"));
}

TEST(MotorwaySection, GivesOutTheCommandsOfTheVehicleAndItsTwin) {
  Section section;
  section.read(
      map({{"av", map({{"model", scalar("external")}, {"command", list({"python3", "a.py"})}})}}));
  EXPECT_THAT(section.section->commands(), ElementsAre(Pointee(ElementsAre("python3", "a.py"))));
  section.read(map({{"av", map({{"twin", map({{"model", scalar("aeb")}})}})}}));
  EXPECT_THAT(section.section->commands(), testing::SizeIs(2));
  section.section->commands()[0]->at(1) = "copy.py";
  EXPECT_THAT(section.section->finish()->command(), ElementsAre("python3", "copy.py"));
}

TEST(MotorwaySection, OffersEveryModelOfVehicles) {
  const std::vector<std::string> models = Section().section->av_models();
  EXPECT_THAT(models, Contains("idm"));
  EXPECT_THAT(models, Contains("careful-competent"));
  EXPECT_THAT(Section().section->agents(), IsEmpty()) << "nobody but those under comparison";
}

}  // namespace
}  // namespace jaywalk::motorway

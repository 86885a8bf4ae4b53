#include "experiment/export/openscenario/validate.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/export/exporter.h"
#include "tests/helpers/folder.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;

/// A schema that any root element of the name satisfies.
std::string schema_of(const std::string& standard, const std::string& comment = {}) {
  return comment + "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\"><xs:element name=\"" +
         standard + "\"/></xs:schema>";
}

class ValidateTest : public FolderTest {
 protected:
  std::string write_drive(int minor) const {
    return file("road.xodr", "<OpenDRIVE><header revMajor=\"1\" revMinor=\"" +
                                 std::to_string(minor) + "\"/></OpenDRIVE>");
  }
  [[nodiscard]] Diagnostics checked(const std::vector<std::string>& files) const {
    Diagnostics found;
    validate(files, path(), found);
    return found;
  }
};

TEST_F(ValidateTest, LeavesOtherFilesAlone) {
  EXPECT_TRUE(checked({file("tests.csv", "a,b"), file("run.json", "{}")}).empty());
}

TEST_F(ValidateTest, RefusesAFileThatDoesNotSayItsVersion) {
  const Diagnostics found = checked({file("road.xodr", "<OpenDRIVE/>")});
  ASSERT_EQ(found.error_count(), 1U);
  EXPECT_THAT(found.render(),
              HasSubstr("road.xodr: error: does not say its version in its header"));
}

TEST_F(ValidateTest, RefusesAFileThatIsNotThere) {
  EXPECT_EQ(checked({path("none.xosc")}).error_count(), 1U);
}

TEST_F(ValidateTest, SaysOnceThatASchemaIsMissing) {
  const std::string file = write_drive(6);
  const Diagnostics found = checked({file, file, file});
  ASSERT_EQ(found.items().size(), 1U);
  EXPECT_THAT(found.render(), HasSubstr("has no schema of OpenDRIVE 1.6"));
  EXPECT_THAT(found.render(), HasSubstr("asam.net"));
}

TEST_F(ValidateTest, DoesNotTakeASchemaOfAnEarlierVersion) {
  (void)file("opendrive_14.xsd", schema_of("OpenDRIVE"));
  EXPECT_THAT(checked({write_drive(6)}).render(), HasSubstr("has no schema of OpenDRIVE 1.6\n"));
}

TEST_F(ValidateTest, DoesNotTakeASchemaOfTheOtherStandard) {
  (void)file("all_16.xsd", schema_of("OpenSCENARIO"));
  EXPECT_THAT(checked({write_drive(6)}).render(), HasSubstr("has no schema of OpenDRIVE 1.6"));
}

TEST_F(ValidateTest, SaysWhichLaterSchemaTakesThePlace) {
  (void)file("deep/opendrive_18.xsd", schema_of("OpenDRIVE"));
  (void)file("deep/opendrive_17.xsd", schema_of("OpenDRIVE"));
  EXPECT_THAT(checked({write_drive(6)}).render(),
              HasSubstr("has no schema of OpenDRIVE 1.6: OpenDRIVE 1.7 takes its place"));
}

TEST_F(ValidateTest, BelievesASchemasTextBeforeItsName) {
  (void)file("opendrive_14.xsd", schema_of("OpenDRIVE", "<!-- ASAM OpenDRIVE V1.7.0 -->"));
  EXPECT_THAT(checked({write_drive(6)}).render(), HasSubstr("OpenDRIVE 1.7 takes its place"));
}

TEST(RunProgram, SaysHowTheProgramEnded) {
  EXPECT_EQ(run_program({"true"}), 0);
  EXPECT_EQ(run_program({"sh", "-c", "exit 3"}), 3);
}

TEST(RunProgram, SaysThatThereIsNoneOfThatName) {
  EXPECT_EQ(run_program({"no-such-program-anywhere"}), 127);
}

TEST(RunProgram, CollectsWhatIsWritten) {
  std::string output = "before ";
  EXPECT_EQ(run_program({"printf", "%s-%s", "a b", "$HOME"}, &output), 0);
  EXPECT_EQ(output, "before a b-$HOME") << "no shell reads the words";
}

}  // namespace
}  // namespace jaywalk

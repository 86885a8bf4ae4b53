#include "experiment/export/openscenario/validate.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/export/program.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A schema that any root element of the name satisfies.
std::string schema_of(const std::string& standard, const std::string& comment = {}) {
  return comment + "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\"><xs:element name=\"" +
         standard + "\"/></xs:schema>";
}

class ValidateTest : public testing::Test {
 protected:
  ValidateTest() {
    std::string pattern = (fs::temp_directory_path() / "validate-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~ValidateTest() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string write_drive(int minor) const {
    return write("road.xodr", "<OpenDRIVE><header revMajor=\"1\" revMinor=\"" +
                                  std::to_string(minor) + "\"/></OpenDRIVE>");
  }
  [[nodiscard]] Diagnostics checked(const std::vector<std::string>& files) const {
    Diagnostics found;
    validate(files, folder_.string(), found);
    return found;
  }

  fs::path folder_;
};

TEST_F(ValidateTest, LeavesOtherFilesAlone) {
  EXPECT_TRUE(checked({write("tests.csv", "a,b"), write("run.json", "{}")}).empty());
}

TEST_F(ValidateTest, RefusesAFileThatDoesNotSayItsVersion) {
  const Diagnostics found = checked({write("road.xodr", "<OpenDRIVE/>")});
  ASSERT_EQ(found.error_count(), 1U);
  EXPECT_THAT(found.render(),
              HasSubstr("road.xodr: error: does not say its version in its header"));
}

TEST_F(ValidateTest, RefusesAFileThatIsNotThere) {
  EXPECT_EQ(checked({(folder_ / "none.xosc").string()}).error_count(), 1U);
}

TEST_F(ValidateTest, SaysOnceThatASchemaIsMissing) {
  const std::string file = write_drive(6);
  const Diagnostics found = checked({file, file, file});
  ASSERT_EQ(found.items().size(), 1U);
  EXPECT_THAT(found.render(), HasSubstr("has no schema of OpenDRIVE 1.6"));
  EXPECT_THAT(found.render(), HasSubstr("asam.net"));
}

TEST_F(ValidateTest, DoesNotTakeASchemaOfAnEarlierVersion) {
  (void)write("opendrive_14.xsd", schema_of("OpenDRIVE"));
  EXPECT_THAT(checked({write_drive(6)}).render(), HasSubstr("has no schema of OpenDRIVE 1.6\n"));
}

TEST_F(ValidateTest, DoesNotTakeASchemaOfTheOtherStandard) {
  (void)write("all_16.xsd", schema_of("OpenSCENARIO"));
  EXPECT_THAT(checked({write_drive(6)}).render(), HasSubstr("has no schema of OpenDRIVE 1.6"));
}

TEST_F(ValidateTest, SaysWhichLaterSchemaTakesThePlace) {
  (void)write("deep/opendrive_18.xsd", schema_of("OpenDRIVE"));
  (void)write("deep/opendrive_17.xsd", schema_of("OpenDRIVE"));
  EXPECT_THAT(checked({write_drive(6)}).render(),
              HasSubstr("has no schema of OpenDRIVE 1.6: OpenDRIVE 1.7 takes its place"));
}

TEST_F(ValidateTest, BelievesASchemasTextBeforeItsName) {
  (void)write("opendrive_14.xsd", schema_of("OpenDRIVE", "<!-- ASAM OpenDRIVE V1.7.0 -->"));
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

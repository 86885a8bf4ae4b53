// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/source_files.h"

#include <array>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

SourcePtr text(std::string name, std::string content) {
  return std::make_shared<const Source>(std::move(name), std::move(content));
}

TEST(SourceFiles, AreThoseOfTheDiskUnlessCopiesAreGiven) {
  const SourceFiles files;
  EXPECT_TRUE(files.has(JAYWALK_SOURCE_DIR "/README.md"));
  EXPECT_FALSE(files.has(JAYWALK_SOURCE_DIR "/tests"));
  EXPECT_TRUE(files.read(JAYWALK_SOURCE_DIR "/README.md").ok());
}

TEST(SourceFiles, ThatAreCopiesAreNeverReadFromTheDisk) {
  const std::array copies = {text("a.asl", "!a."), text("b.asl", "!b.")};
  const SourceFiles files(copies);
  EXPECT_TRUE(files.has("b.asl"));
  EXPECT_EQ(files.read("b.asl").value()->text(), "!b.");
  EXPECT_FALSE(files.has(JAYWALK_SOURCE_DIR "/README.md"));
  Result<SourcePtr> missing = files.read(JAYWALK_SOURCE_DIR "/README.md");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.diagnostics().items().front().message, "no copy of this file was kept");
}

TEST(SourceFiles, OfTheLibraryHaveNamesThatDoNotDependOnWhereItIs) {
  const SourceFiles files(std::string(JAYWALK_SOURCE_DIR "/agents"));
  EXPECT_TRUE(files.has("$jaywalk/crossing/proximity.asl"));
  EXPECT_EQ(files.read("$jaywalk/crossing/proximity.asl").value()->name(),
            "$jaywalk/crossing/proximity.asl");
  EXPECT_FALSE(files.has("$jaywalk/crossing"));
  EXPECT_FALSE(files.has("$jaywalk/../README.md"));
  EXPECT_FALSE(SourceFiles().has("$jaywalk/crossing/proximity.asl"));
}

TEST(SourceFiles, OfInstalledAssertionsHaveSuchNamesToo) {
  const SourceFiles files(JAYWALK_SOURCE_DIR "/agents", JAYWALK_SOURCE_DIR "/scenarios/assertions");
  EXPECT_EQ(files.read("$jaywalk/assertions/crossing.yaml").value()->name(),
            "$jaywalk/assertions/crossing.yaml");
  EXPECT_FALSE(files.has("$jaywalk/assertions/../paper.yaml"));
  EXPECT_TRUE(files.has("$jaywalk/crossing/proximity.asl"));
  EXPECT_EQ(files.installed_folder(), JAYWALK_SOURCE_DIR "/");
}

TEST(SourceFiles, FindWhatIsInstalledByItsPathBelowAWorld) {
  const SourceFiles files(std::string(JAYWALK_SOURCE_DIR "/agents"));
  EXPECT_EQ(files.find_installed("shared/alone.asl"), "$jaywalk/crossing/shared/alone.asl");
  EXPECT_EQ(files.find_installed("shared/none.asl"), std::nullopt);
  EXPECT_EQ(files.find_installed("../../README.md"), std::nullopt);
  const std::array copies = {files.read("$jaywalk/crossing/shared/alone.asl").value()};
  EXPECT_EQ(SourceFiles(copies).find_installed("shared/alone.asl"),
            "$jaywalk/crossing/shared/alone.asl");
  EXPECT_EQ(SourceFiles(copies).find_installed("alone.asl"), std::nullopt);
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/files/portable_names.h"

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TEST(PortableNames, LeaveRelativePathsAsTheyAre) {
  const PortableNames names({"scenarios/paper.yaml", "../mine.asl", "$jaywalk/crossing/x.asl"}, {});
  EXPECT_EQ(names.in("scenarios/paper.yaml"), "scenarios/paper.yaml");
  EXPECT_EQ(names.in("../mine.asl"), "../mine.asl");
  EXPECT_EQ(names.in("$jaywalk/crossing/x.asl"), "$jaywalk/crossing/x.asl");
}

TEST(PortableNames, KeepTheWayFromOneFileToAnother) {
  const PortableNames names(
      {"/home/me/work/scenarios/s.yaml", "/home/me/work/agents/a.asl", "/home/me/work/lib/b.asl"},
      {});
  EXPECT_EQ(names.in("/home/me/work/scenarios/s.yaml"), "scenarios/s.yaml");
  EXPECT_EQ(names.in("/home/me/work/agents/a.asl"), "agents/a.asl");
}

TEST(PortableNames, SayNothingOfFoldersThatAreFarFromEachOther) {
  const PortableNames names({"/home/me/work/s.yaml", "/tmp/try/a.asl"}, {});
  EXPECT_EQ(names.in("/home/me/work/s.yaml"), "s.yaml");
  EXPECT_EQ(names.in("/tmp/try/a.asl"), "a.asl");
}

TEST(PortableNames, AreThoseThatWhatIsInstalledHasEverywhere) {
  const SourceFiles files("/usr/local/share/jaywalk/agents");
  const PortableNames names({"/usr/local/share/jaywalk/scenarios/paper.yaml"}, files);
  EXPECT_EQ(names.in("/usr/local/share/jaywalk/scenarios/paper.yaml"), "scenarios/paper.yaml");
}

TEST(PortableNames, AreFoundWithinTexts) {
  const PortableNames names({"/home/me/s.yaml", "/home/me/p.json"}, {});
  EXPECT_EQ(names.in(R"(policy=["/home/me/p.json"])"), R"(policy=["p.json"])");
}

TEST(PortableNames, DoNotMakeOneOfTwoFiles) {
  const PortableNames names({"a.asl", "/home/me/a.asl"}, {});
  EXPECT_EQ(names.in("/home/me/a.asl"), "/home/me/a.asl");
}

TEST(PortableNames, OfOnePathAreItsFilesName) {
  EXPECT_EQ(portable_path("/home/me/runs.gpkg"), "runs.gpkg");
  EXPECT_EQ(portable_path("stores/runs.gpkg"), "stores/runs.gpkg");
}

// A scenario's own text may name a file by its absolute path: its copy is found all the same.
TEST(PortableNames, AreFoundAmongCopiesByTheirAbsolutePaths) {
  const std::vector<SourcePtr> copies{std::make_shared<const Source>("agents/a.asl", "x.")};
  const SourceFiles files(copies);
  EXPECT_TRUE(files.has("/home/me/agents/a.asl"));
  EXPECT_FALSE(files.has("/home/me/agents/b.asl"));
  EXPECT_FALSE(files.has("me/agents/a.asl"));
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/input/missing_file.h"

#include <gtest/gtest.h>

#include "interpreter/support/diagnostics.h"
#include "tests/helpers/folder.h"

namespace jaywalk {
namespace {

class MissingFile : public FolderTest {
 protected:
  [[nodiscard]] std::string hint(const std::string& name) const {
    return hint_for_missing(path(name));
  }
  [[nodiscard]] std::string meant(const std::string& name) const {
    return "did you mean '" + path(name) + "'?";
  }
};

TEST_F(MissingFile, MayHaveMovedIntoAFolder) {
  (void)file("simulators/sumo.yaml", "");
  (void)file("searches/other.yaml", "");
  EXPECT_EQ(hint("sumo.yaml"), meant("simulators/sumo.yaml"));
}

TEST_F(MissingFile, IsTheFirstByNameOfThoseInSeveralFolders) {
  (void)file("b/sumo.yaml", "");
  (void)file("a/sumo.yaml", "");
  EXPECT_EQ(hint("sumo.yaml"), meant("a/sumo.yaml"));
}

TEST_F(MissingFile, MayBeMisspelt) {
  (void)file("proximity.asl", "");
  (void)file("proximty.yaml", "");
  EXPECT_EQ(hint("proxmity.asl"), meant("proximity.asl"));
}

TEST_F(MissingFile, ExistsInAFolderRatherThanIsMisspelt) {
  (void)file("proximityy.asl", "");
  (void)file("shared/proximity.asl", "");
  EXPECT_EQ(hint("proximity.asl"), meant("shared/proximity.asl"));
}

// Only the endings of these are alike.
TEST_F(MissingFile, IsNotWhatHasOnlyTheSameEnding) {
  (void)file("walker.scenario", "");
  EXPECT_EQ(hint("a.scenario"), "");
}

TEST_F(MissingFile, MayLieInAFolderWithALikeName) {
  (void)file("scenarios/paper.yaml", "");
  EXPECT_EQ(hint("scenario/paper.yaml"), meant("scenarios/paper.yaml"));
  EXPECT_EQ(hint("scenario/papr.yaml"), meant("scenarios/paper.yaml"));
  EXPECT_EQ(hint("scenario/walker.yaml"), "");
}

TEST_F(MissingFile, MayLackItsEnding) {
  (void)file("m2.asl", "");
  EXPECT_EQ(hint("m2"), meant("m2.asl"));
}

TEST_F(MissingFile, MayBeBelowAnotherFolder) {
  (void)file("scenarios/paper.yaml", "");
  EXPECT_EQ(hint_for_missing("scenarios/papr.yaml", path("")),
            "did you mean 'scenarios/paper.yaml'?");
  EXPECT_EQ(hint_for_missing("scenario/paper.yaml", path("")),
            "did you mean 'scenarios/paper.yaml'?");
}

TEST_F(MissingFile, IsNoFolder) {
  (void)file("walker.asl/x", "");
  (void)file("below/walkers.asl/x", "");
  EXPECT_EQ(hint("walkers.asl"), "");
}

TEST_F(MissingFile, HasNoHintWhereThereIsNoFolder) {
  EXPECT_EQ(hint("nowhere/walker.asl"), "");
  EXPECT_EQ(hint_for_missing(""), "");
  EXPECT_EQ(hint_for_missing("/"), "");
}

TEST_F(MissingFile, IsHintedAtWhereItWasToBeRead) {
  (void)file("walker.asl", "");
  const Result<SourcePtr> source = read_source(path("walkr.asl"));
  ASSERT_FALSE(source);
  EXPECT_EQ(source.diagnostics().items().front().hint, meant("walker.asl"));
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Programs that are loaded while a system runs.

#include "interpreter/embed/program_loader.h"

#include <chrono>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/folder.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder with programs and another one beside it.
class Loader : public FolderTest {
 protected:
  std::shared_ptr<const Program> load(ProgramLoader& loader, const ProgramRequest& request) {
    error_ = {};
    return loader.load(request, symbols_, error_);
  }
  ProgramLoader loader(IncludePath includes = {}) const {
    return {path("own"), std::move(includes)};
  }

  SymbolTable symbols_;
  LoadProblem error_;
};

TEST_F(Loader, FindsProgramsInItsFolder) {
  file("own/a.asl", "b(1).\n+!g.\n");
  ProgramLoader programs = loader();
  const auto program = load(programs, {.file = "a.asl"});
  ASSERT_NE(program, nullptr) << error_.text;
  EXPECT_EQ(program->beliefs().size(), 1U);
  EXPECT_EQ(error_.text, "");
}

TEST_F(Loader, LooksInItsOwnFolderBeforeThoseOfTheIncludePath) {
  file("own/a.asl", "b(1).\n");
  file("other/a.asl", "b(1). b(2).\n");
  file("other/c.asl", "b(1). b(2). b(3).\n");
  IncludePath includes;
  includes.folders = {path("other")};
  ProgramLoader programs = loader(includes);
  EXPECT_EQ(load(programs, {.file = "a.asl"})->beliefs().size(), 1U);
  EXPECT_EQ(load(programs, {.file = "c.asl"})->beliefs().size(), 3U);
}

TEST_F(Loader, ReadsAFileOnceAsLongAsItDoesNotChange) {
  file("own/a.asl", "b(1).\n");
  ProgramLoader programs = loader();
  const auto first = load(programs, {.file = "a.asl"});
  EXPECT_EQ(load(programs, {.file = "a.asl"}), first);
  file("own/a.asl", "b(1). b(2).\n");
  fs::last_write_time(path("own/a.asl"),
                      fs::last_write_time(path("own/a.asl")) + std::chrono::seconds(5));
  const auto second = load(programs, {.file = "a.asl"});
  ASSERT_NE(second, nullptr);
  EXPECT_NE(second, first);
  EXPECT_EQ(second->beliefs().size(), 2U);
  EXPECT_EQ(first->beliefs().size(), 1U) << "of agents that run already";
}

TEST_F(Loader, CompilesAFileAnewForAnotherPurpose) {
  file("own/a.asl", "b(1).\n");
  ProgramLoader programs = loader();
  const auto plain = load(programs, {.file = "a.asl"});
  EXPECT_NE(load(programs, {.file = "a.asl", .included = true}), plain);
  EXPECT_NE(load(programs, {.file = "a.asl", .ns = "n"}), plain);
}

TEST_F(Loader, CompilesAnewWhatHasLocalNamespacesWhereverItIsIncluded) {
  file("own/a.asl", "{ namespace(n, local) }\nn::b(1).\n");
  file("own/b.asl", "b(1).\n");
  ProgramLoader programs = loader();
  const ProgramRequest local{.file = "a.asl", .included = true, .ns = "m"};
  const auto first = load(programs, local);
  const auto second = load(programs, local);
  ASSERT_NE(first, nullptr) << error_.text;
  ASSERT_NE(second, nullptr) << error_.text;
  EXPECT_NE(first->beliefs().front().predicate, second->beliefs().front().predicate);
  const ProgramRequest plain{.file = "b.asl", .included = true, .ns = "m"};
  EXPECT_EQ(load(programs, plain), load(programs, plain));
}

TEST_F(Loader, TakesNoFileForAnEmptyProgram) {
  ProgramLoader programs = loader();
  const auto program = load(programs, {.file = ""});
  ASSERT_NE(program, nullptr) << error_.text;
  EXPECT_TRUE(program->beliefs().empty());
}

TEST_F(Loader, SaysThatAFileIsNotThere) {
  ProgramLoader programs = loader();
  EXPECT_EQ(load(programs, {.file = "none.asl"}), nullptr);
  EXPECT_THAT(error_.text, HasSubstr("none.asl"));
  EXPECT_FALSE(error_.is_refused);
}

TEST_F(Loader, SaysWhereTheFirstMistakeIs) {
  file("own/a.asl", "b(1).\n+!g <- ?.\n+!h <- ?.\n");
  ProgramLoader programs = loader();
  EXPECT_EQ(load(programs, {.file = "a.asl"}), nullptr);
  EXPECT_THAT(error_.text, HasSubstr("a.asl:2:"));
}

TEST_F(Loader, ReadsNothingThatItsProgramsMayNotRead) {
  file("other/secret.asl", "b(1).\n");
  ProgramLoader programs = loader();
  EXPECT_EQ(load(programs, {.file = path("other") + "/secret.asl"}), nullptr);
  EXPECT_THAT(error_.text, HasSubstr("cannot read"));
  EXPECT_EQ(load(programs, {.file = "../other/secret.asl"}), nullptr);
  EXPECT_THAT(error_.text, HasSubstr("cannot read"));
  EXPECT_TRUE(error_.is_refused);
}

TEST_F(Loader, ReadsFoldersThatItIsAllowedTo) {
  file("other/open.asl", "b(1).\n");
  IncludePath includes;
  includes.files.allow_reading(path("other"));
  ProgramLoader programs = loader(includes);
  EXPECT_NE(load(programs, {.file = path("other") + "/open.asl"}), nullptr) << error_.text;
}

TEST_F(Loader, TakesTextsThatAreGivenInPlaceOfFiles) {
  file("own/a.asl", "b(1).\n");
  IncludePath includes;
  includes.given = {{"a.asl", "b(1). b(2).\n"}};
  ProgramLoader programs = loader(includes);
  EXPECT_EQ(load(programs, {.file = "a.asl"})->beliefs().size(), 2U);
}

TEST_F(Loader, LoadsAProgramWithoutAnIncludeThatHasAMistake) {
  file("own/a.asl", "{ include(\"b.asl\") }\nb(1).\n");
  file("own/b.asl", "+!g <- ?.\n");
  ProgramLoader programs = loader();
  const auto program = load(programs, {.file = "a.asl"});
  ASSERT_NE(program, nullptr);
  EXPECT_EQ(program->beliefs().size(), 1U);
  EXPECT_THAT(error_.text, HasSubstr("b.asl:1:")) << "which is said as well";
}

}  // namespace
}  // namespace jaywalk

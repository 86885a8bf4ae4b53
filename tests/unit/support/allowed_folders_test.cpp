// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/allowed_folders.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

// A folder `own` with a file and links, and one `other` beside it.
class AllowedFoldersTest : public testing::Test {
 protected:
  AllowedFoldersTest()
      : scratch_(fs::path(testing::TempDir()) / ("jaywalk_allowed_" + std::to_string(getpid()))) {
    fs::create_directories(scratch_ / "own" / "below");
    fs::create_directories(scratch_ / "own-not");
    fs::create_directories(scratch_ / "other");
    for (const char* file : {"own/a", "own/below/b", "own-not/c", "other/d"}) {
      std::ofstream(scratch_ / file) << "x";
    }
    fs::create_symlink("../other/d", scratch_ / "own/out");
    fs::create_symlink("below/b", scratch_ / "own/in");
    fs::create_symlink(scratch_ / "other", scratch_ / "own/folder");
    allowed_.add((scratch_ / "own").string());
  }
  ~AllowedFoldersTest() override { fs::remove_all(scratch_); }

  [[nodiscard]] bool allows(const std::string& path) const {
    return !allowed_.denial((scratch_ / path).string());
  }

  fs::path scratch_;
  AllowedFolders allowed_;
};

TEST_F(AllowedFoldersTest, AllowWhatLiesInThemAndBelow) {
  EXPECT_TRUE(allows("own"));
  EXPECT_TRUE(allows("own/a"));
  EXPECT_TRUE(allows("own/below/b"));
  EXPECT_TRUE(allows("own/new"));
  EXPECT_TRUE(allows("own/below/../a"));
  EXPECT_TRUE(allows("own/in"));
  EXPECT_FALSE(allows("own/../other/d"));
  EXPECT_FALSE(allows("own-not/c"));
  EXPECT_FALSE(allows("own/new/../../other/d"));
  EXPECT_FALSE(allows(""));
}

TEST_F(AllowedFoldersTest, FollowLinksFirst) {
  EXPECT_FALSE(allows("own/out"));
  EXPECT_FALSE(allows("own/folder/d"));
  EXPECT_FALSE(allows("own/folder/new"));
  fs::create_symlink(scratch_ / "own", scratch_ / "by_link");
  EXPECT_TRUE(allows("by_link/a"));
  AllowedFolders by_link;
  by_link.add((scratch_ / "by_link").string());
  EXPECT_FALSE(by_link.denial((scratch_ / "own/a").string()));
}

TEST_F(AllowedFoldersTest, AllowNothingByThemselves) {
  EXPECT_TRUE(AllowedFolders().denial((scratch_ / "own/a").string()));
  AllowedFolders missing;
  missing.add((scratch_ / "nowhere").string());
  EXPECT_TRUE(missing.denial((scratch_ / "own/a").string()));
}

TEST_F(AllowedFoldersTest, SayWhichOptionAllowsMore) {
  AllowedFolders writable("--allow-write");
  const std::string other = (scratch_ / "other").string();
  const auto denial = writable.denial(other + "/d");
  ASSERT_TRUE(denial);
  EXPECT_EQ(denial->text(), "it lies outside the folders that the program may use (--allow-write " +
                                other + " allows it)");
  EXPECT_EQ(writable.denial(other + "/new/d")->hint,
            "--allow-write " + other + "/new allows it, once there is such a folder");
}

TEST_F(AllowedFoldersTest, NameAFolderThatAllowsWhatALinkLeadsTo) {
  for (const auto& [path, named] :
       {std::pair("own/out", "other"), std::pair("own/folder/d", "own/folder"),
        std::pair("own/folder", "own/folder")}) {
    const std::string folder = (scratch_ / named).string();
    const auto denial = allowed_.denial((scratch_ / path).string());
    ASSERT_TRUE(denial) << path;
    EXPECT_EQ(denial->hint, "--allow-read " + folder + " allows it") << path;
    AllowedFolders more = allowed_;
    more.add(folder);
    EXPECT_FALSE(more.denial((scratch_ / path).string())) << path;
  }
}

TEST_F(AllowedFoldersTest, QuoteAFolderForTheShell) {
  fs::create_directory(scratch_ / "two words");
  const std::string folder = (scratch_ / "two words").string();
  EXPECT_EQ(allowed_.denial(folder + "/d")->hint, "--allow-read '" + folder + "' allows it");
}

TEST_F(AllowedFoldersTest, AllowNoDevicesPipesAndFilesOfTheSystem) {
  AllowedFolders all;
  all.add("/");
  EXPECT_FALSE(all.denial((scratch_ / "other/d").string()));
  ASSERT_EQ(::mkfifo((scratch_ / "own/pipe").c_str(), 0600), 0);
  for (const std::string& path : {(scratch_ / "own/pipe").string(), std::string("/dev/zero"),
                                  std::string("/proc/self/environ"), std::string("/proc/new")}) {
    const auto denial = all.denial(path);
    ASSERT_TRUE(denial) << path;
    EXPECT_EQ(denial->hint, "") << path;
  }
}

TEST_F(AllowedFoldersTest, RefuseNamesThatTheSystemWouldCutOff) {
  EXPECT_FALSE(allows(std::string("own/a\0b", 7)));
}

}  // namespace
}  // namespace jaywalk

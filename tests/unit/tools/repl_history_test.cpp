// SPDX-License-Identifier: Apache-2.0
// Where the REPL keeps what was typed.

#include <cstdlib>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tools/jaywalk/repl/line_editor.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

class ReplHistory : public testing::Test {
 protected:
  ReplHistory() { setenv("XDG_STATE_HOME", folder_.c_str(), 1); }
  ~ReplHistory() override {
    unsetenv("XDG_STATE_HOME");
    fs::remove_all(folder_);
  }

  fs::path folder_ =
      fs::path(testing::TempDir()) / ("jaywalk_history_" + std::to_string(::getpid()));
  fs::path file_ = folder_ / "jaywalk" / "repl_history";
};

TEST_F(ReplHistory, IsAFileInTheFolderOfStates) {
  EXPECT_EQ(repl_history_file(), file_);
  EXPECT_TRUE(fs::is_directory(file_.parent_path()));
  std::ofstream(file_) << "typed\n";
  EXPECT_EQ(repl_history_file(), file_);
}

TEST_F(ReplHistory, IsNotReadFromWhatNeverEnds) {
  fs::create_directories(file_.parent_path());
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  EXPECT_EQ(repl_history_file(), std::nullopt);
  fs::remove(file_);
  fs::create_symlink("/dev/zero", file_);
  EXPECT_EQ(repl_history_file(), std::nullopt);
  fs::remove(file_);
  fs::create_directory(file_);
  EXPECT_EQ(repl_history_file(), std::nullopt);
}

TEST_F(ReplHistory, IsKeptNowhereIfThereIsNoFolder) {
  std::ofstream(folder_) << "a file in its place";
  EXPECT_EQ(repl_history_file(), std::nullopt);
}

}  // namespace
}  // namespace jaywalk

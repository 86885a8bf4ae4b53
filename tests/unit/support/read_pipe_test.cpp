// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/input/read_pipe.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

/// A named pipe that is gone afterwards.
class ReadPipe : public testing::Test {
 protected:
  ReadPipe() { EXPECT_EQ(::mkfifo(path_.c_str(), 0600), 0); }
  ~ReadPipe() override { std::filesystem::remove(path_); }

  const std::string path_ = testing::TempDir() + "jaywalk-read-pipe-" + std::to_string(::getpid());
};

TEST_F(ReadPipe, GivesAllThatIsWritten) {
  const std::string written(100'000, 'x');
  std::jthread writer([&] { std::ofstream(path_) << written; });
  EXPECT_EQ(read_pipe(path_, 1'000'000).value(), written);
}

TEST_F(ReadPipe, EndsSoonAfterTheMostThatIsWanted) {
  std::signal(SIGPIPE, SIG_IGN);  // the writer is cut off
  std::jthread writer([&] { std::ofstream(path_) << std::string(40'000, 'x'); });
  EXPECT_GT(read_pipe(path_, 1000).value().size(), 1000U);
}

TEST_F(ReadPipe, WaitsForASlowWriter) {
  std::jthread writer([&] {
    std::ofstream file(path_);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    file << "late";
  });
  EXPECT_EQ(read_pipe(path_, 10).value(), "late");
}

TEST_F(ReadPipe, DoesNotWaitForNobody) {
  const auto text = read_pipe(path_, 10, std::chrono::milliseconds(50));
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.diagnostics().items().front().message, "a pipe that nobody writes to");
}

}  // namespace
}  // namespace jaywalk

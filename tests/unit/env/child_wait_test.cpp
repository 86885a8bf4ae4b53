// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <unistd.h>

#include <gtest/gtest.h>

#include "env/process/guarded_child.h"

namespace jaywalk {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// A pipe to wait for, and a program without a request to end, before and after.
class ChildWait : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(pipe(ends_.data()), 0); }
  void TearDown() override {
    end_requested = false;
    for (const int end : ends_) close(end);
  }

  [[nodiscard]] std::string wait(milliseconds limit) const {
    std::array<pollfd, 1> descriptors{pollfd{ends_[0], POLLIN, 0}};
    return wait_for_child(descriptors, steady_clock::now() + limit);
  }
  void write_something() const { ASSERT_EQ(write(ends_[1], "x", 1), 1); }

 private:
  std::array<int, 2> ends_{};
};

TEST_F(ChildWait, EndsWhenThereIsSomethingToRead) {
  write_something();
  EXPECT_EQ(wait(milliseconds(60'000)), "");
}

TEST_F(ChildWait, FindsWhatIsThereThoughNothingIsToBeWaitedFor) {
  write_something();
  EXPECT_EQ(wait(milliseconds(0)), "");
  EXPECT_EQ(wait(milliseconds(-1)), "");
}

TEST_F(ChildWait, EndsAtItsDeadline) { EXPECT_EQ(wait(milliseconds(2)), kLate); }

TEST_F(ChildWait, IsNotBegunByAProgramThatIsToEnd) {
  end_requested = true;
  EXPECT_EQ(wait(milliseconds(60'000)), kInterrupted);
}

}  // namespace
}  // namespace jaywalk

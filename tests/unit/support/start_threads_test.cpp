// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/start_threads.h"

#include <functional>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

/// The system has two of them.
struct ScarceThread {
  explicit ScarceThread(const std::function<void()>& work) {
    if (started == 2)
      throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
    ++started;
    work();
  }
  static inline int started = 0;
};

TEST(StartThreads, GoesOnWithThoseThatAreToBeHad) {
  ScarceThread::started = 0;
  int calls = 0;
  std::vector<ScarceThread> threads;
  EXPECT_EQ(start_threads(threads, 5, std::function<void()>([&calls] { ++calls; })), 2U);
  EXPECT_EQ(calls, 2);
  std::vector<ScarceThread> others;
  EXPECT_THROW(start_threads(others, 5, std::function<void()>([] {})), std::system_error);
}

}  // namespace
}  // namespace jaywalk

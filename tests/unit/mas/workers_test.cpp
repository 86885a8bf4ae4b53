// SPDX-License-Identifier: Apache-2.0
#include "interpreter/mas/workers.h"

#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TEST(Workers, DoEachBlockOnce) {
  Workers workers(3);
  std::vector<std::atomic<int>> done(100);
  workers.run(done.size(), [&](std::size_t, std::size_t block) { ++done[block]; });
  for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
}

TEST(Workers, AreNumberedBelowTheirCount) {
  Workers workers(4);
  std::vector<std::atomic<int>> blocks(workers.count());
  workers.run(100, [&](std::size_t worker, std::size_t) { ++blocks.at(worker); });
  EXPECT_EQ(std::accumulate(blocks.begin(), blocks.end(), 0), 100);
}

TEST(Workers, OfOneAreTheCallerAlone) {
  Workers workers(1);
  EXPECT_EQ(workers.count(), 1U);
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<std::size_t> order;
  workers.run(5, [&](std::size_t worker, std::size_t block) {
    EXPECT_EQ(worker, 0U);
    EXPECT_EQ(std::this_thread::get_id(), caller);
    order.push_back(block);
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(Workers, HaveDoneAllWhenTheCallReturns) {
  Workers workers(3);
  std::vector<int> sums(50);
  for (int call = 1; call <= 8; ++call) {
    workers.run(sums.size(), [&](std::size_t, std::size_t block) { sums[block] += call; });
    for (const int sum : sums) ASSERT_EQ(sum, call * (call + 1) / 2);
  }
}

TEST(Workers, DoNothingForNoBlocks) {
  Workers workers(2);
  workers.run(0, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(Workers, ThrowWhatABlockThrowsAfterTheOthersAreDone) {
  Workers workers(3);
  std::atomic<int> done = 0;
  const auto work = [&](std::size_t, std::size_t block) {
    if (block == 3) throw std::runtime_error("block 3");
    ++done;
  };
  EXPECT_THROW(workers.run(50, work), std::runtime_error);
  EXPECT_EQ(done, 49);
}

TEST(Workers, GoOnAfterAnException) {
  Workers workers(2);
  EXPECT_THROW(workers.run(4, [](std::size_t, std::size_t) { throw 1; }), int);
  std::atomic<int> done = 0;
  workers.run(4, [&](std::size_t, std::size_t) { ++done; });
  EXPECT_EQ(done, 4);
}

TEST(Workers, EndWithoutWork) { Workers workers(4); }

}  // namespace
}  // namespace jaywalk

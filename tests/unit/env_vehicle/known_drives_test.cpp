// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "env/vehicle/controller_processes.h"

namespace jaywalk {
namespace {

TEST(KnownDrives, AreFollowedAsFarAsTheirViewsAreTheSame) {
  KnownDrives drives;
  drives.add({"a", 1});
  drives.add({"b", 2});
  drives.begin();
  EXPECT_EQ(drives.follow("a"), 1);
  EXPECT_EQ(drives.follow("c"), std::nullopt);
  EXPECT_EQ(drives.follow("b"), 2) << "it stayed where it was";
  EXPECT_EQ(drives.follow("a"), std::nullopt) << "the end";
}

TEST(KnownDrives, PartWhereTheirViewsDo) {
  KnownDrives drives;
  drives.add({"a", 1});
  drives.add({"b", 2});
  drives.begin();
  (void)drives.follow("a");
  drives.add({"c", 3});
  drives.add({"b", 4});
  drives.begin();
  (void)drives.follow("a");
  EXPECT_EQ(drives.follow("c"), 3);
  EXPECT_EQ(drives.follow("b"), 4) << "the same view after another one is another step";
  const auto way = drives.way_here();
  EXPECT_EQ(way.views, (std::vector<std::string>{"a", "c", "b"}));
  EXPECT_EQ(way.answers, (std::vector<double>{1, 3, 4}));
}

TEST(KnownDrives, AreForgotten) {
  KnownDrives drives;
  drives.add({"a", 1});
  drives.forget();
  EXPECT_EQ(drives.follow("a"), std::nullopt);
  EXPECT_TRUE(drives.way_here().views.empty());
}

TEST(KnownDrives, AreKeptUpToALimit) {
  KnownDrives drives;
  const std::string large(std::size_t{20} << 20U, 'x');
  for (int i = 0; i < 5; ++i) drives.add({large + std::to_string(i), 0});
  EXPECT_LT(drives.way_here().views.size(), 5U);
  drives.begin();
  EXPECT_EQ(drives.follow(large + "0"), 0);
  drives.add({"a small one", 1});
  EXPECT_EQ(drives.follow("a small one"), std::nullopt);
}

}  // namespace
}  // namespace jaywalk

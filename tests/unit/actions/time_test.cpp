// SPDX-License-Identifier: Apache-2.0
// .time .date .nano_time .version .list_files

#include <gtest/gtest.h>

#include "tests/unit/actions/bodies.h"

namespace jaywalk::test {
namespace {

TEST(TimeActions, FollowTheVirtualClock) {
  expect_lines({
      {".time(H, M, S); .date(Y, Mo, D); .print(H, M, S, \" \", Y, Mo, D)", {"000 200011"}},
      {".wait(3723004); .time(H, M, S, Ms); .print(H, \":\", M, \":\", S, \".\", Ms)", {"1:2:3.4"}},
      {".wait(86400000); .date(2000, 1, 2); .print(system.time)", {"946771200000"}},
      {".wait(2); .nano_time(T); .print(T)", {"2000000"}},
      {".date(1999, _, _)", {"failed: ia_failed"}},
      {".time(a, _, _)", {"failed: wrong_arguments"}},
      {".version(V); .string(V); .print(yes)", {"yes"}},
  });
}

// Where they may be listed, tests/cli/access and tests/conformance see to it.
TEST(FileActions, ListNothingUnlessTheRunAllowsIt) {
  expect_lines({
      {".list_files(\"tests\", L); .print(L)", {"[]"}},
      {".list_files(\"/no/such/folder\", \"(\", L)", {"failed: unknown"}},
      {".list_files(a, L)", {"failed: wrong_arguments"}},
  });
}

}  // namespace
}  // namespace jaywalk::test

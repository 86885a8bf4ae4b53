// SPDX-License-Identifier: Apache-2.0
// The yellow pages.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using testing::ElementsAre;

TEST(Directory, ListsProvidersInTheOrderOfRegistration) {
  System system;
  system.add("ann", "!s. +!s <- .wait(100); .df_register(\"cook\").");
  system.add("bob", "!s. +!s <- .df_register(\"cook\"); .df_register(\"clean\", t).");
  system.add("carl",
             "!s. +!s <- .wait(200); .df_search(\"cook\", L); .df_search(\"clean\", t, M); "
             ".df_search(\"clean\", u, N); .print(L, M, N).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[carl] [bob,ann][bob][]"));
}

TEST(Directory, TellsSubscribersNowAndLater) {
  System system;
  system.add("ann",
             "!s. +!s <- .wait(100); .df_subscribe(\"cook\"). "
             "+provider(A, S)[source(D)] <- .print(A, \" \", S, \" \", D).");
  system.add("bob", "!s. +!s <- .df_register(\"cook\").");
  system.add("carl", "!s. +!s <- .wait(300); .df_register(\"cook\").");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] bob cook df", "[ann] carl cook df"));
}

TEST(Directory, ForgetsThoseWhoLeave) {
  System system;
  system.add("ann", "!s. +!s <- .wait(100); .kill_agent(bob); .df_search(\"cook\", L); .print(L).");
  system.add("bob", "!s. +!s <- .df_register(\"cook\").");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] []"));
}

}  // namespace
}  // namespace jaywalk

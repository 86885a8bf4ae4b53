// SPDX-License-Identifier: Apache-2.0
// Actions on goals that are still events: no plan has been chosen for them yet, since an atomic
// plan goes first.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"

namespace jaywalk {
namespace {

using test::printed_by;
using ::testing::ElementsAre;

TEST(PendingGoal, ThatSucceedsIsNotPursued) {
  EXPECT_THAT(
      printed_by("!g. @[atomic] +!g <- !!h; .succeed_goal(h); .print(done). +!h <- .print(never)."),
      ElementsAre("done"));
}

TEST(PendingGoal, ThatFailsHasItsFailurePlan) {
  EXPECT_THAT(printed_by("!g. @[atomic] +!g <- !!h; .fail_goal(h). +!h <- .print(never). "
                         "-!h <- .print(failed)."),
              ElementsAre("failed"));
}

TEST(PendingGoal, ThatIsDroppedIsNotPursuedAndDoesNotFail) {
  EXPECT_THAT(
      printed_by("!g. @[atomic] +!g <- !!h; .drop_event(h); .print(done). +!h <- .print(never). "
                 "-!h <- .print(never_failed)."),
      ElementsAre("done"));
}

TEST(PendingGoal, ThatIsSuspendedWaitsUntilItIsResumed) {
  EXPECT_THAT(printed_by("!g. @[atomic] +!g <- !!h; .suspend(h); !!later. "
                         "+!later <- .wait(10); .print(before); .resume(h). "
                         "+!h <- .print(after)."),
              ElementsAre("before", "after"));
}

TEST(PendingGoal, ThatSomebodyWaitsForLetsHimGoOnWhenItSucceeds) {
  EXPECT_THAT(printed_by("!a. !b. +!a <- !h; .print(went_on). +!b <- .succeed_goal(h). "
                         "+!h <- .wait(1000); .print(late)."),
              ElementsAre("went_on"));
}

}  // namespace
}  // namespace jaywalk

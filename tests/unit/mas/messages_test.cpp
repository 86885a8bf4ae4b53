// SPDX-License-Identifier: Apache-2.0
// The contents of messages, and their order.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/circumstance/message.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Messages, ArriveInTheOrderOfSenderAndSequence) {
  System system;
  system.add("ann", "!s. +!s <- .send(carl, tell, m(a1)); .send(carl, tell, m(a2)).");
  system.add("bob", "!s. +!s <- .send(carl, tell, m(b1)); .send(carl, tell, m(b2)).");
  system.add("carl", "+m(X)[source(S)] <- .print(X, \" \", S).");
  system.run();
  EXPECT_THAT(system.printed,
              ElementsAre("[carl] a1 ann", "[carl] b1 bob", "[carl] a2 ann", "[carl] b2 bob"));
}

TEST(Messages, AreNamedByNumbersWhoseTextsComeBack) {
  EXPECT_EQ(text_of(MessageId{}), "");
  EXPECT_EQ(text_of({MessageId::Kind::message, 7}), "mid7");
  EXPECT_EQ(text_of({MessageId::Kind::question, 65'536}), "samid65536");
  EXPECT_EQ(question_named("samid12"), (MessageId{MessageId::Kind::question, 12}));
  EXPECT_EQ(question_named("mid12"), MessageId{});
  EXPECT_EQ(question_named(""), MessageId{});
  for (const char* const never :
       {"samid", "samid007", "samid-1", "samid65537", "samid1x", "samid99999999999999999999"}) {
    EXPECT_EQ(question_named(never), (MessageId{MessageId::Kind::question, 0})) << never;
  }
}

TEST(Messages, ReachWhoBearsTheNameNow) {
  System system;
  system.provide("w.asl", "+hi <- .my_name(N); .print(N).");
  system.add("ann", R"(
    !s.
    +!s <- .create_agent(w, "w.asl"); .send(w, tell, hi); .wait(10); .kill_agent(w);
       .create_agent(v, "w.asl"); !missing; .create_agent(w, "w.asl"); .send(w, tell, hi);
       .send(v, tell, hi); .send("w", tell, hi); .send([v, w, self], tell, hi).
    +!missing <- .send(w, tell, hi).
    -!missing[error_msg(M)] <- .print(M).
    +hi <- .print(myself).)");
  system.run();
  EXPECT_THAT(system.printed,
              ElementsAre("[w] w", "[ann] there is no agent w", "[w] w", "[v] v", "[ann] myself"));
}

TEST(Messages, WithAQuotedOrUnusualPerformativeArriveAsTheyAre) {
  System system;
  system.add("ann", "!s. +!s <- .send(bob, 'achieve', b); .send(bob, cfp, c, x).");
  system.add("bob", "+!b <- .print(b). +!kqml_received(S, cfp, C, Id) <- .print(S, C, Id).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[bob] b", "[bob] anncmid2"));
}

TEST(Messages, ToOneselfComeFromSelf) {
  System system;
  system.add("ann",
             "!s. +!s <- .my_name(N); .send(N, tell, a); .send(self, tell, b). "
             "+a[source(S)] <- .print(a, S). +b[source(S)] <- .print(b, S).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] aself", "[ann] bself"));
}

TEST(Messages, NestTheSourcesOfWhatWasTold) {
  System system;
  system.add("ann", "!s. +!s <- .send(bob, tell, p(1)[source(zoe), k]).");
  system.add("bob", "+p(X)[source(S)] <- ?p(X)[source(A)]; .findall(L, p(1)[|L], R); .print(R).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[bob] [[k,source(ann)[source(zoe)]]]"));
}

TEST(Messages, ToAnUnknownAgentFail) {
  System system;
  system.add(
      "ann",
      "!s. +!s <- .send(bob, tell, p). -!s[error(E), error_msg(M)] <- .print(E, \": \", M).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] receiver_not_found: there is no agent bob"));
}

TEST(Messages, NeedAPerformativeAndANamedReceiver) {
  System system;
  system.add("ann",
             "!s(1). !s(2). !s(3). +!s(1) <- .send(ann, 5, p). +!s(2) <- .send(7, tell, p). "
             "+!s(3) <- .send(ann, \"tell\", p). "
             "-!s(N)[error(E)] <- .print(N, \" \", E).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] 1 wrong_arguments", "[ann] 2 wrong_arguments",
                                          "[ann] 3 wrong_arguments"));
}

TEST(Messages, ThatAskNothingHaveNoUseForATimeout) {
  System system;
  system.add("ann", "!s. +!s <- .send(ann, tell, p, m, soon). +p <- .print(p).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] p"));
}

TEST(Messages, AreHandledByTheAgentsOwnPlansFirst) {
  System system;
  system.add("ann", "!s. +!s <- .send(bob, tell, secret); .send(bob, tell, news).");
  system.add("bob",
             "+!kqml_received(S, tell, secret, Id) <- .print(\"not from \", S). "
             "+news <- .print(news). +secret <- .print(never).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[bob] not from ann", "[bob] news"));
}

TEST(Messages, AreNotTakenByAPlanForAllGoals) {
  System system;
  system.add("ann", "!s. +!s <- .send(bob, tell, news).");
  system.add("bob", "+news <- .print(news). +!G <- .print(G).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[bob] news"));
}

TEST(Messages, WithoutMeaningAreReported) {
  System system;
  system.add("ann", "!s. +!s <- .send(bob, mumble, p(1)).");
  system.add("bob", "");
  system.run();
  ASSERT_EQ(system.printed.size(), 1U);
  EXPECT_THAT(system.printed[0], HasSubstr("Communication error -- "));
}

TEST(Messages, MayDropADesire) {
  System system;
  system.add("ann",
             "!s. +!s <- .send(bob, achieve, work); .wait(500); .send(bob, unachieve, work).");
  system.add("bob", "+!work <- .print(starts); .wait(1000); .print(never).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[bob] starts"));
}

TEST(Messages, ToAllLeaveOutTheSender) {
  System system;
  const char* const hears = "+hello[source(S)] <- .my_name(N); .print(S).";
  system.add("ann", std::string("!s. +!s <- .broadcast(tell, hello). ") + hears);
  system.add("bob", hears);
  system.add("carl", hears);
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[bob] ann", "[carl] ann"));
}

}  // namespace
}  // namespace jaywalk

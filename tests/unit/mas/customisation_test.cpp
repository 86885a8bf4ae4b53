// SPDX-License-Identifier: Apache-2.0
// Agents with selection functions, belief revision and social acceptance of their own.

#include "interpreter/agent/surroundings/customisation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/agent.h"
#include "interpreter/term/print.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> printed_with(Customisation functions, std::string_view program) {
  System system;
  system.add("ann", program);
  system.agents.back().customisation = std::make_shared<const Customisation>(std::move(functions));
  system.run();
  return system.printed;
}

std::string text(Value value, const Agent& agent) { return term_text(value, agent.symbols()); }

TEST(Customisation, SelectsTheNewestEvent) {
  const Customisation functions{
      .select_event = [](Agent&, const Ring<Event>& events) { return events.size() - 1; }};
  EXPECT_THAT(printed_with(functions,
                           "!a. !b. !c. +!a <- .print(a). +!b <- .print(b). "
                           "+!c <- .print(c)."),
              ElementsAre("[ann] c", "[ann] b", "[ann] a"));
}

TEST(Customisation, MayLeaveEventsForLater) {
  int asked = 0;
  const Customisation functions{
      .select_event = [&](Agent&, const Ring<Event>&) -> std::optional<std::size_t> {
        if (++asked < 5) return std::nullopt;
        return 0;
      }};
  EXPECT_THAT(printed_with(functions, "!a. +!a <- .print(a)."), ElementsAre("[ann] a"));
  EXPECT_EQ(asked, 5);
}

TEST(Customisation, SelectsTheLastOption) {
  const Customisation functions{
      .select_option = [](Agent&, const Event&, std::span<const Option> options) {
        return options.size() - 1;
      }};
  EXPECT_THAT(printed_with(functions,
                           "p(1). p(2). !g(_). +!g(1) : p(X) <- .print(first, X). "
                           "+!g(2) : p(X) <- .print(second, X). "
                           "+!g(Y) : p(7) <- .print(Y)."),
              ElementsAre("[ann] second1"));
}

TEST(Customisation, BindsWhatTheChosenOptionBinds) {
  const Customisation functions{
      .select_option = [](Agent&, const Event&, std::span<const Option> options) {
        return options.size() - 1;
      }};
  EXPECT_THAT(printed_with(functions, "!s. +!s <- !g(X); .print(X). +!g(one). +!g(two)."),
              ElementsAre("[ann] two"));
}

TEST(Customisation, SeesEverySolutionOfAPlanForAllUnifiers) {
  std::vector<std::string> seen;
  const Customisation functions{
      .select_option = [&](Agent& agent, const Event&, std::span<const Option> options) {
        for (const Option& option : options) seen.push_back(text(option.values.at(0), agent));
        return options.size() - 1;
      }};
  EXPECT_THAT(printed_with(functions,
                           "p(1). p(2). p(3). !g. @[all_unifs] +!g : p(X) <- .print(X). "
                           "+!g : p(Y) <- .print(Y)."),
              ElementsAre("[ann] 1"));
  EXPECT_THAT(seen, ElementsAre("1", "2", "3", "1"));
}

TEST(Customisation, MayRefuseAllOptions) {
  const Customisation functions{
      .select_option = [](Agent&, const Event& event,
                          std::span<const Option>) -> std::optional<std::size_t> {
        if (event.op == TriggerOperator::remove) return 0;
        return std::nullopt;
      }};
  EXPECT_THAT(printed_with(functions, "!g. +!g <- .print(g). -!g[error(E)] <- .print(E)."),
              ElementsAre("[ann] no_applicable"));
}

TEST(Customisation, SelectsTheNewestIntention) {
  const Customisation functions{
      .select_intention = [](Agent&, const Ring<Intention*>& ready) { return ready.size() - 1; }};
  EXPECT_THAT(printed_with(functions,
                           "!a. !b. +!a <- .print(a1); .print(a2). "
                           "+!b <- .print(b1); .print(b2)."),
              ElementsAre("[ann] a1", "[ann] b1", "[ann] b2", "[ann] a2"));
}

TEST(Customisation, IgnoresAChoiceBeyondTheEnd) {
  int asked = 0;
  const Customisation functions{.select_intention = [&](Agent&, const Ring<Intention*>& ready) {
    return ++asked < 3 ? ready.size() : 0;
  }};
  EXPECT_THAT(printed_with(functions, "!a. +!a <- .print(a)."), ElementsAre("[ann] a"));
}

TEST(Customisation, RefusesBeliefs) {
  const Customisation functions{.revise_beliefs = [](BeliefRevision& revision) {
    const std::string belief = text(revision.literal(), revision.agent());
    if (!belief.starts_with("secret")) revision.accept();
  }};
  EXPECT_THAT(
      printed_with(functions,
                   "secret(0). known(0). !s. "
                   "+!s <- +secret(1); +known(1); .asserta(secret(2)); .assertz(secret(3)); "
                   ".assertz(known(2)); .findall(X, secret(X), S); "
                   ".findall(X, known(X), K); .print(S, K)."),
      ElementsAre("[ann] [][1,0,2]"));
}

TEST(Customisation, ChangesOtherBeliefsToo) {
  const Customisation functions{.revise_beliefs = [](BeliefRevision& revision) {
    Agent& agent = revision.agent();
    if (revision.kind() == BeliefRevision::Kind::add) {
      // There is one position at most.
      const Value any = agent.heap().variable();
      revision.remove(
          agent.heap().structure(agent.symbols().predicate("at", 1), std::span(&any, 1)));
    }
    revision.accept();
  }};
  EXPECT_THAT(printed_with(functions,
                           "!s. +!s <- +at(1); +at(2); .findall(X, at(X), L); .print(L). "
                           "+at(X) <- .print(at, X). -at(X) <- .print(left, X)."),
              ElementsAre("[ann] at1", "[ann] left1", "[ann] at2", "[ann] [2]"));
}

TEST(Customisation, IsToldWhichIntentionAsks) {
  std::vector<bool> asked;
  const Customisation functions{.revise_beliefs = [&](BeliefRevision& revision) {
    asked.push_back(revision.intention() != nullptr);
    revision.accept();
  }};
  printed_with(functions, "p(1). !s. +!s <- +q; -q; ++r.");
  EXPECT_THAT(asked, ElementsAre(false, true, true, false));
}

TEST(Customisation, RefusesMessagesButNotAnswers) {
  System system;
  system.add("ann", "!s. +!s <- .send(bob, askOne, q(_), A); .print(A). +hello <- .print(hello).");
  system.agents.back().customisation = std::make_shared<const Customisation>(Customisation{
      .accepts_message = [](Agent&, const Message& message) { return message.sender != "bob"; }});
  system.add("bob", "q(7). !s. +!s <- .send(ann, tell, hello).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] q(7)[source(bob)]"));
}

TEST(Customisation, GoesToAClone) {
  System system;
  system.add("ann", "!s. +!s <- .clone(eve); .wait(10); .send(eve, tell, p). +p <- .print(p).");
  system.agents.back().customisation = std::make_shared<const Customisation>(
      Customisation{.accepts_message = [](Agent&, const Message&) { return false; }});
  system.run();
  EXPECT_THAT(system.printed, IsEmpty());
}

}  // namespace
}  // namespace jaywalk

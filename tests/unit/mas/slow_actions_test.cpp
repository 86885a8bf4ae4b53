// SPDX-License-Identifier: Apache-2.0
// Actions whose results come in a later tick, agents that do not look in every tick, and percepts
// of any terms.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/environment/percepts.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// `work(T)` is done at the end of tick T, `fail(T)` fails then, `lose(T,Thing)` without a reason.
/// In the order of their numbers, the later ones first.
class Workshop final : public Environment {
 public:
  explicit Workshop(SymbolTable& symbols)
      : work_(symbols.predicate("work", 1)),
        lose_(symbols.predicate("lose", 2)),
        tick_(symbols.predicate("tick", 1)) {}

  void use_names(SymbolTable& symbols) override { symbols_ = &symbols; }

  void perceive(AgentId /*agent*/, Percepts& percepts) const override {
    percepts.add(tick_, {Value::number(now_)});
    std::swap(before_, told_);
    told_.clear();
    for (const std::string& each : seen) {
      Result<GroundLiteral> read = GroundLiteral::read(*symbols_, "percept", each);
      ASSERT_TRUE(read.ok()) << read.diagnostics().render();
      told_.push_back(std::move(read).value());
      add_percept(percepts, told_.back());
    }
  }
  [[nodiscard]] bool is_unchanged(AgentId /*agent*/) const override { return blind; }
  void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) override {
    for (std::size_t i = 0; i < actions.size(); ++i) {
      if (actions[i].args.empty()) continue;
      results[i].is_pending = true;
      const Predicate action = actions[i].predicate;
      pending_[actions[i].number] = {
          static_cast<int>(actions[i].args[0].as_number()),
          {.succeeded = action == work_, .reason = action == lose_ ? "" : "broken"}};
    }
    if (each_tick) each_tick(now_);
  }
  void take_results(const ResultReceiver& deliver) override {
    for (auto each = pending_.rbegin(); each != pending_.rend(); ++each) {
      if (each->second.first != now_ - 1) continue;
      deliver(each->first, each->second.second);
    }
    deliver(4711, {});  // never given to an action
  }
  void advance() override { ++now_; }
  [[nodiscard]] bool finished() const override { return now_ > 9; }
  [[nodiscard]] double tick_ms() const override { return 100; }

  std::vector<std::string> seen;
  bool blind = false;
  std::function<void(int now)> each_tick;

 private:
  SymbolTable* symbols_ = nullptr;
  Predicate work_;
  Predicate lose_;
  Predicate tick_;
  int now_ = 0;
  std::map<std::uint64_t, std::pair<int, ActionResult>> pending_;
  mutable std::vector<GroundLiteral> told_;
  mutable std::vector<GroundLiteral> before_;
};

class SlowActions : public testing::Test {
 protected:
  std::vector<std::string> run(std::string_view program) {
    system.add("a", program);
    (void)system.run(&world);
    return system.printed;
  }

  System system;
  Workshop world{*system.symbols};
};

TEST_F(SlowActions, MakeTheirIntentionWaitWhileOthersGoOn) {
  EXPECT_THAT(run("!slow. !quick."
                  "+!slow <- work(3); ?tick(T); .print(slow, T)."
                  "+!quick <- hop; hop; ?tick(T); .print(quick, T)."),
              ElementsAre("[a] quick3", "[a] slow4"));
}

TEST_F(SlowActions, EndInAnyOrder) {
  EXPECT_THAT(run("!first. !second. !third."
                  "+!first <- work(5); .print(first)."
                  "+!second <- work(3); .print(second)."
                  "+!third <- work(5); .print(third)."),
              ElementsAre("[a] second", "[a] third", "[a] first"));
}

TEST_F(SlowActions, FailTheirPlanWithTheReason) {
  EXPECT_THAT(run("!g. +!g <- fail(2); .print(never)."
                  "-!g[error(E), error_msg(M)] <- ?tick(T); .print(E, \" \", M, \" \", T)."),
              ElementsAre("[a] action_failed broken 3"));
}

TEST_F(SlowActions, OfADroppedIntentionEndForNobody) {
  EXPECT_THAT(run("!g. !d."
                  "+!g <- work(3); .print(never)."
                  "+!d <- hop; .drop_intention(g); !!again."
                  "+!again <- work(5); ?tick(T); .print(again, T)."),
              ElementsAre("[a] again6"));
  EXPECT_THAT(system.logged, IsEmpty());
}

TEST_F(SlowActions, OfAGoalThatEndedEndForNobody) {
  EXPECT_THAT(run("!g. !d."
                  "+!g <- !sub; work(6); ?tick(T); .print(after, T)."
                  "+!sub <- work(3); .print(never)."
                  "+!d <- hop; .succeed_goal(sub)."),
              ElementsAre("[a] after7"));
}

TEST_F(SlowActions, OutliveTheirAgent) {
  system.add("b", "!k. +!k <- hop; .kill_agent(a).");
  EXPECT_THAT(run("!g. +!g <- work(5); .print(never)."), IsEmpty());
  EXPECT_THAT(system.logged, IsEmpty());
}

// It is busy when `lose` is under way; the message has its literal.
TEST_F(SlowActions, KeepTheirTermsWhileTheAgentCollectsGarbage) {
  EXPECT_THAT(run("!g(b). !later."
                  "+!g(X) <- lose(5, [\"a\", f(X)])."
                  "-!g(_)[error_msg(M)] <- .print(M)."
                  "+!later <- hop; hop; !busy(20000)."
                  "+!busy(0)."
                  "+!busy(N) <- .concat([N], [N, N], L); .length(L, M); !busy(N - 1)."),
              ElementsAre("[a] action lose(5,[\"a\",f(b)]) failed"));
}

TEST_F(SlowActions, SuspendedOnesGoOnWhenTheyAreResumed) {
  EXPECT_THAT(run("!g. !d."
                  "+!g <- work(2); ?tick(T); .print(done, T)."
                  "+!d <- hop; .suspend(g); .wait(500); ?tick(T); .print(T); .resume(g)."),
              ElementsAre("[a] 7", "[a] done7"));
}

TEST_F(SlowActions, AgentsThatDoNotLookKeepTheirBeliefs) {
  world.seen = {"ball(red)"};
  world.each_tick = [&](int now) {
    world.blind = now < 4;
    if (now == 1) world.seen.emplace_back("bat(1)");
  };
  EXPECT_THAT(run("!g."
                  "+!g <- -ball(red)[source(percept)]; hop; hop;"
                  "       if (ball(red)) { .print(back) } else { .print(gone) }."
                  "+bat(1) <- ?tick(T); .print(bat, T)."
                  "+ball(red) : tick(T) & T > 0 <- .print(ball, T)."),
              ElementsAre("[a] gone", "[a] ball5", "[a] bat5"));
}

TEST_F(SlowActions, PerceptsCanBeAnyGroundLiteral) {
  world.seen = {"at(robot, [1, \"two\", f(x)])", "~safe(\"the kerb\")",
                "seen(p(1)[conf(0.5)])[by(eye)]"};
  world.each_tick = [&](int now) {
    if (now == 2) world.seen = {"at(robot, [1, \"two\", f(y)])", "seen(p(1)[conf(0.5)])[by(ear)]"};
    if (now == 4) world.seen = {};
  };
  EXPECT_THAT(
      run("+at(R, L) <- .print(at(R, L))."
          "-at(R, L) <- .print(no(at(R, L)))."
          "+~safe(W)[source(S)] <- .print(W, S)."
          "-~safe(W) <- .print(safe, W)."
          "+seen(P)[by(B), source(S)] <- .print(P, B, S)."
          "-seen(P)[source(S)] <- .findall(Q, seen(Q), L); .print(unseen, P, S, L)."
          "+tick(4) : seen(P)[by(B)] <- .print(B)."),
      ElementsAre("[a] at(robot,[1,\"two\",f(x)])", "[a] the kerbpercept",
                  "[a] p(1)[conf(0.5)]eyepercept", "[a] no(at(robot,[1,\"two\",f(x)]))",
                  "[a] safethe kerb", "[a] at(robot,[1,\"two\",f(y)])", "[a] eye",
                  "[a] no(at(robot,[1,\"two\",f(y)]))", "[a] unseenp(1)[conf(0.5)]percept[]"));
}

TEST_F(SlowActions, PerceptsThatStayAreBelievedOnce) {
  world.seen = {"q([1])[a]", "r(\"x\")"};
  EXPECT_THAT(run("+q(L) <- .print(L). +r(S) <- .print(S). -q(_) <- .print(never)."),
              ElementsAre("[a] [1]", "[a] x"));
}

TEST(GroundLiterals, AreReadWithTheirErrors) {
  SymbolTable symbols;
  const auto error_of = [&](const std::string& text) {
    const Result<GroundLiteral> read = GroundLiteral::read(symbols, "percept", text);
    return read.ok() ? "" : read.diagnostics().render();
  };
  EXPECT_EQ(error_of("p(-1.5, \"x\", [a, f(b)], ~q)[c(1)]"), "");
  EXPECT_THAT(error_of("p(X)"), HasSubstr("expected a literal without variables"));
  EXPECT_THAT(error_of("p([a|T])"), HasSubstr("expected a literal without variables"));
  EXPECT_THAT(error_of("p(1+2)"), HasSubstr("expected a literal without variables"));
  EXPECT_THAT(error_of("p(1"), HasSubstr("percept:1:"));
  EXPECT_THAT(error_of("12"), HasSubstr("percept:1:1: error"));
  EXPECT_THAT(error_of(""), HasSubstr("percept:1:1: error"));
}

}  // namespace
}  // namespace jaywalk

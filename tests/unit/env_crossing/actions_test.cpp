// SPDX-License-Identifier: Apache-2.0
// Each action of percepts.def: what it does, and why it fails.

#include <cmath>

#include <gmock/gmock.h>

#include "tests/unit/env_crossing/agents.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;

class ActionsInTheCrossing : public CrossingAgents {
 protected:
  /// A pedestrian's place after an action of the first tick, or why it failed.
  std::string after(Position start, const Action& action) {
    Crossing crossing = world({start});
    const std::string reason = tick(crossing, {action}).front();
    return reason.empty() ? seen(crossing, 0, "at") : reason;
  }
};

TEST_F(ActionsInTheCrossing, StepsLeadEachWay) {
  EXPECT_EQ(after({5, 30}, move(0, Direction::left)), "at(4,30)");
  EXPECT_EQ(after({5, 30}, move(0, Direction::right)), "at(6,30)");
  EXPECT_EQ(after({5, 30}, move(0, Direction::forward)), "at(5,31)");
  EXPECT_EQ(after({5, 30}, move(0, Direction::back)), "at(5,29)");
}

TEST_F(ActionsInTheCrossing, StepsLeadAsFarAsSomebodyCanWalk) {
  parameters_.pedestrians.speed = 2.5;
  EXPECT_EQ(after({5, 30}, move(0, Direction::forward)), "at(5,32.5)");
  EXPECT_EQ(after({5, 30}, move(0, Direction::forward, 1)), "at(5,31)");
  EXPECT_EQ(after({5, 30}, move(0, Direction::forward, 100)), "at(5,32.5)") << "no further";
}

TEST_F(ActionsInTheCrossing, StepsMayLeadNowhere) {
  EXPECT_EQ(after({5, 30}, move(0, Direction::forward, 0)), "at(5,30)");
  EXPECT_EQ(after({5, 30}, stay(0)), "at(5,30)");
}

TEST_F(ActionsInTheCrossing, StepsHaveCellsThatAreANumberFromZero) {
  constexpr const char* kRefused = "the cells of a step are a number, at least 0";
  EXPECT_EQ(after({5, 30}, move(0, Direction::forward, -1)), kRefused);
  EXPECT_EQ(after({5, 30}, move(0, Direction::forward, std::nan(""))), kRefused);
  Action odd = move(0, Direction::forward, 1);
  odd.args[1] = vocabulary_.atom(Direction::left);
  EXPECT_EQ(after({5, 30}, odd), kRefused);
}

TEST_F(ActionsInTheCrossing, StepsHaveAWay) {
  Action odd = move(0, Direction::forward);
  odd.args[0] = vocabulary_.atom(SignalColour::red);
  EXPECT_EQ(after({5, 30}, odd), "unknown way to move, expected left, right, forward or back");
  odd.args[0] = Value::number(1);
  EXPECT_EQ(after({5, 30}, odd), "unknown way to move, expected left, right, forward or back");
}

TEST_F(ActionsInTheCrossing, StepsEndAtObstaclesAndTheEdge) {
  parameters_.obstacles = {{{1, 1}, {31, 31}}};
  EXPECT_EQ(after({1, 30}, move(0, Direction::forward)), "a step forward from (1,30) is blocked");
  EXPECT_EQ(after({1, 30}, move(0, Direction::left)), "at(0,30)");
  EXPECT_EQ(after({0, 30}, move(0, Direction::left)), "a step left from (0,30) leaves the grid");
}

TEST_F(ActionsInTheCrossing, OthersAreUnknown) {
  const Action jump{0, symbols_.predicate(Signature{.functor = symbols_.symbol("jump")}), {}};
  EXPECT_EQ(after({5, 30}, jump),
            "unknown action, expected move(Way), move(Way,Cells), stay or show(Colour)");
}

TEST_F(ActionsInTheCrossing, NobodyTakesTwoStepsInATick) {
  Crossing crossing = world({{5, 30}});
  EXPECT_THAT(tick(crossing, {move(0, Direction::left, 0.25), move(0, Direction::left, 0.25)}),
              ElementsAre("", "a second step in the same tick"));
  EXPECT_EQ(seen(crossing, 0, "at"), "at(4.75,30)");
}

TEST_F(ActionsInTheCrossing, AStepThatFailedWasOne) {
  Crossing crossing = world({{0, 30}});
  const auto reasons = tick(crossing, {move(0, Direction::left), move(0, Direction::right)});
  EXPECT_NE(reasons[0], "");
  EXPECT_EQ(reasons[1], "a second step in the same tick");
}

TEST_F(ActionsInTheCrossing, StayingIsNoStep) {
  Crossing crossing = world({{5, 30}});
  EXPECT_THAT(tick(crossing, {stay(0), move(0, Direction::left)}), ElementsAre("", ""));
}

TEST_F(ActionsInTheCrossing, AreCountedOfThosePedestriansThatSucceed) {
  parameters_.actors = {{.name = "rider", .kind = ActorKind::cyclist, .start = {7, 40}}};
  Crossing crossing = world({{5, 30}, {0, 30}});
  tick(crossing, {move(0, Direction::left), move(1, Direction::left), move(2, Direction::forward)});
  ASSERT_EQ(crossing.result().agents.size(), 2U);
  EXPECT_EQ(crossing.result().agents[0].actions, 1U);
  EXPECT_EQ(crossing.result().agents[1].actions, 0U);
}

TEST_F(ActionsInTheCrossing, NobodyMindsWhoIsInTheCellAlready) {
  Crossing crossing = world({{5, 30}, {4, 30}});
  EXPECT_THAT(tick(crossing, {move(0, Direction::left)}), ElementsAre(""));
  EXPECT_EQ(seen(crossing, 0, "at"), seen(crossing, 1, "at"));
}

TEST_F(ActionsInTheCrossing, DoNotDependOnTheirOrder) {
  Crossing one = world({{5, 30}, {4, 30}});
  Crossing other = world({{5, 30}, {4, 30}});
  tick(one, {move(0, Direction::left), move(1, Direction::right)});
  tick(other, {move(1, Direction::right), move(0, Direction::left)});
  for (const std::size_t agent : {0U, 1U}) {
    EXPECT_EQ(seen(one, agent, "at"), seen(other, agent, "at"));
  }
}

/// A light at a signalled crosswalk, and a cyclist.
class ActorsInTheCrossing : public ActionsInTheCrossing {
 protected:
  ActorsInTheCrossing() {
    parameters_.crosswalks = {{CrosswalkKind::zebra, {10, 11}},
                              {CrosswalkKind::signalled, {40, 42}}};
    parameters_.actors = {
        {.name = "light", .kind = ActorKind::signal, .crosswalk = 1},
        {.name = "rider", .kind = ActorKind::cyclist, .start = {7, 63}, .speed = 3}};
  }
};

TEST_F(ActorsInTheCrossing, ASignalShowsColours) {
  Crossing crossing = world({{1, 30}});
  for (const auto& [colour, word] :
       {std::pair{SignalColour::amber, "amber"}, std::pair{SignalColour::red, "red"},
        std::pair{SignalColour::green, "green"}}) {
    EXPECT_THAT(tick(crossing, {show(1, colour)}), ElementsAre(""));
    EXPECT_EQ(seen(crossing, 0, "signal"), fmt::format("signal(2,{})", word));
    EXPECT_EQ(crossing.signal(1), colour);
  }
}

TEST_F(ActorsInTheCrossing, OnlyAChangeOfColourIsAnEvent) {
  Crossing crossing = world({{1, 30}});
  tick(crossing, {show(1, SignalColour::green)});
  EXPECT_TRUE(crossing.result().signals.empty()) << "as before the first tick";
  tick(crossing, {show(1, SignalColour::red)});
  tick(crossing, {show(1, SignalColour::red)});
  ASSERT_EQ(crossing.result().signals.size(), 1U);
  EXPECT_EQ(crossing.result().signals[0].tick, 2);
  EXPECT_EQ(crossing.result().signals[0].body, 1U);
  ASSERT_EQ(crossing.events().size(), 1U);
  EXPECT_EQ(crossing.events()[0].kind, "signal");
  EXPECT_EQ(crossing.events()[0].text, "red");
}

TEST_F(ActorsInTheCrossing, ASignalKnowsThreeColours) {
  Crossing crossing = world({{1, 30}});
  Action blue = show(1, SignalColour::red);
  blue.args[0] = vocabulary_.atom(Direction::left);
  EXPECT_THAT(tick(crossing, {blue}), ElementsAre("unknown colour, expected green, amber or red"));
}

TEST_F(ActorsInTheCrossing, OnlyASignalShowsAndItDoesNotMove) {
  Crossing crossing = world({{1, 30}});
  EXPECT_THAT(tick(crossing, {show(0, SignalColour::red), move(1, Direction::left)}),
              ElementsAre("only a signal shows a colour", "a signal does not move"));
}

TEST_F(ActorsInTheCrossing, ACyclistLeavesWhereTheRoadEnds) {
  Crossing crossing = world({{1, 30}});
  EXPECT_THAT(tick(crossing, {move(2, Direction::forward)}), ElementsAre(""));
  EXPECT_TRUE(crossing.bodies()[2].gone) << "three cells from the last but two";
  EXPECT_THAT(tick(crossing, {move(2, Direction::back)}), ElementsAre("it has left the road"));
}

}  // namespace
}  // namespace jaywalk

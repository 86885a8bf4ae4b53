// SPDX-License-Identifier: Apache-2.0
// The percept that docs/internals/add_percept.md adds is there as the page says.

#include <gtest/gtest.h>

#include "env/crossing/crossing.h"

namespace jaywalk {
namespace {

/// The arguments of a percept of agent 0 at its next look; empty if there is none.
std::vector<double> perceived(const Crossing& crossing, const SymbolTable& symbols,
                              Percepts& percepts, std::string_view name) {
  percepts.begin_look();
  crossing.perceive(static_cast<AgentId>(0), percepts);
  percepts.end_look();
  std::vector<double> args;
  for (std::size_t i = 0; i < percepts.size(); ++i) {
    if (symbols.functor(percepts.predicate(i)) != name) continue;
    for (const Value value : percepts.args(i)) args.push_back(value.as_number());
  }
  return args;
}

TEST(PerceptTutorial, HasAPerceptThatFollowsTheVehicle) {
  SymbolTable symbols;
  const CrossingVocabulary vocabulary(symbols);
  const CrossingParameters parameters;
  Crossing crossing(parameters, vocabulary, {{1, 12}});
  Percepts percepts;
  const auto end = static_cast<double>(parameters.road_end);
  EXPECT_EQ(perceived(crossing, symbols, percepts, "road_left"), std::vector<double>{end});
  std::vector<ActionResult> results;
  crossing.execute({}, results);
  crossing.advance();
  const double origin = perceived(crossing, symbols, percepts, "av").at(0);
  EXPECT_GT(origin, 0);
  EXPECT_EQ(perceived(crossing, symbols, percepts, "road_left"), std::vector<double>{end - origin});
}

TEST(PerceptTutorial, HasAPerceptThatIsListed) {
  EXPECT_EQ(kCrossingPercepts.back().form, "road_left(Cells)");
}

}  // namespace
}  // namespace jaywalk

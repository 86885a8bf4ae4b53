// SPDX-License-Identifier: Apache-2.0
// What learners learn, by a problem that can be solved exactly.

#include <algorithm>
#include <array>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/policy/learner.h"
#include "tests/unit/learning/gridworld.h"

namespace jaywalk {
namespace {

using namespace testing_learning;
using testing::DoubleEq;
using testing::ElementsAre;

const PolicyShape kShape{.options = {"right", "left", "up", "down"}, .features = kSize * kSize};

std::unique_ptr<Learner> made(std::string_view name, const LearnerSettings& settings = {}) {
  return find_learner(name)->make(kShape, settings, 1);
}

/// The greatest error of all cells, relative to the greatest value.
double greatest_error(const Learner& learner) {
  double error = 0;
  for (const Cell cell : cells_to_begin_in()) {
    error = std::max(error, std::abs(learner.value(features_of(cell)) - best_value(cell)));
  }
  return error / 3;
}

/// The best moves from a cell, by what the learner takes for best.
double probability_of_best(const Learner& learner, Cell cell) {
  std::array<double, 4> probabilities{};
  const std::array<std::uint32_t, 4> all{0, 1, 2, 3};
  learner.weigh(features_of(cell), all, Learner::Mode::exploit, probabilities);
  const std::array<Cell, 4> next{Cell{cell.x + 1, cell.y}, Cell{cell.x - 1, cell.y},
                                 Cell{cell.x, cell.y + 1}, Cell{cell.x, cell.y - 1}};
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool inside = next[i].x >= 0 && next[i].x < kSize && next[i].y >= 0 && next[i].y < kSize;
    if (inside && best_value(next[i]) > best_value(cell)) sum += probabilities[i];
  }
  return sum;
}

void teach(Learner& learner, int generations) {
  networks::Random random(7);
  for (int i = 0; i < generations; ++i) learner.learn(generation_of(learner, random));
}

TEST(QTable, SolvesATextbookProblemExactly) {
  const auto learner = made("q-table", {.rate = 0.1, .halves_after = 2000});
  teach(*learner, 400);
  EXPECT_LT(greatest_error(*learner), 0.01);
  for (const Cell cell : cells_to_begin_in()) {
    EXPECT_THAT(probability_of_best(*learner, cell), DoubleEq(1)) << cell.x << ' ' << cell.y;
  }
}

TEST(ActorCritic, SolvesATextbookProblem) {
  const auto learner = made("actor-critic", {.trace = 0.9, .rate = 0.003, .entropy = 0.001});
  teach(*learner, 400);
  EXPECT_LT(greatest_error(*learner), 0.01);
  for (const Cell cell : cells_to_begin_in()) {
    EXPECT_GT(probability_of_best(*learner, cell), 0.99) << cell.x << ' ' << cell.y;
  }
}

class EveryLearner : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryLearner, KnowsNothingAtFirst) {
  const auto learner = made(GetParam());
  std::array<double, 2> probabilities{};
  const std::array<std::uint32_t, 2> options{1, 3};
  learner->weigh(features_of({1, 2}), options, Learner::Mode::explore, probabilities);
  EXPECT_NEAR(probabilities[0] + probabilities[1], 1, 1e-12);
  EXPECT_GT(probabilities[0], 0.2);
  EXPECT_GT(probabilities[1], 0.2);
}

TEST_P(EveryLearner, GoesOnFromItsStateToTheLastBit) {
  const auto learner = made(GetParam());
  networks::Random random(3);
  for (int i = 0; i < 5; ++i) learner->learn(generation_of(*learner, random));
  const auto other = made(GetParam());
  other->restore(nlohmann::json::parse(learner->state().dump()));
  EXPECT_EQ(other->state().dump(), learner->state().dump());
  const std::vector<Episode> next = generation_of(*learner, random);
  learner->learn(next);
  other->learn(next);
  EXPECT_EQ(other->state().dump(), learner->state().dump());
}

TEST_P(EveryLearner, RefusesTheStateOfAnother) {
  const auto learner = made(GetParam());
  networks::Random random(3);
  learner->learn(generation_of(*learner, random));
  const PolicyShape wider{.options = {"a", "b", "c", "d", "e"}, .features = kSize * kSize};
  const auto other = find_learner(GetParam())->make(wider, {}, 1);
  EXPECT_THROW(other->restore(learner->state()), std::exception);
  EXPECT_THROW(other->restore(nlohmann::json::array()), std::exception);
}

TEST_P(EveryLearner, LearnsWhatPaysAmongTheOptionsThatThereAre) {
  const auto learner = made(GetParam());
  const std::array<std::uint32_t, 2> options{1, 2};
  std::array<double, 2> probabilities{};
  for (int i = 0; i < 400; ++i) {
    learner->weigh(features_of({1, 1}), options, Learner::Mode::explore, probabilities);
    std::vector<Episode> generation;
    for (const std::uint32_t chosen : {0U, 1U}) {
      generation.push_back({{.features = features_of({1, 1}),
                             .options = {1, 2},
                             .chosen = chosen,
                             .probability = probabilities[chosen],
                             .reward = chosen == 1 ? 1.0 : 0.0}});
    }
    learner->learn(generation);
  }
  learner->weigh(features_of({1, 1}), options, Learner::Mode::exploit, probabilities);
  EXPECT_GT(probabilities[1], 0.9);
}

TEST(ActorCritic, LeavesNothingToChanceOnceItExploits) {
  const auto learner = made("actor-critic");
  networks::Random random(3);
  learner->learn(generation_of(*learner, random));
  const std::array<std::uint32_t, 4> all{0, 1, 2, 3};
  std::array<double, 4> explored{};
  std::array<double, 4> exploited{};
  const std::vector<double> features = features_of({0, 0});
  learner->weigh(features, all, Learner::Mode::explore, explored);
  learner->weigh(features, all, Learner::Mode::exploit, exploited);
  EXPECT_LT(*std::ranges::max_element(explored), 1);
  const auto likeliest = std::ranges::max_element(explored) - explored.begin();
  for (std::ptrdiff_t i = 0; i < 4; ++i) {
    EXPECT_THAT(exploited[static_cast<std::size_t>(i)], DoubleEq(i == likeliest ? 1 : 0));
  }
}

/// How probable the likeliest move is on average, while it learns, after some generations.
double certainty(const LearnerSettings& settings) {
  const auto learner = made("actor-critic", settings);
  teach(*learner, 60);
  double sum = 0;
  const std::array<std::uint32_t, 4> all{0, 1, 2, 3};
  for (const Cell cell : cells_to_begin_in()) {
    std::array<double, 4> probabilities{};
    learner->weigh(features_of(cell), all, Learner::Mode::explore, probabilities);
    sum += *std::ranges::max_element(probabilities);
  }
  return sum / static_cast<double>(cells_to_begin_in().size());
}

TEST(ActorCritic, LeavesLessToChanceAsTimeGoesOn) {
  const double lasting = certainty({.halves_after = 1e6, .entropy = 1});
  const double halved = certainty({.halves_after = 10, .entropy = 1});
  EXPECT_LT(lasting, 0.5);
  EXPECT_GT(halved, 0.7);
  EXPECT_LT(certainty({.halves_after = 10, .entropy = 1, .entropy_least = 1}), 0.6);
}

INSTANTIATE_TEST_SUITE_P(Learners, EveryLearner, testing::Values("q-table", "actor-critic"),
                         [](const auto& each) {
                           return each.param == "q-table" ? "QTable" : "ActorCritic";
                         });

TEST(QTable, PutsFeaturesIntoBins) {
  const PolicyShape shape{.options = {"a", "b"}, .features = 1};
  const auto learner = find_learner("q-table")->make(shape, {.bins = {2}}, 1);
  learner->learn(std::vector<Episode>{{{.features = {2.5}, .options = {0, 1}, .reward = 5}}});
  EXPECT_THAT(learner->value(std::array{3.9}), DoubleEq(5));
  EXPECT_THAT(learner->value(std::array{4.0}), DoubleEq(0));
  EXPECT_THAT(learner->value(std::array{1.9}), DoubleEq(0));
}

TEST(QTable, TriesEveryOptionOnce) {
  const PolicyShape shape{.options = {"a", "b"}, .features = 1};
  const auto learner = find_learner("q-table")->make(shape, {.explores = 0}, 1);
  learner->learn(std::vector<Episode>{{{.features = {1}, .options = {0, 1}, .reward = 5}}});
  std::array<double, 2> probabilities{};
  const std::array<std::uint32_t, 2> options{0, 1};
  learner->weigh(std::array{1.0}, options, Learner::Mode::explore, probabilities);
  EXPECT_THAT(probabilities, ElementsAre(DoubleEq(0.005), DoubleEq(0.995)));
  learner->weigh(std::array{1.0}, options, Learner::Mode::exploit, probabilities);
  EXPECT_THAT(probabilities, ElementsAre(1, 0));
}

}  // namespace
}  // namespace jaywalk

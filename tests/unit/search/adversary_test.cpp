// SPDX-License-Identifier: Apache-2.0
// Gradients are compared with differences of the loss.

#include "search/learn/adversary.h"

#include <cmath>

#include <gtest/gtest.h>

#include "search/generators/acceptance.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search::learn {
namespace {

/// A matrix with these columns.
Matrix columns(const std::vector<std::vector<float>>& all) {
  Matrix matrix(static_cast<Eigen::Index>(all.front().size()),
                static_cast<Eigen::Index>(all.size()));
  for (std::size_t column = 0; column < all.size(); ++column) {
    for (std::size_t row = 0; row < all[column].size(); ++row) {
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = all[column][row];
    }
  }
  return matrix;
}

constexpr NetworkShape kSmall{.inputs = 3, .hidden = 8, .outputs = 2, .slope = 0.1F};

TEST(TestMaker, MakesTestsOfTheSpace) {
  Random random(1);
  TestMaker maker(kSmall, TestMaker::Normalisation::batch, random);
  const Matrix made = maker.forward(noise(3, 50, random), Pass::training);
  EXPECT_EQ(made.rows(), 2);
  EXPECT_EQ(made.cols(), 50);
  EXPECT_LE(made.cwiseAbs().maxCoeff(), 1);
}

TEST(TestMaker, NormalisesABatchToMeanZeroAndDeviationOne) {
  Random random(2);
  TestMaker maker(kSmall, TestMaker::Normalisation::batch, random);
  const Matrix made = maker.forward(5 * noise(3, 200, random), Pass::training);
  // tanh is undone.
  const Matrix inner = made.array().atanh();
  for (Eigen::Index row = 0; row < 2; ++row) {
    EXPECT_NEAR(inner.row(row).mean(), 0, 1e-3);
    EXPECT_NEAR(inner.row(row).array().square().mean(), 1, 2e-2);
  }
}

TEST(TestMaker, GeneratesByWhatItHasSeenInTraining) {
  Random random(3);
  TestMaker maker(kSmall, TestMaker::Normalisation::batch, random);
  const Matrix input = noise(3, 4, random);
  const Matrix before = maker.forward(input, Pass::generating);
  EXPECT_EQ(maker.forward(input, Pass::generating), before) << "generating changes nothing";
  (void)maker.forward(5 * noise(3, 20, random), Pass::training);
  EXPECT_NE(maker.forward(input, Pass::generating), before);
}

TEST(TestMaker, GeneratesEachTestByItself) {
  Random random(4);
  TestMaker maker(kSmall, TestMaker::Normalisation::batch, random);
  const Matrix input = noise(3, 5, random);
  const Matrix together = maker.forward(input, Pass::generating);
  for (Eigen::Index i = 0; i < 5; ++i) {
    const Matrix alone = maker.forward(input.col(i), Pass::generating);
    EXPECT_LT((alone - together.col(i)).cwiseAbs().maxCoeff(), 1e-6F);
  }
}

class TestMakerGradients : public testing::TestWithParam<TestMaker::Normalisation> {};

TEST_P(TestMakerGradients, AreTheSlopesOfTheLoss) {
  Random random(5);
  TestMaker maker(kSmall, GetParam(), random);
  const Matrix input = noise(3, 6, random);
  const Matrix weights = noise(2, 6, random);  // the loss is their sum over the outputs
  const auto loss = [&] {
    return maker.forward(input, Pass::training).cwiseProduct(weights).sum();
  };
  (void)loss();
  maker.backward(weights);
  constexpr float kStep = 1e-2F;
  for (Layer* layer : maker.network().layers()) {
    float& weight = layer->weights(0, 0);
    const float before = weight;
    const float gradient = layer->weight_gradient(0, 0);
    weight = before + kStep;
    const float above = loss();
    weight = before - kStep;
    const float below = loss();
    weight = before;
    EXPECT_NEAR(gradient, (above - below) / (2 * kStep), 0.02 + 0.03 * std::fabs(gradient));
  }
}

INSTANTIATE_TEST_SUITE_P(Both, TestMakerGradients,
                         testing::Values(TestMaker::Normalisation::batch,
                                         TestMaker::Normalisation::none));

TEST(TestMaker, HasTheSlopeOfItsScale) {
  Random random(6);
  TestMaker maker(kSmall, TestMaker::Normalisation::batch, random);
  const Matrix input = noise(3, 6, random);
  const Matrix weights = noise(2, 6, random);
  const auto loss = [&] {
    return maker.forward(input, Pass::training).cwiseProduct(weights).sum();
  };
  (void)loss();
  maker.backward(weights);
  const float gradient = maker.scale_gradient()[0];
  maker.scale()[0] += 1e-2F;
  const float above = loss();
  maker.scale()[0] -= 2e-2F;
  EXPECT_NEAR(gradient, (above - loss()) / 2e-2F, 0.02);
}

constexpr AnalyzerSettings kAnalyzer{
    .shape = {.inputs = 2, .hidden = 16, .outputs = 1, .slope = 0.1F},
    .adam = {.rate = 0.01F, .beta1 = 0.9F, .beta2 = 0.999F}};

TEST(Analyzer, PredictsFitnessBetweenZeroAndOne) {
  Random random(7);
  Analyzer analyzer(kAnalyzer, random);
  const Matrix predicted = analyzer.predict(100 * noise(2, 40, random));
  EXPECT_GE(predicted.minCoeff(), 0);
  EXPECT_LE(predicted.maxCoeff(), 1);
}

TEST(Analyzer, HasNoLossWhereItPredictsWell) {
  Random random(8);
  Analyzer analyzer(kAnalyzer, random);
  const Matrix tests = noise(2, 5, random);
  EXPECT_NEAR(analyzer.add_loss_gradient(tests, analyzer.predict(tests)), 0, 1e-9);
  EXPECT_LT(analyzer.input_gradient(tests, analyzer.predict(tests)).cwiseAbs().maxCoeff(), 1e-6F);
}

TEST(Analyzer, HasAFiniteLossForTheSurestPredictions) {
  Random random(9);
  Analyzer analyzer(kAnalyzer, random);
  const Matrix tests = 1000 * noise(2, 20, random);
  for (const float wanted : {0.0F, 1.0F}) {
    const Matrix fitness = Matrix::Constant(1, 20, wanted);
    EXPECT_TRUE(std::isfinite(analyzer.add_loss_gradient(tests, fitness)));
    EXPECT_TRUE(analyzer.input_gradient(tests, fitness).allFinite());
  }
}

TEST(Analyzer, LearnsWhichTestsAreFit) {
  Random random(10);
  Analyzer analyzer(kAnalyzer, random);
  const Matrix tests = columns({{-1, -1}, {-1, 1}, {1, -1}, {1, 1}});
  const Matrix fitness = columns({{0.1F}, {0.9F}, {0.9F}, {0.1F}});
  const float before = analyzer.train(tests, fitness);
  float after = before;
  for (int i = 0; i < 600; ++i) after = analyzer.train(tests, fitness);
  EXPECT_LT(after, before / 20);
  EXPECT_LT((analyzer.predict(tests) - fitness).cwiseAbs().maxCoeff(), 0.1F);
}

TEST(Analyzer, HasTheSlopesOfItsLossByTheTests) {
  Random random(11);
  Analyzer analyzer(kAnalyzer, random);
  Matrix tests = noise(2, 3, random);
  const Matrix fitness = Matrix::Constant(1, 3, 1.0F);
  const Matrix gradient = analyzer.input_gradient(tests, fitness);
  constexpr float kStep = 1e-2F;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const float before = tests(0, i);
    tests(0, i) = before + kStep;
    const float above = analyzer.add_loss_gradient(tests, fitness);
    tests(0, i) = before - kStep;
    const float below = analyzer.add_loss_gradient(tests, fitness);
    tests(0, i) = before;
    EXPECT_NEAR(gradient(0, i), (above - below) / (2 * kStep),
                0.01 + 0.05 * std::fabs(gradient(0, i)));
  }
}

TEST(Analyzer, LeavesItsWeightsAloneForAGradientByTests) {
  Random random(12);
  Analyzer analyzer(kAnalyzer, random);
  analyzer.network().clear_gradients();
  (void)analyzer.input_gradient(noise(2, 3, random), Matrix::Constant(1, 3, 1.0F));
  for (const Layer* layer : analyzer.network().layers()) {
    EXPECT_EQ(layer->weight_gradient.cwiseAbs().maxCoeff(), 0);
  }
}

TEST(Analyzer, RegretsLargeWeightsAsFarAsItIsTold) {
  Random random(13);
  AnalyzerSettings settings = kAnalyzer;
  settings.regularisation = 0.5F;
  Analyzer analyzer(settings, random);
  float squares = 0;
  for (const Layer* layer : analyzer.network().layers()) {
    squares += layer->weights.squaredNorm() + layer->bias.squaredNorm();
  }
  const Matrix tests = noise(2, 4, random);
  EXPECT_NEAR(analyzer.add_loss_gradient(tests, analyzer.predict(tests)), 0.5F * squares, 1e-3);
}

TEST(WassersteinPair, MovesWhatItMakesTowardsRealTests) {
  Random random(14);
  WassersteinPair pair({.dimension = 2, .noise = 4, .hidden = 16, .rate = 5e-3F}, random);
  const Matrix real = Matrix::Constant(2, 16, 0.8F) + 0.05F * noise(2, 16, random);
  const auto miss = [&] { return (pair.make(64, random).array() - 0.8F).abs().mean(); };
  const float before = miss();
  for (int i = 0; i < 150; ++i) {
    for (int k = 0; k < 3; ++k) (void)pair.train_critic(real, random);
    (void)pair.train_maker(16, random);
  }
  EXPECT_LT(miss(), 0.6F * before);
}

TEST(WassersteinPair, ScoresRealTestsHigherAfterTraining) {
  Random random(15);
  WassersteinPair pair({.dimension = 2, .noise = 4, .hidden = 16, .rate = 1e-3F}, random);
  const Matrix real = Matrix::Constant(2, 16, 0.9F);
  const float first = pair.train_critic(real, random);
  float last = first;
  for (int i = 0; i < 100; ++i) last = pair.train_critic(real, random);
  EXPECT_LT(last, first) << "made tests score less than real ones";
}

TEST(Examples, AreTheColumnsOfTheirMatrices) {
  Examples examples;
  EXPECT_EQ(examples.inputs().cols(), 0);
  examples.add({.input = {Form::vector, {0.5, -1}}, .outcome = {}, .fitness = 0.25});
  examples.add({.input = {Form::vector, {0, 1}}, .outcome = {}, .fitness = 1});
  EXPECT_EQ(examples.size(), 2U);
  EXPECT_EQ(examples.inputs(), columns({{0.5F, -1}, {0, 1}}));
  EXPECT_EQ(examples.outputs(), columns({{0.25F}, {1}}));
}

/// Candidates are accepted on a square whose left quarter is invalid.
class Acceptance : public testing::Test {
 protected:
  Random random_{16};
  Analyzer analyzer_{kAnalyzer, random_};
  Square space_;
};

TEST_F(Acceptance, TakesACandidateAsSoonAsItIsAsGoodAsTheTarget) {
  Asking asking(space_, 0);
  int made = 0;
  // Each valid candidate halves the target: one after at most as many as bring it below them all.
  const auto accepted = accept_candidate(asking, analyzer_, {.reducer = 0.5}, [&] {
    ++made;
    return columns({{0.5F, 0.1F * static_cast<float>(made)}});
  });
  ASSERT_TRUE(accepted);
  const Matrix kept = columns({{0.5F, static_cast<float>(accepted->values[1])}});
  EXPECT_GE(analyzer_.predict(kept)(0, 0), std::pow(0.5, made));
  EXPECT_LE(made, 10);
}

TEST_F(Acceptance, TakesTheFirstWhereTheTargetFallsToNothing) {
  Asking asking(space_, 0);
  const auto accepted = accept_candidate(asking, analyzer_, {.reducer = 0}, [&] {
    return columns({{0.25F, 0.75F}});
  });
  ASSERT_TRUE(accepted);
  EXPECT_EQ(accepted->values, (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(asking.candidates(), 1U);
}

TEST_F(Acceptance, GivesUpAfterTooManyInvalidCandidates) {
  Asking asking(space_, 0);
  const auto accepted = accept_candidate(asking, analyzer_, {.patience = 7}, [&] {
    return columns({{-0.9F, 0}});
  });
  EXPECT_FALSE(accepted);
  EXPECT_EQ(asking.invalid(), 7U);
}

}  // namespace
}  // namespace jaywalk::search::learn

// SPDX-License-Identifier: Apache-2.0
// Gradients are compared with differences of the loss, updates with steps worked out by hand.

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "experiment/networks/network.h"

namespace jaywalk::networks {
namespace {

/// A layer with these weights, row by row, and biases.
Layer layer_of(Eigen::Index inputs, Eigen::Index outputs, const std::vector<float>& weights,
               const std::vector<float>& bias) {
  Random random(1);
  Layer layer(inputs, outputs, random);
  for (Eigen::Index row = 0; row < outputs; ++row) {
    for (Eigen::Index column = 0; column < inputs; ++column) {
      layer.weights(row, column) = weights[static_cast<std::size_t>(row * inputs + column)];
    }
    layer.bias(row) = bias[static_cast<std::size_t>(row)];
  }
  return layer;
}

Matrix column_of(const std::vector<float>& numbers) {
  Matrix matrix(static_cast<Eigen::Index>(numbers.size()), 1);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    matrix(i, 0) = numbers[static_cast<std::size_t>(i)];
  return matrix;
}

TEST(Layer, IsWeightsTimesInputPlusBias) {
  const Layer layer = layer_of(2, 3, {1, 2, 3, 4, 5, 6}, {0.5F, 0, -1});
  const Matrix output = layer.forward(column_of({10, 100}));
  EXPECT_EQ(output(0, 0), 210.5F);
  EXPECT_EQ(output(1, 0), 430);
  EXPECT_EQ(output(2, 0), 649);
}

TEST(Layer, TakesEachColumnForASample) {
  const Layer layer = layer_of(1, 1, {3}, {1});
  Matrix samples(1, 3);
  samples << 0, 1, 2;
  const Matrix output = layer.forward(samples);
  EXPECT_EQ(output(0, 0), 1);
  EXPECT_EQ(output(0, 1), 4);
  EXPECT_EQ(output(0, 2), 7);
}

TEST(Layer, BeginsWithWeightsWithinTheRootOfItsInputs) {
  Random random(7);
  const Layer layer(100, 40, random);
  EXPECT_LE(layer.weights.cwiseAbs().maxCoeff(), 0.1F);
  EXPECT_LE(layer.bias.cwiseAbs().maxCoeff(), 0.1F);
  EXPECT_GT(layer.weights.cwiseAbs().maxCoeff(), 0.09F) << "the whole range is used";
  EXPECT_LT(std::abs(layer.weights.mean()), 0.005F);
  EXPECT_EQ(layer.weight_gradient.cwiseAbs().maxCoeff(), 0);
}

TEST(Layer, AddsUpTheGradientsOfItsSamples) {
  Layer layer = layer_of(2, 1, {1, 1}, {0});
  Matrix x(2, 2);
  x << 1, 2, 3, 4;
  Matrix d(1, 2);
  d << 10, 100;
  layer.accumulate(d, x);
  EXPECT_EQ(layer.weight_gradient(0, 0), 10 * 1 + 100 * 2);
  EXPECT_EQ(layer.weight_gradient(0, 1), 10 * 3 + 100 * 4);
  EXPECT_EQ(layer.bias_gradient(0), 110);
  layer.accumulate(d, x);
  EXPECT_EQ(layer.bias_gradient(0), 220) << "they are added up";
  layer.clear_gradients();
  EXPECT_EQ(layer.weight_gradient(0, 0), 0);
  EXPECT_EQ(layer.bias_gradient(0), 0);
}

TEST(Layer, HandsTheGradientToItsInput) {
  const Layer layer = layer_of(2, 2, {1, 2, 3, 4}, {0, 0});
  const Matrix gradient = layer.input_gradient(column_of({10, 100}));
  EXPECT_EQ(gradient(0, 0), 10 * 1 + 100 * 3);
  EXPECT_EQ(gradient(1, 0), 10 * 2 + 100 * 4);
}

TEST(Products, OfTiledMatricesAreThoseOfPlainOnes) {
  Random random(3);
  for (const auto& [rows, inner, columns] :
       {std::array<Eigen::Index, 3>{16, 5, 7}, {32, 33, 2}, {16, 1, 9}, {48, 16, 17}}) {
    const Matrix a = noise(rows, inner, random);
    const Matrix b = noise(inner, columns, random);
    Matrix product;
    set_product(a, b, product);
    EXPECT_LT((product - Matrix(a * b)).cwiseAbs().maxCoeff(), 1e-4F) << rows << inner << columns;
    Matrix transposed = Matrix::Ones(rows, columns);
    add_product(Matrix(a.transpose()).transpose(), Matrix(b.transpose()).transpose(), transposed);
    EXPECT_LT((transposed - product - Matrix::Ones(rows, columns)).cwiseAbs().maxCoeff(), 1e-4F);
  }
}

TEST(Products, AddUpInTheOrderOfTheInnerIndex) {
  // The sum 1e8 + 1 - 1e8 is 0 in this order, and 1 in others.
  Matrix a = Matrix::Zero(16, 3);
  a.row(0) << 1e8F, 1, -1e8F;
  Matrix product;
  set_product(a, Matrix(Matrix::Ones(3, 2)), product);
  EXPECT_EQ(product(0, 0), 0);
}

TEST(Adam, MovesByItsRateInTheFirstStep) {
  // With corrections the first step is rate * g / |g|, whatever the gradient's size.
  for (const float gradient : {0.01F, 1.0F, 500.0F, -3.0F}) {
    std::array<float, 1> values{2};
    const std::array<float, 1> gradients{gradient};
    Adam adam({.rate = 0.1F, .beta1 = 0.9F, .beta2 = 0.999F});
    adam.add(values, gradients);
    adam.step();
    EXPECT_NEAR(values[0], 2 - std::copysign(0.1F, gradient), 1e-5) << gradient;
  }
}

TEST(Adam, FollowsTheAlgorithmInTheSecondStep) {
  std::array<float, 1> values{0};
  std::array<float, 1> gradients{1};
  Adam adam({.rate = 0.1F, .beta1 = 0.5F, .beta2 = 0.5F});
  adam.add(values, gradients);
  adam.step();
  gradients[0] = 3;
  const float before = values[0];
  adam.step();
  // m = 0.5 * 0.5 + 0.5 * 3 = 1.75, corrected by 0.75; v = 0.5 * 0.5 + 0.5 * 9 = 4.75, likewise.
  EXPECT_NEAR(before - values[0], 0.1 * (1.75 / 0.75) / std::sqrt(4.75 / 0.75), 1e-6);
}

TEST(Adam, FindsTheLeastOfAParabola) {
  std::array<float, 2> values{5, -4};
  std::array<float, 2> gradients{};
  Adam adam({.rate = 0.05F, .beta1 = 0.9F, .beta2 = 0.99F});
  adam.add(values, gradients);
  for (int i = 0; i < 500; ++i) {
    gradients = {2 * (values[0] - 1), 20 * (values[1] - 2)};
    adam.step();
  }
  EXPECT_NEAR(values[0], 1, 0.05);
  EXPECT_NEAR(values[1], 2, 0.05);
}

TEST(Adam, GoesOnFromItsMemory) {
  std::array<float, 1> one{0};
  std::array<float, 1> other{0};
  std::array<float, 1> gradients{1};
  Adam first({.beta1 = 0.9F});
  Adam second({.beta1 = 0.9F});
  first.add(one, gradients);
  second.add(other, gradients);
  first.step();
  first.step();
  other = one;
  ASSERT_TRUE(second.restore(first.memory()));
  gradients[0] = -2;
  first.step();
  second.step();
  EXPECT_EQ(one, other);
}

TEST(Adam, RefusesTheMemoryOfOtherNumbers) {
  std::array<float, 2> values{};
  const std::array<float, 2> gradients{1, 1};
  Adam adam({});
  adam.add(values, gradients);
  EXPECT_FALSE(adam.restore({.steps = 3, .moments = {1, 2}}));
  EXPECT_EQ(adam.memory().steps, 0);
}

constexpr NetworkShape kShape{.inputs = 3, .hidden = 16, .outputs = 2, .slope = 0.2F};

/// A loss of a network's output: the sum of the squares.
float loss_of(const Network& network, const Matrix& x) {
  return network.output(x).array().square().sum();
}

TEST(Network, GivesTheSameOutputWithoutKeepingAnything) {
  Random random(5);
  Network network(kShape, random);
  const Matrix x = noise(3, 4, random);
  EXPECT_EQ(network.output(x), network.forward(x));
}

TEST(Network, IsLinearWithASlopeOfOne) {
  Random random(5);
  Network network({.inputs = 2, .hidden = 16, .outputs = 1, .slope = 1}, random);
  const Matrix a = noise(2, 1, random);
  const Matrix b = noise(2, 1, random);
  const float zero = network.output(Matrix::Zero(2, 1))(0, 0);
  const float sum = network.output(a + b)(0, 0) - zero;
  EXPECT_NEAR(sum, network.output(a)(0, 0) + network.output(b)(0, 0) - 2 * zero, 1e-5);
}

TEST(Network, HasTheGradientsOfItsLoss) {
  Random random(11);
  Network network(kShape, random);
  const Matrix x = noise(3, 5, random);
  network.clear_gradients();
  const Matrix output = network.forward(x);
  network.backward(2 * output);
  constexpr float kStep = 1e-2F;
  for (Layer* const layer : network.layers()) {
    for (const Eigen::Index at : {Eigen::Index{0}, layer->weights.size() / 2}) {
      float& weight = layer->weights.data()[at];
      const float kept = weight;
      weight = kept + kStep;
      const float above = loss_of(network, x);
      weight = kept - kStep;
      const float below = loss_of(network, x);
      weight = kept;
      EXPECT_NEAR(layer->weight_gradient.data()[at], (above - below) / (2 * kStep), 2e-2) << at;
    }
    float& bias = layer->bias.data()[1];
    const float kept = bias;
    bias = kept + kStep;
    const float above = loss_of(network, x);
    bias = kept - kStep;
    const float below = loss_of(network, x);
    bias = kept;
    EXPECT_NEAR(layer->bias_gradient.data()[1], (above - below) / (2 * kStep), 2e-2);
  }
}

TEST(Network, HasTheGradientByItsInput) {
  Random random(12);
  Network network(kShape, random);
  Matrix x = noise(3, 1, random);
  const Matrix gradient = network.backward(2 * network.forward(x), Network::Gradients::none);
  constexpr float kStep = 1e-2F;
  for (Eigen::Index i = 0; i < 3; ++i) {
    Matrix above = x;
    above(i, 0) += kStep;
    Matrix below = x;
    below(i, 0) -= kStep;
    EXPECT_NEAR(gradient(i, 0), (loss_of(network, above) - loss_of(network, below)) / (2 * kStep),
                2e-2);
  }
  for (const Layer* const layer : network.layers()) {
    EXPECT_EQ(layer->weight_gradient.cwiseAbs().maxCoeff(), 0) << "it was not asked for the others";
  }
}

TEST(GradientPenalty, IsTheSquaredDistanceOfTheGradientsNormFromOne) {
  // One input and weights 1, 2, 3: the gradient is 6 where all units are positive.
  Random random(1);
  Network network({.inputs = 1, .hidden = 1, .outputs = 1}, random);
  *network.layers()[0] = layer_of(1, 1, {1}, {1});
  *network.layers()[1] = layer_of(1, 1, {2}, {0});
  *network.layers()[2] = layer_of(1, 1, {3}, {0});
  EXPECT_NEAR(network.add_gradient_penalty(Matrix::Ones(1, 1), 1), 25, 1e-4);
  // d/dw of (w1 w2 w3 - 1)^2 = 2 * 5 * the product of the others.
  EXPECT_NEAR(network.layers()[0]->weight_gradient(0, 0), 10 * 6, 1e-3);
  EXPECT_NEAR(network.layers()[1]->weight_gradient(0, 0), 10 * 3, 1e-3);
  EXPECT_NEAR(network.layers()[2]->weight_gradient(0, 0), 10 * 2, 1e-3);
  EXPECT_EQ(network.layers()[0]->bias_gradient(0), 0);
}

TEST(GradientPenalty, HasTheGradientsOfItsDifferences) {
  Random random(21);
  Network network({.inputs = 3, .hidden = 16, .outputs = 1, .slope = 0.2F}, random);
  const Matrix x = noise(3, 4, random);
  network.clear_gradients();
  (void)network.add_gradient_penalty(x, 2);
  const auto penalty = [&] {
    Network copy = network;
    return 2 * copy.add_gradient_penalty(x, 2);
  };
  constexpr float kStep = 1e-2F;
  for (Layer* const layer : network.layers()) {
    float& weight = layer->weights.data()[2];
    const float kept = weight;
    weight = kept + kStep;
    const float above = penalty();
    weight = kept - kStep;
    const float below = penalty();
    weight = kept;
    EXPECT_NEAR(layer->weight_gradient.data()[2], (above - below) / (2 * kStep), 2e-2);
  }
}

TEST(Random, DrawsWithinItsBounds) {
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const int between = random.between(-2, 3);
    EXPECT_GE(between, -2);
    EXPECT_LE(between, 3);
    const double uniform = random.uniform(1, 2);
    EXPECT_GE(uniform, 1);
    EXPECT_LT(uniform, 2);
  }
}

TEST(Random, ShufflesAllOfAList) {
  Random random(9);
  std::vector<int> items{1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<int> before = items;
  random.shuffle(items);
  EXPECT_NE(items, before);
  std::ranges::sort(items);
  EXPECT_EQ(items, before);
}

}  // namespace
}  // namespace jaywalk::networks

// SPDX-License-Identifier: Apache-2.0
#include "search/learn/severity_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "experiment/networks/product.h"

namespace jaywalk::search::learn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The severity assumed of a place unlike all known ones: it passes.
constexpr double kPriorSeverity = 0.6;
/// Observations between two adaptations, and how many of the newest they look at.
constexpr Index kAdaptEvery = 20;
constexpr Index kAdaptTo = 150;
/// With more observations than this, the oldest fifth is forgotten.
constexpr Index kMostKnown = 500;
constexpr Index kForgotten = 100;
constexpr double kLeastVariance = 1e-4;

/// exp(-d²/2) for each pair of columns.
MatrixXd kernel(const MatrixXd& a, const MatrixXd& b) {
  const VectorXd a2 = a.colwise().squaredNorm();
  const VectorXd b2 = b.colwise().squaredNorm();
  MatrixXd squares = -2 * a.transpose() * b;
  // |a-b|² = |a|² + |b|² - 2ab; rounding may leave less than 0.
  squares.colwise() += a2;
  squares.rowwise() += b2.transpose();
  return (-0.5 * squares.array().max(0)).exp();
}

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

}  // namespace

SeverityModel::SeverityModel(std::vector<FeatureLength> lengths) : lengths_(std::move(lengths)) {
  networks::fix_order_of_sums();
  places_.resize(static_cast<Index>(lengths_.size()), kMostKnown);
  severities_.resize(kMostKnown);
}

Eigen::ArrayXd SeverityModel::inverse_lengths(const Scale& scale) const {
  Eigen::ArrayXd inverse(static_cast<Index>(lengths_.size()));
  for (Index i = 0; i < inverse.size(); ++i) {
    const FeatureLength& length = lengths_[static_cast<std::size_t>(i)];
    inverse(i) = 1 / (scale.unit * length.stretch * std::exp(scale.growth * length.distance));
  }
  return inverse;
}

void SeverityModel::add(std::span<const double> features, double severity) {
  if (count_ == kMostKnown) forget();
  for (std::size_t i = 0; i < features.size(); ++i) {
    places_(static_cast<Index>(i), count_) = features[i];
  }
  severities_(count_) = severity;
  ++count_;
  if (count_ % kAdaptEvery == 0) {
    adapt();
    rebuild();
  } else {
    append();
  }
  solve();
}

void SeverityModel::forget() {
  const Index kept = count_ - kForgotten;
  places_.leftCols(kept) = places_.middleCols(kForgotten, kept).eval();
  severities_.head(kept) = severities_.segment(kForgotten, kept).eval();
  count_ = kept;
  rebuild();
}

double SeverityModel::log_evidence(const Scale& scale, Index count) const {
  const MatrixXd scaled =
      (places_.middleCols(count_ - count, count).array().colwise() * inverse_lengths(scale))
          .matrix();
  MatrixXd covariance = kernel(scaled, scaled);
  covariance.diagonal().array() += scale.noise;
  const Eigen::LLT<MatrixXd> llt(covariance);
  const VectorXd centred =
      (severities_.segment(count_ - count, count).array() - kPriorSeverity).matrix();
  const auto n = static_cast<double>(count);
  // The variance that makes the observations most probable, in closed form.
  const double variance = std::max(kLeastVariance, llt.matrixL().solve(centred).squaredNorm() / n);
  return -0.5 * n * std::log(variance) - llt.matrixLLT().diagonal().array().log().sum();
}

/// One step of a coordinate search.
void SeverityModel::adapt() {
  const Index count = std::min(count_, kAdaptTo);
  Scale best = scale_;
  double most = log_evidence(scale_, count);
  const auto consider = [&](double unit, double growth, double noise) {
    const Scale scale{std::clamp(scale_.unit * unit, 0.15, 4.0),
                      std::clamp(scale_.growth + growth, 0.0, 1.0),
                      std::clamp(scale_.noise * noise, 0.01, 1.0)};
    const double evidence = log_evidence(scale, count);
    if (evidence > most) {
      most = evidence;
      best = scale;
    }
  };
  // Each coordinate a step up and down; the best of the six, or none, is taken.
  consider(1.3, 0, 1);
  consider(1 / 1.3, 0, 1);
  consider(1, 0.1, 1);
  consider(1, -0.1, 1);
  consider(1, 0, 1.6);
  consider(1, 0, 1 / 1.6);
  scale_ = best;
}

void SeverityModel::rebuild() {
  scaled_ = (places_.leftCols(count_).array().colwise() * inverse_lengths(scale_)).matrix();
  MatrixXd covariance = kernel(scaled_, scaled_);
  covariance.diagonal().array() += scale_.noise;
  factor_ = covariance.llt().matrixL();
}

/// A row more of the factor.
void SeverityModel::append() {
  const Index n = count_ - 1;
  scaled_.conservativeResize(places_.rows(), count_);
  scaled_.col(n) = (places_.col(n).array() * inverse_lengths(scale_)).matrix();
  const VectorXd column = kernel(scaled_.leftCols(n), scaled_.col(n));
  const VectorXd row = factor_.triangularView<Eigen::Lower>().solve(column);
  factor_.conservativeResize(count_, count_);
  factor_.col(n).setZero();
  factor_.row(n).head(n) = row.transpose();
  // Exactly it is never less than the noise; of nearly equal places rounding would leave less.
  factor_(n, n) = std::sqrt(std::max(scale_.noise, 1 + scale_.noise - row.squaredNorm()));
}

void SeverityModel::solve() {
  const VectorXd centred = (severities_.head(count_).array() - kPriorSeverity).matrix();
  // Halfway through the solution its norm gives the variance, so that nothing is solved twice.
  weights_ = factor_.triangularView<Eigen::Lower>().solve(centred);
  variance_ =
      std::max(kLeastVariance, weights_.squaredNorm() / static_cast<double>(weights_.size()));
  factor_.triangularView<Eigen::Lower>().transpose().solveInPlace(weights_);
}

Eigen::ArrayXd SeverityModel::failure_probability(const Places& places) const {
  const Places scaled = (places.array().colwise() * inverse_lengths(scale_)).matrix();
  Eigen::ArrayXd mean = Eigen::ArrayXd::Constant(places.cols(), kPriorSeverity);
  Eigen::ArrayXd unexplained = Eigen::ArrayXd::Ones(places.cols());
  if (count_ > 0) {
    MatrixXd similar = kernel(scaled_, scaled);
    mean += (similar.transpose() * weights_).array();
    factor_.triangularView<Eigen::Lower>().solveInPlace(similar);
    unexplained -= similar.colwise().squaredNorm().transpose().array();
  }
  Eigen::ArrayXd probability(places.cols());
  for (Index i = 0; i < places.cols(); ++i) {
    // The variance of an observation there, noise included; a test fails at a severity of 1.
    const double variance = variance_ * (scale_.noise + std::max(0.0, unexplained(i)));
    probability(i) = normal_cdf((mean(i) - 1) / std::sqrt(variance));
  }
  return probability;
}

}  // namespace jaywalk::search::learn

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Predicts the severity of a test from the executed ones: a Gaussian process over the features of
// the places where tests failed or came nearest to failing (Rasmussen and Williams 2006, "Gaussian
// processes for machine learning", algorithm 2.1), with a squared-exponential kernel whose length
// differs from feature to feature.

#include <Eigen/Dense>
#include <span>
#include <vector>

namespace jaywalk::search::learn {

/// How far two values of a feature are apart when they begin to say little about each other: the
/// model's unit of length, times `stretch`, times exp(growth * distance).
struct FeatureLength {
  double stretch = 1;
  double distance = 0;
};

class SeverityModel {
 public:
  /// A column for each place.
  using Places = Eigen::MatrixXd;

  explicit SeverityModel(std::vector<FeatureLength> lengths);

  [[nodiscard]] std::size_t features() const { return lengths_.size(); }
  /// `severity`: 1 is where failing begins. Adapts unit, growth and noise now and then to what
  /// makes the severities most likely. REQUIRES: as many features.
  void add(std::span<const double> features, double severity);
  /// The probability that the severity at each of the places is above 1. REQUIRES: as many rows.
  [[nodiscard]] Eigen::ArrayXd failure_probability(const Places& places) const;

 private:
  /// The adapted parameters.
  struct Scale {
    double unit = 0.8;
    double growth = 0.25;
    double noise = 0.1;
  };

  [[nodiscard]] Eigen::ArrayXd inverse_lengths(const Scale& scale) const;
  /// The log evidence of the last `count` observations.
  [[nodiscard]] double log_evidence(const Scale& scale, Eigen::Index count) const;
  void adapt();
  void forget();
  void rebuild();
  void append();
  void solve();

  std::vector<FeatureLength> lengths_;
  Scale scale_;
  Places places_;  // the observed places, a column each; only the first count_ are valid
  Eigen::VectorXd severities_;
  Eigen::Index count_ = 0;
  // With the kernel of scale_.
  Places scaled_;
  Eigen::MatrixXd factor_;  // Cholesky's, lower
  Eigen::VectorXd weights_;
  double variance_ = 1;
};

}  // namespace jaywalk::search::learn

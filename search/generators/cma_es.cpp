// SPDX-License-Identifier: Apache-2.0
// CMA-ES (Hansen 2016, "The CMA evolution strategy: a tutorial", arXiv 1604.00772, with the default
// parameters of its table 1): a normal distribution whose mean and covariance follow the better
// half of each generation. Begins anew somewhere else when it has converged or no longer improves.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "search/evolve/evolution.h"
#include "search/generator.h"

namespace jaywalk::search::generator::cma_es {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum Parameter : std::size_t { kStep, kPopulation, kCurvatures };

constexpr std::array kParameters = {
    NumberParameter{"step", 0.3, 1e-6, 10, "standard deviation at the beginning"},
    NumberParameter{"population", 0, 0, 1e6, "tests of a generation; 0: 4 + 3 ln of the dimension"},
    NumberParameter{"curvatures", 17, 3, 1000, "of each road"},
};

constexpr int kResamplings = 100;
constexpr double kLeastStep = 0.01;
/// Generations without a better one before it begins anew.
constexpr int kStagnation = 12;

/// The constants that depend on the dimension and the size of a generation (table 1).
struct Constants {
  Constants(double n, std::size_t lambda) {
    for (std::size_t i = 0; i < std::max<std::size_t>(1, lambda / 2); ++i) {
      weights.push_back(std::log((static_cast<double>(lambda) + 1) / 2) -
                        std::log(static_cast<double>(i) + 1));
    }
    double sum = 0;
    double squares = 0;
    for (const double each : weights) sum += each;
    for (double& each : weights) {
      each /= sum;
      squares += each * each;
    }
    effective = 1 / squares;
    c_sigma = (effective + 2) / (n + effective + 5);
    d_sigma = 1 + 2 * std::max(0.0, std::sqrt((effective - 1) / (n + 1)) - 1) + c_sigma;
    c_c = (4 + effective / n) / (n + 4 + 2 * effective / n);
    c_1 = 2 / ((n + 1.3) * (n + 1.3) + effective);
    c_mu = std::min(1 - c_1,
                    2 * (0.25 + effective + 1 / effective - 2) / ((n + 2) * (n + 2) + effective));
    expected_norm = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
  }

  std::vector<double> weights;
  double effective = 1;
  double c_sigma = 0, d_sigma = 0, c_c = 0, c_1 = 0, c_mu = 0;
  double expected_norm = 1;
};

struct Sample {
  VectorXd direction;  // of which the step times is added to the mean
  double fitness = 0;
};

class CmaEs : public Generator {
 public:
  explicit CmaEs(const GeneratorSetup& setup)
      : space_(setup.space),
        random_(setup.seed),
        genome_(setup.space, static_cast<std::size_t>(setup.values[kCurvatures])),
        first_step_(setup.values[kStep]),
        n_(static_cast<double>(genome_.size())),
        lambda_(setup.values[kPopulation] >= 2 ? static_cast<std::size_t>(setup.values[kPopulation])
                                               : static_cast<std::size_t>(4 + 3 * std::log(n_))),
        constants_(n_, lambda_) {
    restart();
  }

  TestInput ask(Asking& asking) override {
    for (int i = 0; i < kResamplings; ++i) {
      asked_ = sample();
      TestInput input = genome_.express(genes(asked_));
      if (asking.valid(input)) return input;
    }
    // Around here next to nothing is valid.
    restart();
    asked_.resize(0);
    return draw_valid(asking, [&] { return space_.draw_initial(random_); });
  }

  void tell(const ExecutedTest& test, double) override {
    // A test that was not sampled from the distribution says nothing about it.
    if (asked_.size() == 0) return;
    samples_.push_back({asked_, test.fitness});
    if (samples_.size() == lambda_) update();
  }

 private:
  void restart() {
    const Genes drawn = genome_.draw(random_);
    const auto n = static_cast<Index>(genome_.size());
    mean_ = Eigen::Map<const VectorXd>(drawn.data(), n);
    step_ = first_step_;
    covariance_ = MatrixXd::Identity(n, n);
    axes_ = MatrixXd::Identity(n, n);
    lengths_ = VectorXd::Ones(n);
    step_path_ = VectorXd::Zero(n);
    path_ = VectorXd::Zero(n);
    samples_.clear();
    generations_ = 0;
    stagnating_ = 0;
    best_ = -1;
  }

  VectorXd sample() {
    VectorXd z(mean_.size());
    for (double& each : z) each = standard_normal(random_);
    return axes_ * lengths_.cwiseProduct(z);
  }

  [[nodiscard]] Genes genes(const VectorXd& direction) const {
    const VectorXd point = mean_ + step_ * direction;
    return {point.begin(), point.end()};
  }

  void update() {
    const Constants& c = constants_;
    std::ranges::stable_sort(samples_, std::greater<>{}, &Sample::fitness);
    stagnating_ = samples_.front().fitness > best_ ? 0 : stagnating_ + 1;
    best_ = std::max(best_, samples_.front().fitness);
    VectorXd shift = VectorXd::Zero(mean_.size());
    for (std::size_t i = 0; i < c.weights.size(); ++i) {
      shift += c.weights[i] * samples_[i].direction;
    }
    mean_ += step_ * shift;
    ++generations_;
    // C^(-1/2) times the shift: steps are measured as if the distribution were round.
    const VectorXd whitened = axes_ * (axes_.transpose() * shift).cwiseQuotient(lengths_);
    step_path_ = (1 - c.c_sigma) * step_path_ +
                 std::sqrt(c.c_sigma * (2 - c.c_sigma) * c.effective) * whitened;
    adapt_covariance(shift);
    step_ *= std::exp(c.c_sigma / c.d_sigma * (step_path_.norm() / c.expected_norm - 1));
    samples_.clear();
    // Written so that a NaN begins anew, too.
    if (!(step_ * lengths_.maxCoeff() > kLeastStep) || stagnating_ >= kStagnation) restart();
  }

  void adapt_covariance(const VectorXd& shift) {
    const Constants& c = constants_;
    // h_sigma of the tutorial: while the step grows quickly the rank-one path waits.
    const double settled = std::sqrt(1 - std::pow(1 - c.c_sigma, 2.0 * generations_));
    const bool moves = step_path_.norm() / settled < (1.4 + 2 / (n_ + 1)) * c.expected_norm;
    path_ *= 1 - c.c_c;
    if (moves) path_ += std::sqrt(c.c_c * (2 - c.c_c) * c.effective) * shift;
    // Keeping more of the covariance makes up for the path's loss by waiting.
    const double lost = moves ? 0 : c.c_1 * c.c_c * (2 - c.c_c);
    covariance_ *= 1 - c.c_1 - c.c_mu + lost;
    covariance_ += c.c_1 * path_ * path_.transpose();
    for (std::size_t i = 0; i < c.weights.size(); ++i) {
      const VectorXd& y = samples_[i].direction;
      covariance_ += c.c_mu * c.weights[i] * y * y.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(covariance_);
    axes_ = solver.eigenvectors();
    // Rounding may leave an eigenvalue at or below 0.
    lengths_ = solver.eigenvalues().cwiseMax(1e-12).cwiseSqrt();
  }

  const SearchSpace& space_;
  Random random_;
  Genome genome_;
  double first_step_;
  double n_;
  std::size_t lambda_;
  Constants constants_;
  VectorXd mean_;
  double step_ = 0;
  MatrixXd covariance_;
  MatrixXd axes_;     // eigenvectors of the covariance
  VectorXd lengths_;  // and square roots of its eigenvalues
  VectorXd step_path_;
  VectorXd path_;
  std::vector<Sample> samples_;
  VectorXd asked_;  // the direction of the test that was asked for; empty if it is none of these
  int generations_ = 0;
  int stagnating_ = 0;
  double best_ = -1;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<CmaEs>(setup);
}

}  // namespace jaywalk::search::generator::cma_es

// SPDX-License-Identifier: Apache-2.0
// RILaST (Humeniuk and Khomh 2025, "Representation improvement in latent space for search-based
// testing of autonomous robotic systems", arXiv 2503.20642): roads are first optimised for sharp
// bends without executing them, an autoencoder learns what those have in common, and a genetic
// algorithm searches its latent space.
//
// Where there are no roads, the genetic algorithm searches the vectors themselves.

#include <algorithm>
#include <array>
#include <cmath>

#include "env/lane/validity.h"
#include "search/evolve/evolution.h"
#include "search/generator.h"
#include "search/learn/autoencoder.h"

namespace jaywalk::search::generator::rilast {
namespace {

using learn::Matrix;

enum Parameter : std::size_t {
  kPopulation,
  kChildren,
  kCrossover,
  kMutation,
  kIndex,
  kSameness,
  kRuns,
  kRoads,
  kGenerations,
  kEpochs,
  kBatch,
  kRate,
  kCurvatures,
};

constexpr std::array kParameters = {
    NumberParameter{"population", 40, 2, 1e6, "tests that live at once"},
    NumberParameter{"children", 20, 1, 1e6, "of each generation"},
    NumberParameter{"crossover", 0.5, 0, 1, "share of pairs that are crossed"},
    NumberParameter{"mutation", 0.4, 0, 1, "share of children that are mutated"},
    NumberParameter{"index", 3, 0, 1000, "of crossover and mutation: the larger the smaller"},
    NumberParameter{"sameness", 0.025, 0, 2, "cosine distance below which roads are duplicates"},
    NumberParameter{"runs", 5, 1, 1000, "that optimise the roads to learn from"},
    NumberParameter{"roads", 80, 2, 1e5, "of each of them"},
    NumberParameter{"generations", 30, 0, 1e5, "of each of them"},
    NumberParameter{"epochs", 150, 1, 1e6, "of the autoencoder"},
    NumberParameter{"batch", 32, 2, 1e5, "roads in each of its steps"},
    NumberParameter{"rate", 1e-3, 1e-9, 1, "of its optimiser"},
    NumberParameter{"curvatures", 17, 3, 1000, "of each road"},
};

constexpr double kCrossedAtOnePoint = 0.9;
constexpr double kMutatedRoads = 0.4;
constexpr double kLatentBound = 3;

/// The cosine distance, 0 to 2.
double cosine_distance(const Genes& a, const Genes& b) {
  double product = 0;
  double a2 = 0;
  double b2 = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    product += a[i] * b[i];
    a2 += a[i] * a[i];
    b2 += b[i] * b[i];
  }
  return a2 > 0 && b2 > 0 ? 1 - product / std::sqrt(a2 * b2) : 0;
}

/// Roads with sharp bends.
class RoadSet {
 public:
  RoadSet(const SearchSpace& space, const Genome& genome, std::span<const double> values,
          Random& random)
      : space_(space), genome_(genome), random_(random) {
    const auto size = static_cast<std::size_t>(values[kRoads]);
    for (int run = 0; run < static_cast<int>(values[kRuns]); ++run) {
      // Each run has a population of its own: one alone would converge to roads that are alike.
      add_run(size, size * static_cast<std::size_t>(values[kGenerations] + 1));
    }
    scale();
  }

  /// From -1 to 1 in each row, a column for each road.
  [[nodiscard]] const Matrix& scaled() const { return scaled_; }

  [[nodiscard]] Genes unscaled(const Matrix& column) const {
    Genes genes;
    for (Eigen::Index i = 0; i < column.rows(); ++i) {
      genes.push_back(least_[i] + (most_[i] - least_[i]) * (column(i, 0) + 1) / 2);
    }
    return genes;
  }

 private:
  /// One over the least radius; 0 for a road that is not valid.
  [[nodiscard]] double sharpness(const Genes& genes) const {
    const TestInput input = genome_.express(genes);
    if (!space_.contains(input)) return 0;
    const TestInput points = space_.as_points(input);
    lane::Polyline line;
    for (std::size_t i = 0; i + 1 < points.values.size(); i += 2) {
      line.push_back({points.values[i], points.values[i + 1]});
    }
    const auto middle = lane::interpolate(line);
    const double radius = middle ? lane::least_radius_m(*middle) : 0;
    return radius > 0 ? 1 / radius : 0;
  }

  void add_run(std::size_t size, std::size_t judged) {
    Evolution evolution({size, size},
                        {.draw = [&] { return genome_.draw(random_); },
                         .cross =
                             [&](Genes& a, Genes& b) {
                               if (random_.uniform(0, 1) < kCrossedAtOnePoint)
                                 cross_at_one_point(a, b, random_);
                             },
                         .mutate =
                             [&](Genes& genes) {
                               if (random_.uniform(0, 1) >= kMutatedRoads) return;
                               genes = mutated_curvatures(std::move(genes), genome_, random_);
                             },
                         .same = [](const Genes& a, const Genes& b) { return a == b; }},
                        random_);
    for (std::size_t i = 0; i < judged; ++i) evolution.judge(sharpness(evolution.next()));
    for (const Genes& genes : evolution.fittest()) roads_.push_back(genes);
  }

  void scale() {
    const auto rows = static_cast<Eigen::Index>(genome_.size());
    Matrix all(rows, static_cast<Eigen::Index>(roads_.size()));
    for (std::size_t column = 0; column < roads_.size(); ++column) {
      for (std::size_t row = 0; row < genome_.size(); ++row) {
        all(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            static_cast<float>(roads_[column][row]);
      }
    }
    least_ = all.rowwise().minCoeff();
    most_ = all.rowwise().maxCoeff();
    // A curvature that is the same in all roads has no range.
    const learn::Vector range = (most_ - least_).cwiseMax(1e-6F);
    scaled_ = 2 * ((all.colwise() - least_).array().colwise() / range.array()) - 1;
  }

  const SearchSpace& space_;
  const Genome& genome_;
  Random& random_;
  std::vector<Genes> roads_;
  learn::Vector least_;
  learn::Vector most_;
  Matrix scaled_;
};

class Rilast : public Generator {
 public:
  explicit Rilast(const GeneratorSetup& setup)
      : space_(setup.space),
        values_(setup.values),
        random_(setup.seed),
        genome_(setup.space, static_cast<std::size_t>(values_[kCurvatures])),
        bound_(genome_.is_road() ? kLatentBound : 1),
        evolution_({static_cast<std::size_t>(values_[kPopulation]),
                    static_cast<std::size_t>(values_[kChildren])},
                   operators(), random_) {
    if (genome_.is_road()) learn_roads();
  }

  TestInput ask(Asking& asking) override {
    Evolved next = ask_evolution(evolution_, asking, space_, random_, [&](const Genes& genes) {
      return genome_.express(decoded(genes));
    });
    is_own_ = next.is_own;
    return std::move(next.input);
  }

  void tell(const ExecutedTest& test, double) override {
    if (is_own_) evolution_.judge(test.fitness);
  }

 private:
  void learn_roads() {
    roads_.emplace(space_, genome_, values_, random_);
    coder_.emplace(static_cast<Eigen::Index>(genome_.size()),
                   learn::AdamSettings{
                       .rate = static_cast<float>(values_[kRate]), .beta1 = 0.9F, .beta2 = 0.999F},
                   random_);
    const Matrix& all = roads_->scaled();
    std::vector<Eigen::Index> order(static_cast<std::size_t>(all.cols()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Eigen::Index>(i);
    const auto batch = static_cast<std::size_t>(values_[kBatch]);
    for (int epoch = 0; epoch < static_cast<int>(values_[kEpochs]); ++epoch) {
      random_.shuffle(order);
      for (std::size_t from = 0; from < order.size(); from += batch) {
        const std::size_t count = std::min(batch, order.size() - from);
        Matrix some(all.rows(), static_cast<Eigen::Index>(count));
        for (std::size_t i = 0; i < count; ++i) {
          some.col(static_cast<Eigen::Index>(i)) = all.col(order[from + i]);
        }
        // The returned loss is not needed.
        (void)coder_->train(some, random_);
      }
    }
  }

  [[nodiscard]] Genes decoded(const Genes& genes) const {
    if (!genome_.is_road()) return genes;
    Matrix latent(static_cast<Eigen::Index>(genes.size()), 1);
    for (std::size_t i = 0; i < genes.size(); ++i) {
      latent(static_cast<Eigen::Index>(i), 0) = static_cast<float>(genes[i]);
    }
    return roads_->unscaled(coder_->decode(latent));
  }

  Evolution::Operators operators() {
    return {.draw =
                [this] {
                  if (!genome_.is_road()) return genome_.draw(random_);
                  Genes genes(genome_.size());
                  // Points of the autoencoder's prior decode to roads like those that it learned
                  // from.
                  for (double& each : genes) each = standard_normal(random_);
                  return genes;
                },
            .cross =
                [this](Genes& a, Genes& b) {
                  if (random_.uniform(0, 1) >= values_[kCrossover]) return;
                  cross_by_sbx(a, b, values_[kIndex], bound_, random_);
                },
            .mutate =
                [this](Genes& genes) {
                  if (random_.uniform(0, 1) >= values_[kMutation]) return;
                  mutate_polynomially(genes, 1.0 / static_cast<double>(genes.size()),
                                      values_[kIndex], bound_, random_);
                },
            .same =
                [this](const Genes& a, const Genes& b) {
                  return genome_.is_road()
                             ? cosine_distance(decoded(a), decoded(b)) < values_[kSameness]
                             : a == b;
                }};
  }

  const SearchSpace& space_;
  std::span<const double> values_;
  Random random_;
  Genome genome_;
  double bound_;
  Evolution evolution_;
  bool is_own_ = false;  // the test that was asked for last
  std::optional<RoadSet> roads_;
  std::optional<learn::Autoencoder> coder_;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<Rilast>(setup);
}

}  // namespace jaywalk::search::generator::rilast

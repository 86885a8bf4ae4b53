// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shared by evolutionary generators: genomes of a fixed length, their operators, and a genetic
// algorithm that is asked for one individual after the other.

#include <functional>
#include <span>
#include <vector>

#include "search/generator.h"

namespace jaywalk::search {

using Genes = std::vector<double>;

/// The numbers that evolve: a road's curvatures or, where the space has only vectors, a vector.
class Genome {
 public:
  Genome(const SearchSpace& space, std::size_t curvatures);

  [[nodiscard]] bool is_road() const { return is_road_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Genes draw(Random& random) const;
  /// A road of as many points as it has genes, or the vector, within -1 to 1.
  [[nodiscard]] TestInput express(const Genes& genes) const;

 private:
  bool is_road_;
  std::size_t size_;
};

/// Applies a random mutator of Frenetic as RILaST uses them: times 1.1 to 1.2, 5 to 12 values
/// changed by up to 0.05 1/m, reversed, halves swapped, negated. Mutators that move values to other
/// places are for roads alone.
[[nodiscard]] Genes mutated_curvatures(Genes genes, const Genome& genome, Random& random);

/// The genes of both up to a random place, exchanged. REQUIRES: as many; at least two.
void cross_at_one_point(Genes& a, Genes& b, Random& random);

/// Simulated binary crossover (Deb and Agrawal 1995, "Simulated binary crossover for continuous
/// search space") of each pair of genes with probability 1/2. `index`: the larger the nearer to
/// the parents.
void cross_by_sbx(Genes& a, Genes& b, double index, double bound, Random& random);

/// Polynomial mutation (Deb and Goyal 1996) of each gene with that probability.
void mutate_polynomially(Genes& genes, double probability, double index, double bound,
                         Random& random);

/// Executed one after another; of parents and children together the fittest survive.
class Evolution {
 public:
  struct Settings {
    std::size_t population = 40;
    std::size_t children = 40;
  };
  struct Operators {
    std::function<Genes()> draw;
    /// Changes both.
    std::function<void(Genes&, Genes&)> cross;
    std::function<void(Genes&)> mutate;
    std::function<bool(const Genes&, const Genes&)> same;
  };

  Evolution(const Settings& settings, Operators operators, Random& random)
      : settings_(settings), operators_(std::move(operators)), random_(random) {}

  /// The genes to be judged next.
  [[nodiscard]] const Genes& next();
  /// How fit those are.
  void judge(double fitness);
  /// The genes of those that live once the last of a generation was judged, the fittest first.
  [[nodiscard]] std::vector<Genes> fittest();

 private:
  struct Individual {
    Genes genes;
    double fitness = 0;
  };

  void survive();
  void breed();
  [[nodiscard]] const Genes& choose();
  [[nodiscard]] bool is_known(const Genes& genes) const;

  Settings settings_;
  Operators operators_;
  Random& random_;
  std::vector<Individual> parents_;
  std::vector<Individual> brood_;
  std::size_t judged_ = 0;  // of the brood
};

/// The next test of an evolution, and whether it is one of its own.
struct Evolved {
  TestInput input;
  bool is_own = true;
};

/// Asks the evolution until what `express` makes of the genes is valid; invalid ones are judged to
/// have no fitness, as they would be by a simulator that refuses them. Something random after very
/// many.
template <class Express>
[[nodiscard]] Evolved ask_evolution(Evolution& evolution, Asking& asking, const SearchSpace& space,
                                    Random& random, Express express) {
  constexpr int kPatience = 1000;
  for (int i = 0; i < kPatience; ++i) {
    TestInput input = express(evolution.next());
    if (asking.valid(input)) return {std::move(input)};
    evolution.judge(0);
  }
  return {draw_valid(asking, [&] { return space.draw_initial(random); }), false};
}

}  // namespace jaywalk::search

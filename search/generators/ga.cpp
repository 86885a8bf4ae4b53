// SPDX-License-Identifier: Apache-2.0
// A plain genetic algorithm on the curvatures of a road: the baseline of Humeniuk and Khomh 2025
// ("Representation improvement in latent space for search-based testing of autonomous robotic
// systems", arXiv 2503.20642), after whose code the operators are.

#include <array>

#include "search/evolve/evolution.h"
#include "search/generator.h"

namespace jaywalk::search::generator::ga {
namespace {

enum Parameter : std::size_t { kPopulation, kChildren, kCrossover, kMutation, kCurvatures };

constexpr std::array kParameters = {
    NumberParameter{"population", 40, 2, 1e6, "tests that live at once"},
    NumberParameter{"children", 40, 1, 1e6, "of each generation"},
    NumberParameter{"crossover", 0.9, 0, 1, "share of pairs that are crossed at one point"},
    NumberParameter{"mutation", 0.4, 0, 1, "share of children that are mutated"},
    NumberParameter{"curvatures", 17, 3, 1000, "of each road"},
};

class CurvatureEvolution : public Generator {
 public:
  explicit CurvatureEvolution(const GeneratorSetup& setup)
      : space_(setup.space),
        values_(setup.values),
        random_(setup.seed),
        genome_(setup.space, static_cast<std::size_t>(values_[kCurvatures])),
        evolution_({static_cast<std::size_t>(values_[kPopulation]),
                    static_cast<std::size_t>(values_[kChildren])},
                   operators(), random_) {}

  TestInput ask(Asking& asking) override {
    Evolved next = ask_evolution(evolution_, asking, space_, random_,
                                 [&](const Genes& genes) { return genome_.express(genes); });
    is_own_ = next.is_own;
    return std::move(next.input);
  }

  void tell(const ExecutedTest& test, double) override {
    if (is_own_) evolution_.judge(test.fitness);
  }

 private:
  Evolution::Operators operators() {
    return {.draw = [this] { return genome_.draw(random_); },
            .cross =
                [this](Genes& a, Genes& b) {
                  if (a.size() < 2 || random_.uniform(0, 1) >= values_[kCrossover]) return;
                  cross_at_one_point(a, b, random_);
                },
            .mutate =
                [this](Genes& genes) {
                  if (random_.uniform(0, 1) >= values_[kMutation]) return;
                  genes = mutated_curvatures(std::move(genes), genome_, random_);
                },
            .same = [](const Genes& a, const Genes& b) { return a == b; }};
  }

  const SearchSpace& space_;
  std::span<const double> values_;
  Random random_;
  Genome genome_;
  Evolution evolution_;
  bool is_own_ = false;  // the test that was asked for last
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<CurvatureEvolution>(setup);
}

}  // namespace jaywalk::search::generator::ga

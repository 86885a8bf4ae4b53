// SPDX-License-Identifier: Apache-2.0
#include "search/evolve/evolution.h"

#include <algorithm>
#include <cmath>

#include "search/test_input.h"

namespace jaywalk::search {
namespace {

/// RILaST's numbers; 0.05 1/m of 0.07.
constexpr double kLeastScale = 1.1;
constexpr double kMostScale = 1.2;
constexpr double kMostChange = 0.05 / 0.07;
constexpr std::size_t kLeastChanged = 5;
constexpr int kTries = 100;

void change_some(Genes& genes, Random& random) {
  const std::size_t most =
      genes.size() > 2 * kLeastChanged ? genes.size() - kLeastChanged : (genes.size() + 1) / 2;
  // At most half of a short road is changed, so that it keeps something of its parent.
  const std::size_t least = std::min(kLeastChanged, most);
  std::vector<std::size_t> places(genes.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  random.shuffle(places);
  places.resize(least + random.below(most - least + 1));
  for (const std::size_t i : places) genes[i] += random.uniform(-kMostChange, kMostChange);
}

}  // namespace

Genome::Genome(const SearchSpace& space, std::size_t curvatures)
    : is_road_(space.sequences().has_value()), size_(is_road_ ? curvatures : space.dimension()) {}

Genes Genome::draw(Random& random) const {
  Genes genes;
  if (is_road_) {
    append_random(genes, static_cast<int>(size_), random);
  } else {
    for (std::size_t i = 0; i < size_; ++i) genes.push_back(random.uniform(-1, 1));
  }
  return genes;
}

TestInput Genome::express(const Genes& genes) const {
  if (is_road_) {
    // A sequence has a point less than values.
    TestInput input{Form::sequence, genes};
    input.values.push_back(0);
    return input;
  }
  TestInput input{Form::vector, genes};
  for (double& value : input.values) value = std::clamp(value, -1.0, 1.0);
  return input;
}

Genes mutated_curvatures(Genes genes, const Genome& genome, Random& random) {
  // Reversal and rotation only make sense where the genes are a sequence.
  switch (random.below(genome.is_road() ? 5 : 3)) {
    case 0: {
      const double factor = random.uniform(kLeastScale, kMostScale);
      for (double& gene : genes) gene *= factor;
      break;
    }
    case 1:
      change_some(genes, random);
      break;
    case 2:
      for (double& gene : genes) gene = -gene;
      break;
    case 3:
      std::reverse(genes.begin(), genes.end());
      break;
    default:
      std::rotate(genes.begin(), genes.begin() + static_cast<std::ptrdiff_t>(genes.size() / 2),
                  genes.end());
  }
  return genes;
}

void cross_at_one_point(Genes& a, Genes& b, Random& random) {
  const std::size_t end = 1 + random.below(a.size() - 1);
  std::swap_ranges(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(end), b.begin());
}

void cross_by_sbx(Genes& a, Genes& b, double index, double bound, Random& random) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (random.coin()) continue;
    const double u = random.uniform(0, 1);
    // Simulated binary crossover (Deb and Agrawal 1995): children lie around their parents' middle.
    const double beta = std::pow(u <= 0.5 ? 2 * u : 1 / (2 * (1 - u)), 1 / (index + 1));
    const double middle = (a[i] + b[i]) / 2;
    const double half = beta * (a[i] - b[i]) / 2;
    a[i] = std::clamp(middle + half, -bound, bound);
    b[i] = std::clamp(middle - half, -bound, bound);
  }
}

void mutate_polynomially(Genes& genes, double probability, double index, double bound,
                         Random& random) {
  for (double& gene : genes) {
    if (random.uniform(0, 1) >= probability) continue;
    const double u = random.uniform(0, 1);
    // Deb's polynomial mutation, as a share of the range from -bound to bound.
    const double delta =
        u < 0.5 ? std::pow(2 * u, 1 / (index + 1)) - 1 : 1 - std::pow(2 * (1 - u), 1 / (index + 1));
    gene = std::clamp(gene + 2 * bound * delta, -bound, bound);
  }
}

const Genes& Evolution::next() {
  if (judged_ == brood_.size()) {
    survive();
    breed();
  }
  return brood_[judged_].genes;
}

void Evolution::judge(double fitness) { brood_[judged_++].fitness = fitness; }

std::vector<Genes> Evolution::fittest() {
  if (judged_ == brood_.size()) survive();
  std::vector<Genes> all;
  for (const Individual& each : parents_) all.push_back(each.genes);
  return all;
}

void Evolution::survive() {
  // Parents compete with their children; of equals the older stays, as the sort is stable.
  parents_.insert(parents_.end(), std::make_move_iterator(brood_.begin()),
                  std::make_move_iterator(brood_.end()));
  std::ranges::stable_sort(parents_, std::greater<>{}, &Individual::fitness);
  if (parents_.size() > settings_.population) parents_.resize(settings_.population);
  brood_.clear();
  judged_ = 0;
}

bool Evolution::is_known(const Genes& genes) const {
  const auto is_same = [&](const Individual& each) { return operators_.same(each.genes, genes); };
  return std::ranges::any_of(parents_, is_same) || std::ranges::any_of(brood_, is_same);
}

void Evolution::breed() {
  if (parents_.empty()) {
    while (brood_.size() < settings_.population) brood_.push_back({operators_.draw()});
    return;
  }
  int in_vain = 0;
  while (brood_.size() < settings_.children) {
    Genes a = choose();
    Genes b = choose();
    operators_.cross(a, b);
    for (Genes* child : {&a, &b}) {
      operators_.mutate(*child);
      if (brood_.size() == settings_.children) break;
      // If nearly all children are known already, accept a known one, or this would not end.
      if (in_vain < kTries && is_known(*child)) {
        ++in_vain;
      } else {
        brood_.push_back({std::move(*child)});
      }
    }
  }
}

/// The fitter of two.
const Genes& Evolution::choose() {
  const Individual& one = parents_[random_.below(parents_.size())];
  const Individual& other = parents_[random_.below(parents_.size())];
  return one.fitness >= other.fitness ? one.genes : other.genes;
}

}  // namespace jaywalk::search

// SPDX-License-Identifier: Apache-2.0
// Frenetic (Castellano, Cetinkaya, Ho Thanh, Klikovits, Zhang and Arcaini 2021, "Frenetic at the
// SBST 2021 tool competition"): sequences of curvatures evolve. First random ones; then, over and
// over, the best test that was not used yet is a parent: one that passed is mutated to explore, one
// that failed is mirrored, reversed and turned to exploit it; now and then two parents are crossed.
//
// Where the search space has vectors alone, the mutators that change the length, reverse or swap
// the sequence are left out, since its numbers mean different things.

#include <algorithm>
#include <array>
#include <deque>

#include "search/generator.h"

namespace jaywalk::search::generator::frenetic {
namespace {

enum Parameter : std::size_t { kInitial, kCrossoverEvery, kCandidates };

constexpr std::array kParameters = {
    NumberParameter{"initial", 60, 1, 1e6, "random tests at the beginning"},
    NumberParameter{"crossover_every", 40, 1, 1e6, "candidates between two crossovers"},
    NumberParameter{"crossover_candidates", 20, 5, 1e6, "the best tests that may be crossed"},
};

/// Parents lie farther than half a metre outside of their lane (oob_distance).
constexpr double kParentMargin = -0.5;
/// Frenetic's curvatures are at most 0.07 1/m, which is 1 here; neighbours differ by 0.05 at most.
constexpr double kScale = 0.07;
constexpr double kBound = 1;
constexpr double kDifference = 0.05 / kScale;
constexpr std::size_t kLeastParent = 11;
constexpr int kMostChanges = 5;
constexpr std::size_t kFewCandidates = 4;
/// Invalid candidates that are drawn before a valid random one is taken.
constexpr int kPatience = 1000;

enum class Kin { unvisited, visited };

struct Candidate {
  TestInput input;
  Kin kin = Kin::unvisited;
};

struct Individual {
  TestInput input;
  /// How far from failing: Frenetic's minimal oob_distance, or what stands for it.
  double margin = 0;
  bool failed = false;
  Kin kin = Kin::unvisited;
};

using Values = std::vector<double>;

class Frenetic : public Generator {
 public:
  explicit Frenetic(const GeneratorSetup& setup)
      : space_(setup.space),
        sequences_(setup.space.sequences()),
        margin_(find_measure(setup.measures, "min_oob_distance_m")),
        fails_at_(setup.fitness.fails_at),
        initial_(static_cast<std::size_t>(setup.values[kInitial])),
        crossover_every_(static_cast<std::size_t>(setup.values[kCrossoverEvery])),
        candidates_(static_cast<std::size_t>(setup.values[kCandidates])),
        random_(setup.seed) {}

  TestInput ask(Asking& asking) override {
    for (int i = 0; i < kPatience; ++i) {
      if (queue_.empty()) refill();
      if (queue_.empty()) continue;
      Candidate candidate = std::move(queue_.front());
      queue_.pop_front();
      // Roads that do not fit into the map are not candidates.
      if (space_.as_points(candidate.input).values.empty()) continue;
      if (candidate.input.form != Form::points) ++since_crossover_;
      if (!asking.valid(candidate.input)) continue;
      asked_ = candidate.kin;
      return candidate.input;
    }
    asked_ = Kin::unvisited;
    return draw_valid(asking, [&] { return random_input(); });
  }

  void tell(const ExecutedTest& test, double) override {
    double margin = fails_at_ / 2 - test.fitness;
    if (margin_ && test.outcome.executed()) margin = test.outcome.measures[*margin_];
    population_.push_back({test.input, margin, test.failed, asked_});
  }

 private:
  [[nodiscard]] double threshold() const { return margin_ ? kParentMargin : 0; }

  /// random.choice(numpy.linspace(low, high)): one of 50 values.
  double pick(double low, double high) {
    return low + (high - low) * random_.between(0, 49) / 49.0;
  }

  double next_value(double last, double bound, double difference) {
    return pick(std::max(-bound, last - difference), std::min(bound, last + difference));
  }

  TestInput random_input() {
    if (!sequences_) return space_.draw_initial(random_);
    const auto spread = static_cast<int>(sequences_->spread);
    const int length = static_cast<int>(sequences_->usual) + random_.between(-spread, spread);
    Values values;
    double last = 0;
    for (int i = 0; i < length; ++i) {
      last = next_value(last, kBound, kDifference);
      values.push_back(last);
    }
    return {Form::sequence, std::move(values)};
  }

  void refill() {
    if (population_.size() < initial_) {
      queue_.push_back({random_input(), Kin::unvisited});
      since_crossover_ = 0;
      return;
    }
    if (since_crossover_ >= crossover_every_) {
      since_crossover_ = 0;
      cross();
      if (!queue_.empty()) return;
    }
    Individual* parent = best_unvisited();
    if (parent == nullptr) {
      queue_.push_back({random_input(), Kin::unvisited});
      return;
    }
    parent->kin = Kin::visited;
    if (parent->failed) {
      exploit(*parent);
    } else {
      explore(*parent);
    }
  }

  Individual* best_unvisited() {
    Individual* best = nullptr;
    for (Individual& each : population_) {
      if (each.kin == Kin::visited || !(each.margin < threshold())) continue;
      if (best == nullptr || each.margin < best->margin) best = &each;
    }
    return best;
  }

  void push(const Individual& parent, Values values, Kin kin) {
    if (sequences_ && values.size() < sequences_->least) return;
    if (!sequences_) {
      for (double& value : values) value = std::clamp(value, -kBound, kBound);
    }
    queue_.push_back({{parent.input.form, std::move(values)}, kin});
  }

  /// Mutators of a test that failed: reversed points, reversed, split and swapped, negated values.
  void exploit(const Individual& parent) {
    const Values& values = parent.input.values;
    if (!sequences_) {
      Values negated = values;
      for (double& value : negated) value = -value;
      push(parent, std::move(negated), Kin::visited);
      return;
    }
    queue_.push_back({reversed_points(parent.input), Kin::visited});
    if (parent.input.form != Form::sequence || values.size() < kLeastParent) return;
    push(parent, Values(values.rbegin(), values.rend()), Kin::visited);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    Values swapped(middle, values.end());
    swapped.insert(swapped.end(), values.begin(), middle);
    push(parent, std::move(swapped), Kin::visited);
    Values negated = values;
    for (double& value : negated) value = -value;
    push(parent, std::move(negated), Kin::visited);
  }

  [[nodiscard]] TestInput reversed_points(const TestInput& input) const {
    TestInput points = space_.as_points(input);
    Values& xy = points.values;
    for (std::size_t i = 0, j = xy.size(); i + 2 < j; i += 2) {
      j -= 2;
      std::swap(xy[i], xy[j]);
      std::swap(xy[i + 1], xy[j + 1]);
    }
    return points;
  }

  /// Mutators of a test that passed: six of them.
  void explore(const Individual& parent) {
    const Values& values = parent.input.values;
    if (parent.input.form == Form::points) return;
    if (sequences_ && values.size() >= kLeastParent) {
      push(parent, appended(values), Kin::unvisited);
      push(parent, removed(values), Kin::unvisited);
      const std::ptrdiff_t front = random_.between(1, kMostChanges);
      push(parent, Values(values.begin() + front, values.end()), Kin::unvisited);
      const std::ptrdiff_t tail = random_.between(1, kMostChanges);
      push(parent, Values(values.begin(), values.end() - tail), Kin::unvisited);
    } else if (sequences_) {
      return;
    }
    Values scaled = values;
    const double factor = random_.uniform(1.1, 1.2);
    for (double& value : scaled) value *= factor;
    push(parent, std::move(scaled), Kin::unvisited);
    push(parent, changed(values), Kin::unvisited);
  }

  Values appended(Values values) {
    // From the last value of the parent, not of what was appended; bounds swapped: as in the code.
    const double last = values.back();
    for (int i = random_.between(1, kMostChanges); i > 0; --i) {
      values.push_back(next_value(last, 0.05 / kScale, 1));
    }
    return values;
  }

  Values removed(Values values) {
    for (int i = random_.between(1, kMostChanges); i > 0 && values.size() > kMostChanges; --i) {
      values.erase(values.begin() + static_cast<std::ptrdiff_t>(random_.below(values.size())));
    }
    return values;
  }

  Values changed(Values values) {
    std::vector<std::size_t> places(sequences_ ? values.size() - 1 : values.size());
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
    random_.shuffle(places);
    const auto count = static_cast<std::size_t>(random_.between(1, kMostChanges));
    for (std::size_t i = 0; i < std::min(count, places.size()); ++i) {
      values[places[i]] += pick(-kDifference, kDifference);
    }
    return values;
  }

  void cross() {
    std::vector<const Individual*> best;
    for (const Individual& each : population_) {
      if (each.input.form != Form::points && each.margin < threshold()) best.push_back(&each);
    }
    std::ranges::stable_sort(best, {}, &Individual::margin);
    if (best.size() > candidates_) best.resize(candidates_);
    if (best.size() <= kFewCandidates) return;
    for (std::size_t children = 0; children < best.size();) {
      const Individual& a = *best[random_.below(best.size())];
      const Individual& b = *best[random_.below(best.size())];
      if (&a == &b) continue;
      children += random_.coin() ? mix_genes(a, b) : mix_halves(a, b);
    }
  }

  /// Chromosome crossover: each value from either parent.
  std::size_t mix_genes(const Individual& a, const Individual& b) {
    Values child;
    for (std::size_t i = 0; i < std::min(a.input.values.size(), b.input.values.size()); ++i) {
      child.push_back((random_.coin() ? a : b).input.values[i]);
    }
    push(a, std::move(child), Kin::unvisited);
    return 1;
  }

  /// Single point crossover: the halves of the parents, exchanged.
  std::size_t mix_halves(const Individual& a, const Individual& b) {
    const auto half = [](const Values& values) {
      return values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    };
    const Values& va = a.input.values;
    const Values& vb = b.input.values;
    Values first(sequences_ ? half(vb) : vb.begin(), sequences_ ? vb.end() : half(vb));
    first.insert(first.end(), sequences_ ? va.begin() : half(va), sequences_ ? half(va) : va.end());
    Values second(sequences_ ? half(va) : va.begin(), sequences_ ? va.end() : half(va));
    second.insert(second.end(), sequences_ ? vb.begin() : half(vb),
                  sequences_ ? half(vb) : vb.end());
    push(a, std::move(first), Kin::unvisited);
    push(a, std::move(second), Kin::unvisited);
    return 2;
  }

  const SearchSpace& space_;
  std::optional<SequenceBounds> sequences_;
  std::optional<std::size_t> margin_;
  double fails_at_;
  std::size_t initial_;
  std::size_t crossover_every_;
  std::size_t candidates_;
  Random random_;
  std::vector<Individual> population_;
  std::deque<Candidate> queue_;
  Kin asked_ = Kin::unvisited;
  std::size_t since_crossover_ = 0;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<Frenetic>(setup);
}

}  // namespace jaywalk::search::generator::frenetic

// SPDX-License-Identifier: Apache-2.0
// Our own. What makes a test fail is mostly local: a stretch of a few curvatures, approached fast.
// Each failed sequence yields that stretch; new tests graft a stretch into fresh random
// surroundings, so that they fail again but differ from each other everywhere else. How often a
// stretch failed again decides how often it is used (Thompson 1933 sampling of its Beta
// distribution), and a stretch that hardly ever fits on the map counts as one that passed; tests
// that fail elsewhere or differently yield new stretches. Until one is known, near misses are
// varied, each a limited number of times, since some cannot be made to fail.
//
// In spaces of vectors alone the "stretch" is a random choice of a failed vector's coordinates.

#include <algorithm>
#include <array>
#include <cmath>

#include "search/generator.h"
#include "search/test_input.h"

namespace jaywalk::search::generator::graft {
namespace {

enum Parameter : std::size_t {
  kInitial,
  kExploration,
  kLeastStretch,
  kMostStretch,
  kTail,
  kMostLead,
  kJitter,
  kStretches,
  kAttempts,
};

constexpr std::array kParameters = {
    NumberParameter{"initial", 20, 1, 1e6, "random tests at the beginning"},
    NumberParameter{"exploration", 0.05, 0, 1, "share of random tests later"},
    NumberParameter{"least_stretch", 5, 1, 100, "values of a stretch before the failure"},
    NumberParameter{"most_stretch", 9, 1, 100, "values of a stretch before the failure"},
    NumberParameter{"tail", 3, 0, 100, "values after the failure"},
    NumberParameter{"most_lead", 14, 0, 100, "random values before a stretch, at most"},
    NumberParameter{"jitter", 0.05, 0, 1, "by which the values of a stretch are varied"},
    NumberParameter{"stretches", 40, 1, 10000, "that are kept: the best ones"},
    NumberParameter{"attempts", 200, 1, 100000, "invalid candidates before a random test"},
};

struct Stretch {
  std::vector<double> values;
  /// In a vector: which coordinates count.
  std::vector<bool> kept;
  double failures = 1;
  double uses = 1;
};

/// The cost of an invalid candidate to its stretch, in tests that passed.
constexpr double kInvalidCost = 0.02;

/// A test that did not fail: those near to failing are varied until one fails.
struct NearMiss {
  std::vector<double> values;
  double fitness = 0;
  int variations = 0;
};
constexpr int kMostVariations = 20;
constexpr std::size_t kNearMisses = 10;

class Graft : public Generator {
 public:
  explicit Graft(const GeneratorSetup& setup)
      : space_(setup.space),
        sequences_(setup.space.sequences()),
        where_(find_measure(setup.measures, "worst_arc_m")),
        values_(setup.values),
        random_(setup.seed) {}

  TestInput ask(Asking& asking) override {
    used_.reset();
    parent_.reset();
    ++asked_;
    const bool explores = asked_ <= static_cast<std::size_t>(values_[kInitial]) ||
                          random_.uniform(0, 1) < values_[kExploration];
    // If failing stretches do not fit, try near misses; if those do not either, a random road.
    const int attempts = static_cast<int>(values_[kAttempts]);
    for (int i = 0; i < attempts; ++i) {
      const bool grafts = !explores && !stretches_.empty() && i < attempts / 2;
      const bool varies = !explores && !grafts && i < attempts * 3 / 4;
      TestInput candidate = grafts ? grafted() : varies ? varied() : random_input();
      const bool fits = !space_.as_points(candidate).values.empty();
      if (fits && asking.valid(candidate)) return candidate;
      if (used_) stretches_[*used_].uses += kInvalidCost;
      used_.reset();
      parent_.reset();
    }
    return draw_valid(asking, [&] { return space_.draw_initial(random_); });
  }

  void tell(const ExecutedTest& test, double) override {
    if (used_) {
      stretches_[*used_].uses += 1;
      if (test.failed) stretches_[*used_].failures += 1;
    }
    if (!test.outcome.executed()) return;
    if (test.failed) {
      learn(test);
    } else if (test.input.form == natural_form()) {
      remember(test);
    }
  }

 private:
  [[nodiscard]] Form natural_form() const { return sequences_ ? Form::sequence : Form::vector; }

  TestInput random_input() {
    if (sequences_) return draw_sequence(*sequences_, random_);
    TestInput input{Form::vector, std::vector<double>(space_.dimension())};
    for (double& value : input.values) value = random_.uniform(-1, 1);
    return input;
  }

  [[nodiscard]] double jittered(double value) {
    const double jitter = values_[kJitter];
    return std::clamp(value + random_.uniform(-jitter, jitter), -1.0, 1.0);
  }

  /// Keeps the nearest misses, the nearest first. A variation counts if it is nearer than its
  /// parent: the surroundings of one that cannot be made to fail are soon left alone.
  void remember(const ExecutedTest& test) {
    if (parent_ && test.fitness <= *parent_) return;
    const auto place = std::ranges::find_if(
        near_misses_, [&](const NearMiss& each) { return each.fitness < test.fitness; });
    near_misses_.insert(place, {test.input.values, test.fitness});
    if (near_misses_.size() > kNearMisses) near_misses_.pop_back();
  }

  /// The nearest miss that was not yet varied often, with some of its values changed.
  TestInput varied() {
    const auto miss = std::ranges::find_if(
        near_misses_, [](const NearMiss& each) { return each.variations < kMostVariations; });
    if (miss == near_misses_.end()) {
      near_misses_.clear();
      return random_input();
    }
    ++miss->variations;
    parent_ = miss->fitness;
    TestInput input{natural_form(), miss->values};
    const int changes = random_.between(1, 4);
    for (int i = 0; i < changes; ++i) {
      double& value = input.values[random_.below(input.values.size())];
      value = std::clamp(value + random_.uniform(-kMostDifference, kMostDifference), -1.0, 1.0);
    }
    return input;
  }

  /// A stretch by the estimate of how often it makes tests fail.
  std::size_t choose() {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      const Stretch& stretch = stretches_[i];
      const double mean = stretch.failures / (stretch.uses + 1);
      const double deviation = std::sqrt(mean * (1 - mean) / (stretch.uses + 2));
      // The sum of three uniform numbers is nearly normal.
      const double normal =
          random_.uniform(-1, 1) + random_.uniform(-1, 1) + random_.uniform(-1, 1);
      if (mean + deviation * normal > most) {
        most = mean + deviation * normal;
        best = i;
      }
    }
    return best;
  }

  TestInput grafted() {
    used_ = choose();
    const Stretch& stretch = stretches_[*used_];
    TestInput input{natural_form(), {}};
    if (!sequences_) {
      for (std::size_t i = 0; i < stretch.values.size(); ++i) {
        input.values.push_back(stretch.kept[i] ? jittered(stretch.values[i])
                                               : random_.uniform(-1, 1));
      }
      return input;
    }
    append_random(input.values, random_.between(0, static_cast<int>(values_[kMostLead])), random_);
    for (const double value : stretch.values) input.values.push_back(jittered(value));
    append_random(input.values, random_.between(1, 3), random_);
    return input;
  }

  void learn(const ExecutedTest& test) {
    if (test.input.form != natural_form()) return;
    Stretch stretch = sequences_ ? cut(test) : choose_coordinates(test);
    if (stretch.values.empty()) return;
    if (stretches_.size() >= static_cast<std::size_t>(values_[kStretches])) {
      const auto worst = std::ranges::min_element(
          stretches_, {}, [](const Stretch& each) { return each.failures / (each.uses + 1); });
      *worst = std::move(stretch);
    } else {
      stretches_.push_back(std::move(stretch));
    }
  }

  Stretch cut(const ExecutedTest& test) {
    const std::vector<double>& values = test.input.values;
    std::size_t at = values.size();
    if (where_)
      at = static_cast<std::size_t>(test.outcome.measures[*where_] / sequences_->element_m);
    const std::size_t end = std::min(values.size(), at + static_cast<std::size_t>(values_[kTail]));
    const int most =
        std::max(static_cast<int>(values_[kMostStretch]), static_cast<int>(values_[kLeastStretch]));
    const auto length =
        static_cast<std::size_t>(random_.between(static_cast<int>(values_[kLeastStretch]), most) +
                                 static_cast<int>(values_[kTail]));
    const std::size_t begin = end > length ? end - length : 0;
    return {.values = {values.begin() + static_cast<std::ptrdiff_t>(begin),
                       values.begin() + static_cast<std::ptrdiff_t>(end)}};
  }

  Stretch choose_coordinates(const ExecutedTest& test) {
    Stretch stretch{.values = test.input.values};
    for (std::size_t i = 0; i < stretch.values.size(); ++i) stretch.kept.push_back(random_.coin());
    return stretch;
  }

  const SearchSpace& space_;
  std::optional<SequenceBounds> sequences_;
  std::optional<std::size_t> where_;
  std::span<const double> values_;
  Random random_;
  std::vector<Stretch> stretches_;
  std::vector<NearMiss> near_misses_;
  /// Fitness of the near miss that was varied, if one was.
  std::optional<double> parent_;
  std::optional<std::size_t> used_;
  std::size_t asked_ = 0;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<Graft>(setup);
}

}  // namespace jaywalk::search::generator::graft

// SPDX-License-Identifier: Apache-2.0
// WOGAN (Peltomäki, Spencer and Porres 2022, "Wasserstein generative adversarial networks for
// online test generation for cyber physical systems"): a Wasserstein generator learns the
// distribution of the tests executed so far, biased towards those of high fitness; an analyzer
// predicts fitness and picks among what the generator makes. Algorithm 1 and section 3.1; where
// text and the code that made the published numbers differ, the code is followed, and the text is a
// variant (see the parameters).

#include <algorithm>
#include <array>
#include <cmath>

#include "search/generator.h"
#include "search/generators/acceptance.h"

namespace jaywalk::search::generator::wogan {
namespace {

enum Parameter : std::size_t {
  kInitial,
  kBatchNorm,
  kCriticSlope,
  kTrainDelay,
  kEpochs,
  kAnalyzerSteps,
  kFirstAnalyzerSteps,
  kRate,
  kAnalyzerRate,
  kRegularisation,
  kBins,
  kBatch,
  kShiftStart,
  kShiftEnd,
  kShiftSign,
  kReducer,
  kPatience,
};

constexpr std::array kParameters = {
    NumberParameter{"initial", 60, 2, 1e6, "random tests at the beginning (N in algorithm 1)"},
    NumberParameter{"batch_norm", 1, 0, 1,
                    "batch normalisation of the output; 0: the paper's text"},
    NumberParameter{"critic_slope", 0.1, 0, 1, "of its leaky units; 0: the paper's text"},
    NumberParameter{"train_delay", 3, 1, 1e6, "tests between two trainings; 1: the paper's text"},
    NumberParameter{"epochs", 3, 1, 1e4, "of the Wasserstein pair in each training"},
    NumberParameter{"analyzer_steps", 10, 1, 1e4, "in each training"},
    NumberParameter{"first_analyzer_steps", 20, 1, 1e4, "in the first training"},
    NumberParameter{"rate", 5e-5, 1e-9, 1, "of the Wasserstein pair's optimisers"},
    NumberParameter{"analyzer_rate", 1e-3, 1e-9, 1, "of the analyzer's optimiser"},
    NumberParameter{"regularisation", 0.01, 0, 1, "of the analyzer"},
    NumberParameter{"bins", 10, 1, 1000, "of fitness (B)"},
    NumberParameter{"batch", 32, 2, 10000, "tests in a batch (M)"},
    NumberParameter{"shift_start", 0, -100, 100, "of the bins' weights, at the first training"},
    NumberParameter{"shift_end", 3, -100, 100, "of the bins' weights, at the end of the budget"},
    NumberParameter{"shift_sign", -1, -1, 1, "-1 as in the code; 1: the paper's text"},
    NumberParameter{"reducer", 0.95, 0.01, 0.9999, "by which the target shrinks"},
    NumberParameter{"patience", 20000, 1, 1e6, "invalid candidates before a random test"},
};

constexpr int kCriticSteps = 5;
constexpr Eigen::Index kAnalyzerUnits = 32;

learn::WassersteinSettings pair_settings(const GeneratorSetup& setup) {
  learn::WassersteinSettings settings;
  settings.dimension = static_cast<Eigen::Index>(setup.space.dimension());
  settings.critic_slope = static_cast<float>(setup.values[kCriticSlope]);
  settings.rate = static_cast<float>(setup.values[kRate]);
  settings.normalisation = setup.values[kBatchNorm] > 0.5 ? learn::TestMaker::Normalisation::batch
                                                          : learn::TestMaker::Normalisation::none;
  return settings;
}

learn::AnalyzerSettings analyzer_settings(const GeneratorSetup& setup) {
  return {.shape = {.inputs = static_cast<Eigen::Index>(setup.space.dimension()),
                    .hidden = kAnalyzerUnits,
                    .outputs = 1},
          .adam = {.rate = static_cast<float>(setup.values[kAnalyzerRate])},
          .regularisation = static_cast<float>(setup.values[kRegularisation])};
}

/// Tests by fitness. The weight of a bin is S(x + sign * shift), S the logistic function and x the
/// bin's middle less 0.5 (section 3.1, "Sampling").
class Bins {
 public:
  Bins(const Examples& examples, std::size_t count) : members_(count) {
    for (std::size_t i = 0; i < examples.size(); ++i) {
      members_[bin(examples.fitness[i])].push_back(i);
    }
  }

  [[nodiscard]] std::size_t bin(double fitness) const {
    const auto count = static_cast<double>(members_.size());
    return std::min(members_.size() - 1, static_cast<std::size_t>(std::max(0.0, fitness * count)));
  }

  [[nodiscard]] std::size_t draw(double shift, Random& random) const {
    std::vector<double> weights;
    double sum = 0;
    const auto count = static_cast<double>(members_.size());
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const double x = (static_cast<double>(i) + 0.5) / count - 0.5;
      weights.push_back(1 / (1 + std::exp(-(x + shift))));
      sum += weights.back();
    }
    double rest = random.uniform(0, sum);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      rest -= weights[i];
      if (rest < 0) return i;
    }
    return weights.size() - 1;
  }

  /// Takes a test out of the bin or, where that is empty, out of the next lower one that is not,
  /// beginning again at the top.
  std::size_t take(std::size_t bin, Random& random) {
    while (members_[bin].empty()) bin = (bin + members_.size() - 1) % members_.size();
    std::vector<std::size_t>& from = members_[bin];
    const std::size_t place = random.below(from.size());
    const std::size_t test = from[place];
    from.erase(from.begin() + static_cast<std::ptrdiff_t>(place));
    return test;
  }

 private:
  std::vector<std::vector<std::size_t>> members_;
};

class Wogan : public Generator {
 public:
  explicit Wogan(const GeneratorSetup& setup)
      : space_(setup.space),
        values_(setup.values),
        initial_(static_cast<std::size_t>(setup.values[kInitial])),
        random_(setup.seed),
        pair_(pair_settings(setup), random_),
        analyzer_(analyzer_settings(setup), random_) {}

  TestInput ask(Asking& asking) override {
    const auto draw = [&] { return space_.draw_initial(random_); };
    if (examples_.size() < initial_) return draw_valid(asking, draw);
    const AcceptanceSettings acceptance{values_[kReducer], static_cast<int>(values_[kPatience])};
    auto test =
        accept_candidate(asking, analyzer_, acceptance, [&] { return pair_.make(1, random_); });
    return test ? std::move(*test) : draw_valid(asking, draw);
  }

  void tell(const ExecutedTest& test, double spent) override {
    examples_.add(test);
    if (examples_.size() < initial_) return;
    if (examples_.size() == initial_) {
      began_at_ = spent;
      train(When::first, spent);
    } else if ((examples_.size() - initial_) % delay() == 0) {
      train(When::later, spent);
    }
  }

 private:
  enum class When { first, later };

  [[nodiscard]] std::size_t delay() const { return static_cast<std::size_t>(values_[kTrainDelay]); }

  /// Grows from the first training to the end of the budget.
  [[nodiscard]] double shift(double spent) const {
    const double part =
        began_at_ < 1 ? std::clamp((spent - began_at_) / (1 - began_at_), 0.0, 1.0) : 1;
    return values_[kShiftSign] *
           (values_[kShiftStart] + (values_[kShiftEnd] - values_[kShiftStart]) * part);
  }

  void train(When when, double spent) {
    const learn::Matrix inputs = examples_.inputs();
    const learn::Matrix outputs = examples_.outputs();
    const auto steps =
        static_cast<int>(values_[when == When::first ? kFirstAnalyzerSteps : kAnalyzerSteps]);
    for (int i = 0; i < steps; ++i) analyzer_.train(inputs, outputs);
    for (int epoch = 0; epoch < static_cast<int>(values_[kEpochs]); ++epoch) {
      const std::vector<std::size_t> chosen = batch(when, shift(spent));
      learn::Matrix real(inputs.rows(), static_cast<Eigen::Index>(chosen.size()));
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        real.col(static_cast<Eigen::Index>(i)) = inputs.col(static_cast<Eigen::Index>(chosen[i]));
      }
      for (int i = 0; i < kCriticSteps; ++i) pair_.train_critic(real, random_);
      pair_.train_maker(real.cols(), random_);
    }
  }

  /// The newest tests where their bins are at least as high as drawn ones, then tests of drawn
  /// bins.
  std::vector<std::size_t> batch(When when, double shift) {
    const std::size_t size = std::min(static_cast<std::size_t>(values_[kBatch]), initial_);
    Bins bins(examples_, static_cast<std::size_t>(values_[kBins]));
    std::vector<std::size_t> chosen;
    if (when == When::later) {
      for (std::size_t i = 0; i < delay(); ++i) {
        const std::size_t test = examples_.size() - 1 - i;
        if (bins.bin(examples_.fitness[test]) >= bins.draw(shift, random_)) chosen.push_back(test);
      }
    }
    while (chosen.size() < size) chosen.push_back(bins.take(bins.draw(shift, random_), random_));
    return chosen;
  }

  const SearchSpace& space_;
  std::span<const double> values_;
  std::size_t initial_;
  Random random_;
  learn::WassersteinPair pair_;
  learn::Analyzer analyzer_;
  Examples examples_;
  double began_at_ = 0;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<Wogan>(setup);
}

}  // namespace jaywalk::search::generator::wogan

// SPDX-License-Identifier: Apache-2.0
// OGAN (Porres, Rexha and Lafond 2021, "Online GANs for automatic performance testing"; with the
// settings of the road experiments' code): a discriminator learns to predict fitness, a generator
// to make tests that the discriminator takes for the worst. Both train after every test.

#include <array>

#include "search/generator.h"
#include "search/generators/acceptance.h"

namespace jaywalk::search::generator::ogan {
namespace {

enum Parameter : std::size_t { kInitial, kNoise, kHidden, kRate, kReducer, kPatience };

constexpr std::array kParameters = {
    NumberParameter{"initial", 60, 1, 1e6, "random tests at the beginning"},
    NumberParameter{"noise", 100, 1, 10000, "inputs of the generator"},
    NumberParameter{"hidden", 128, 1, 10000, "units of each hidden layer"},
    NumberParameter{"rate", 1e-3, 1e-9, 1, "of both optimisers"},
    NumberParameter{"reducer", 0.95, 0.01, 0.9999, "by which the target shrinks"},
    NumberParameter{"patience", 100, 1, 1e6, "invalid candidates before a random test"},
};

constexpr Eigen::Index kBatch = 10;
constexpr float kSlope = 0.1F;
/// Rounds and discriminator steps in each, the first time and later.
constexpr int kFirstRounds = 2;
constexpr int kFirstSteps = 20;
constexpr int kLaterSteps = 5;

learn::AdamSettings adam(const GeneratorSetup& setup) {
  return {.rate = static_cast<float>(setup.values[kRate]), .beta1 = 0.9F, .beta2 = 0.999F};
}

class Ogan : public Generator {
 public:
  explicit Ogan(const GeneratorSetup& setup)
      : space_(setup.space),
        values_(setup.values),
        initial_(static_cast<std::size_t>(setup.values[kInitial])),
        random_(setup.seed),
        maker_({.inputs = noise_size(),
                .hidden = static_cast<Eigen::Index>(values_[kHidden]),
                .outputs = static_cast<Eigen::Index>(space_.dimension())},
               learn::TestMaker::Normalisation::none, random_),
        discriminator_({.shape = {.inputs = static_cast<Eigen::Index>(space_.dimension()),
                                  .hidden = static_cast<Eigen::Index>(values_[kHidden]),
                                  .outputs = 1,
                                  .slope = kSlope},
                        .adam = adam(setup)},
                       random_),
        optimiser_(adam(setup)) {
    maker_.add_to(optimiser_);
  }

  TestInput ask(Asking& asking) override {
    const auto draw = [&] { return space_.draw_initial(random_); };
    if (examples_.size() < initial_) return draw_valid(asking, draw);
    const AcceptanceSettings acceptance{values_[kReducer], static_cast<int>(values_[kPatience])};
    auto test = accept_candidate(asking, discriminator_, acceptance, [&] {
      return maker_.forward(learn::noise(noise_size(), 1, random_), learn::Pass::generating);
    });
    return test ? std::move(*test) : draw_valid(asking, draw);
  }

  void tell(const ExecutedTest& test, double) override {
    examples_.add(test);
    if (examples_.size() < initial_) return;
    const bool first = examples_.size() == initial_;
    for (int round = 0; round < (first ? kFirstRounds : 1); ++round) {
      train(first ? kFirstSteps : kLaterSteps);
    }
  }

 private:
  [[nodiscard]] Eigen::Index noise_size() const {
    return static_cast<Eigen::Index>(values_[kNoise]);
  }

  void train(int steps) {
    const learn::Matrix inputs = examples_.inputs();
    const learn::Matrix outputs = examples_.outputs();
    for (int i = 0; i < steps; ++i) discriminator_.train(inputs, outputs);
    const learn::Matrix made =
        maker_.forward(learn::noise(noise_size(), kBatch, random_), learn::Pass::training);
    maker_.backward(discriminator_.input_gradient(made, learn::Matrix::Ones(1, kBatch)));
    optimiser_.step();
  }

  const SearchSpace& space_;
  std::span<const double> values_;
  std::size_t initial_;
  Random random_;
  learn::TestMaker maker_;
  learn::Analyzer discriminator_;
  learn::Adam optimiser_;
  Examples examples_;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<Ogan>(setup);
}

}  // namespace jaywalk::search::generator::ogan

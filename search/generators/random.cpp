// SPDX-License-Identifier: Apache-2.0
// Independent uniform vectors (Peltomäki et al. 2022, section 3.2, "Random"), as long as it takes
// to find a valid one.

#include "search/generator.h"

namespace jaywalk::search::generator::random {
namespace {

class UniformVectors : public Generator {
 public:
  explicit UniformVectors(const GeneratorSetup& setup)
      : dimension_(setup.space.dimension()), random_(setup.seed) {}

  TestInput ask(Asking& asking) override {
    return draw_valid(asking, [&] {
      TestInput input{Form::vector, std::vector<double>(dimension_)};
      for (double& value : input.values) value = random_.uniform(-1, 1);
      return input;
    });
  }
  void tell(const ExecutedTest&, double) override {}

 private:
  std::size_t dimension_;
  Random random_;
};

}  // namespace

std::span<const NumberParameter> parameters() { return {}; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<UniformVectors>(setup);
}

}  // namespace jaywalk::search::generator::random

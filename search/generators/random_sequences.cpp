// SPDX-License-Identifier: Apache-2.0
// The baseline of generators that make sequences (`frenetic`, `graft`): independent random ones, as
// long as theirs, without any feedback. Where the search space has vectors alone, it draws what
// generators that learn begin with.

#include "search/generator.h"
#include "search/test_input.h"

namespace jaywalk::search::generator::random_sequences {
namespace {

class RandomSequences : public Generator {
 public:
  explicit RandomSequences(const GeneratorSetup& setup)
      : space_(setup.space), sequences_(setup.space.sequences()), random_(setup.seed) {}

  TestInput ask(Asking& asking) override {
    return draw_valid(asking, [&] {
      return sequences_ ? draw_sequence(*sequences_, random_) : space_.draw_initial(random_);
    });
  }
  void tell(const ExecutedTest&, double) override {}

 private:
  const SearchSpace& space_;
  std::optional<SequenceBounds> sequences_;
  Random random_;
};

}  // namespace

std::span<const NumberParameter> parameters() { return {}; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<RandomSequences>(setup);
}

}  // namespace jaywalk::search::generator::random_sequences

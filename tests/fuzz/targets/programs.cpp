// SPDX-License-Identifier: Apache-2.0
// Programs that were generated or are of the corpus, with some bytes changed.

#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::programs {
namespace {

std::string program_of(Choices& choices) {
  static const Texts kCorpus = corpus("programs");
  const std::string& seed = one_of(choices, kCorpus);
  switch (choices.below(4)) {
    case 0:
      return test::mutate(choices, seed, one_of(choices, kCorpus));
    case 1:
      return test::mutate(choices, test::random_program(choices), seed);
    default:
      return test::random_program(choices);
  }
}

}  // namespace

Case make(Choices& choices) {
  const std::string program = program_of(choices);
  return {.files = {{"agent.asl", program}, {"other.asl", program}},
          .agents = {"agent.asl", "other.asl"},
          .commands = {},
          .input = {}};
}

}  // namespace jaywalk::fuzz::target::programs

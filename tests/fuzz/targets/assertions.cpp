// SPDX-License-Identifier: Apache-2.0
// Files of assertions with odd values and runs of each other's tokens in their expressions.

#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::assertions {

Case make(Choices& choices) {
  static const Texts kCorpus = corpus("assertions");
  static const auto kWalker = walker_files();
  const std::string& donor = one_of(choices, kCorpus);
  const std::string& host = one_of(choices, kCorpus);
  const std::string rules =
      choices.once_in(2) ? splice(choices, host, donor) : spoil_yaml(choices, host, donor);
  Case made;
  made.files = kWalker;
  made.files["rules.yaml"] = rules;
  made.files["scenario.yaml"] = "behaviours: [walker.asl]\nassertions: rules.yaml\n";
  made.commands = {{"check", "scenario.yaml"},
                   {"run", "scenario.yaml", "--agents", "2", "--no-check", "--metrics"}};
  return made;
}

}  // namespace jaywalk::fuzz::target::assertions

// SPDX-License-Identifier: Apache-2.0
// Tables of drives from elsewhere, with odd values and rows that are missing or doubled.

#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::drives {

Case make(Choices& choices) {
  static const Texts kCorpus = corpus("drives");
  static const std::string kRules = project_text("scenarios/assertions/crossing.yaml");
  const std::string& donor = one_of(choices, kCorpus);
  const std::string drive = spoil_yaml(choices, one_of(choices, kCorpus), donor);
  return {.files = {{"drive.csv", drive}, {"rules.yaml", kRules}},
          .agents = {},
          .commands = {{"judge", "--trace", "drive.csv", "--metrics", "--assertions", "rules.yaml",
                        "--json", "out.json"}},
          .input = {}};
}

}  // namespace jaywalk::fuzz::target::drives

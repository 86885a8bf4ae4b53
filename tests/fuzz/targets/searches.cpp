// SPDX-License-Identifier: Apache-2.0
// Experiments of searches with odd values; what is still one searches for a few tests.

#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::searches {

Case make(Choices& choices) {
  static const Texts kCorpus = corpus("searches");
  static const std::string kProgram = project_text("agents/crossing/scripted.asl");
  Case made;
  made.files = walker_files();
  made.files["search.yaml"] =
      spoil_yaml(choices, one_of(choices, kCorpus), one_of(choices, kCorpus));
  made.files["scenario.yaml"] = "behaviours: [scripted.asl]\n";
  made.files["scripted.asl"] = kProgram;
  made.commands = {{"search", "search.yaml", "--set", "budget.tests=3", "--set",
                    "budget.virtual_s=0", "--repetitions", "1", "--threads", "1", "--quiet",
                    "--report", "page.html", "--export", "failures"}};
  return made;
}

}  // namespace jaywalk::fuzz::target::searches

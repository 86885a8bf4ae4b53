// SPDX-License-Identifier: Apache-2.0
// Scenarios with odd values: read by `check`; what is still one is run for some ticks.

#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::scenarios {

Case make(Choices& choices) {
  static const Texts kCorpus = corpus("scenarios");
  static const auto kWalker = walker_files();
  static const std::string kSignal = project_text("agents/crossing/signal.asl");
  static const std::string kRules = project_text("scenarios/assertions/crossing.yaml");
  Case made;
  made.files = kWalker;
  made.files["scenario.yaml"] =
      spoil_yaml(choices, one_of(choices, kCorpus), one_of(choices, kCorpus));
  made.files["signal.asl"] = kSignal;
  made.files["rules.yaml"] = kRules;
  made.files["starts.csv"] = "test,agent,row,cell\n0,1,1,5\n0,2,0,9\n";
  made.commands = {{"check", "scenario.yaml"},
                   {"run", "scenario.yaml", "--agents", "2", "--max-ticks", "5", "--no-check"}};
  if (choices.once_in(4)) {
    made.commands.push_back({"compare", "scenario.yaml", "--agents", "1,2", "--tests", "2",
                             "--threads", "1", "--quiet", "--report", "page.html", "--metrics",
                             "--set", "world.time_limit=5"});
  }
  return made;
}

}  // namespace jaywalk::fuzz::target::scenarios

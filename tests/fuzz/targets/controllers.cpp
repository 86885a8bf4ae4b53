// SPDX-License-Identifier: Apache-2.0
// An external AV whose answers are spoilt.

#include "tests/fuzz/answers.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::controllers {
namespace {

constexpr std::size_t kAnswers = 12;

/// Well-formed answers, of which some repeat the step.
std::vector<std::string> answers_of(Choices& choices) {
  std::vector<std::string> answers;
  const bool repeats = choices.once_in(2);
  for (std::size_t i = 0; i < kAnswers; ++i) {
    std::string answer = repeats ? "{\"step\":" + std::to_string(i) + "," : "{";
    answer += "\"acceleration\":";
    answer += choices.one_of({"-8", "-2", "0", "2", "1e308", "-1e308", "1e999", "-0.0", "1e-320",
                              "2147483648", "null", "\"1\"", "[1]"});
    answers.push_back(answer + "}\n");
  }
  return answers;
}

}  // namespace

Case make(Choices& choices) {
  static const auto kWalker = walker_files();
  const std::string process = choices.once_in(2) ? "kept" : "test";
  const auto answers = spoil_answers(choices, answers_of(choices));
  Case made;
  made.files = kWalker;
  made.files["scenario.yaml"] =
      "world:\n  tick: 0.5\n  length: 30\n  road_end: 29\n  time_limit: 5\n"
      "  av: {model: external, command: [sh, av.sh], process: " +
      process + ", speed_mps: 9}\nbehaviours: [walker.asl]\n";
  made.files["av.sh"] = answering_script(answers, R"({"end")");
  made.commands = {{"run", "scenario.yaml", "--agents", "2", "--no-check", "--metrics"}};
  return made;
}

}  // namespace jaywalk::fuzz::target::controllers

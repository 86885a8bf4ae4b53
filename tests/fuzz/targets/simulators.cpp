// SPDX-License-Identifier: Apache-2.0
// A simulator whose answers are spoilt.

#include "tests/fuzz/answers.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::simulators {
namespace {

constexpr std::size_t kSteps = 10;

std::string number(Choices& choices) {
  return std::string(choices.one_of({"6", "0", "9", "-1", "1e308", "-1e308", "1e999", "-0.0",
                                     "1e-320", "2147483648", "null", "\"1\"", "[1]", "{}"}));
}

/// Well-formed answers to `hello`, `reset` and steps, with some numbers that are none.
std::vector<std::string> answers_of(Choices& choices) {
  std::vector<std::string> answers{
      R"({"step":0,"protocol":1,"name":"fuzz","version":"1","deterministic":true})"
      "\n"};
  const bool has_traffic = choices.once_in(2);
  for (std::size_t step = 0; step < kSteps; ++step) {
    const auto some = [&](const std::string& usual) {
      return choices.once_in(12) ? number(choices) : usual;
    };
    const double y_m = -0.75 + 9 * 0.25 * static_cast<double>(step);
    std::string answer = R"({"test":)" + some("0") + R"(,"step":)" + std::to_string(step) +
                         R"(,"time":)" + some(std::to_string(0.25 * static_cast<double>(step))) +
                         R"(,"av":{"x":)" + some("6") + R"(,"y":)" + some(std::to_string(y_m)) +
                         R"(,"heading":)" + some("1.5707963") + R"(,"speed":)" + some("9") + "}";
    if (has_traffic) {
      answer += R"(,"traffic":[{"name":"a","kind":"vehicle","length":)" + some("4") +
                R"(,"width":)" + some("2") + R"(,"x":)" + some("12") + R"(,"y":)" + some("50") +
                R"(,"heading":)" + some("0") + R"(,"speed":)" + some("0") + R"(,"present":)" +
                some("true") + "}]";
    }
    if (choices.once_in(4)) answer += R"(,"contacts":[)" + some("0") + "]";
    answers.push_back(answer + "}\n");
  }
  return answers;
}

}  // namespace

Case make(Choices& choices) {
  static const auto kWalker = walker_files();
  const auto answers = spoil_answers(choices, answers_of(choices));
  Case made;
  made.files = kWalker;
  made.files["scenario.yaml"] =
      "world:\n  tick: 0.5\n  length: 30\n  road_end: 29\n  time_limit: 3\n  until: road_end\n"
      "  simulator: {name: process, command: [sh, simulator.sh], step: 0.25, timeout: 1,\n"
      "    start_timeout: 1}\n"
      "  av: {speed_mps: 9}\nbehaviours: [walker.asl]\n";
  made.files["simulator.sh"] = answering_script(answers, R"({"type":"bye")");
  made.commands = {{"run", "scenario.yaml", "--agents", "2", "--no-check", "--metrics"}};
  return made;
}

}  // namespace jaywalk::fuzz::target::simulators

// SPDX-License-Identifier: Apache-2.0
// An external system under test whose answers are spoilt.

#include "tests/fuzz/answers.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::suts {
namespace {

constexpr std::size_t kAnswers = 5;

std::vector<std::string> answers_of(Choices& choices) {
  std::vector<std::string> answers;
  for (std::size_t i = 0; i < kAnswers; ++i) {
    std::string answer = "{";
    if (choices.once_in(2)) answer += "\"test\":" + std::to_string(i) + ",";
    answer += "\"max_oob\":";
    answer += choices.one_of({"0.4", "1", "-1", "1e308", "1e999", "null"});
    answer += ",\"sim_time\":";
    answer += choices.one_of({"11.7", "0", "-1", "1e308", "1e999"});
    answers.push_back(answer + "}\n");
  }
  return answers;
}

}  // namespace

Case make(Choices& choices) {
  const auto answers = spoil_answers(choices, answers_of(choices));
  return {
      .files = {{"search.yaml",
                 "sut: {kind: external, command: [sh, sut.sh], timeout_s: 1, measures: [max_oob]}\n"
                 "fitness: {measure: max_oob, fails_at: 0.95}\n"
                 "budget: {tests: 4, virtual_s: 0}\ngenerators: [random]\nrepetitions: 1\n"},
                {"sut.sh", answering_script(answers, "-")}},
      .agents = {},
      .commands = {{"search", "search.yaml", "--threads", "1", "--quiet", "--report", "page.html",
                    "--json", "out.json"}},
      .input = {}};
}

}  // namespace jaywalk::fuzz::target::suts

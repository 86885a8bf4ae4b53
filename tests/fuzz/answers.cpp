// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/answers.h"

#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz {
namespace {

/// As `printf %b` writes it: every byte that is not plain as \0 and octal digits.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 0x7E || byte < ' ' || c == '\\' || c == '\'') {
      result += "\\0";
      for (const unsigned shift : {6U, 3U, 0U})
        result += static_cast<char>('0' + ((byte >> shift) & 7U));
    } else {
      result += c;
    }
  }
  return result;
}

std::string spoilt(Choices& choices, const std::string& answer) {
  switch (choices.below(8)) {
    case 0:
      return answer + answer;
    case 1:
      return "";
    case 2:
      return std::string(
          choices.one_of({"\n", "\r\n", "{}\n", "[]\n", "null\n", "nan\n", "\xFF\n"}));
    case 3:
      return std::string(5000, '[') + "\n";
    case 4:
      return answer.substr(0, choices.below(answer.size() + 1));
    case 5:
      return test::mutate(choices, answer, answer);
    default:
      return spoil_json(choices, answer) + "\n";
  }
}

}  // namespace

std::vector<std::string> spoil_answers(Choices& choices, std::vector<std::string> answers) {
  const std::size_t times = 1 + choices.below(3);
  for (std::size_t i = 0; i < times; ++i) {
    std::string& answer = answers[choices.below(answers.size())];
    answer = spoilt(choices, answer);
  }
  return answers;
}

std::string answering_script(const std::vector<std::string>& answers, std::string_view unanswered) {
  std::string script = "question() {\n  while read -r line; do\n    case $line in '" +
                       std::string(unanswered) + "'*) ;; *) return ;; esac\n  done\n  exit\n}\n";
  for (const std::string& answer : answers) {
    script += "question; printf '%b' '" + escaped(answer) + "'\n";
    // Nobody waits for the rest of a line that never comes.
    if (!answer.ends_with('\n')) script += "exit\n";
  }
  return script;
}

}  // namespace jaywalk::fuzz

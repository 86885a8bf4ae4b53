// SPDX-License-Identifier: Apache-2.0
// Lines for the REPL, of its sessions and of programs.

#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::repl {

Case make(Choices& choices) {
  static const Texts kCorpus = corpus("repl");
  static const std::string kProgram = project_text("tests/golden/cli/files/repl.asl");
  const std::string& donor = choices.once_in(2) ? one_of(choices, kCorpus) : kProgram;
  std::string input = splice(choices, one_of(choices, kCorpus), donor);
  if (choices.once_in(2)) input = test::mutate(choices, input, donor);
  return {.files = {{"agent.asl", kProgram}},
          .agents = {},
          .commands = {{"repl", "agent.asl"}},
          .input = input};
}

}  // namespace jaywalk::fuzz::target::repl

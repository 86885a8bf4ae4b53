// SPDX-License-Identifier: Apache-2.0
// Projects with odd values, doubled parts and runs of each other's tokens.

#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::projects {

Case make(Choices& choices) {
  static const Texts kCorpus = corpus("projects");
  const std::string& donor = one_of(choices, kCorpus);
  std::string project = splice(choices, one_of(choices, kCorpus), donor);
  if (choices.once_in(2)) project = test::mutate(choices, project, donor);
  return {.files = {{"project.mas2j", project},
                    {"ping.asl", "!go. +!go <- .send(pong,tell,ball); .print(go).\n"},
                    {"pong.asl", "+ball[source(S)] <- .send(S,achieve,go).\n"}},
          .agents = {},
          .commands = {{"check", "project.mas2j"},
                       {"run", "project.mas2j", "--max-cycles", "50", "--ignore-java"}},
          .input = {}};
}

}  // namespace jaywalk::fuzz::target::projects

// SPDX-License-Identifier: Apache-2.0
// The project's own programs with runs of each other's tokens: most of what comes out compiles.

#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::splices {
namespace {

constexpr std::size_t kLongestProgram = 1U << 15U;

Texts real_programs() {
  Texts texts;
  for (const std::string_view folder :
       {"agents", "tests/conformance", "tests/golden", "tests/fuzz/corpus"}) {
    for (std::string& text : project_texts(folder, ".asl")) {
      if (text.size() < kLongestProgram) texts.push_back(std::move(text));
    }
  }
  return texts;
}

}  // namespace

Case make(Choices& choices) {
  static const Texts kPrograms = real_programs();
  static const Texts kPedestrians = project_texts("agents/crossing", ".asl");
  const bool crosses = choices.once_in(3);
  const std::string& host = one_of(choices, crosses ? kPedestrians : kPrograms);
  Case made;
  made.files["agent.asl"] = splice(choices, host, one_of(choices, kPrograms));
  made.commands = {{"check", "agent.asl"}, {"fmt", "--check", "agent.asl"}};
  if (crosses) {
    made.files.merge(walker_files());
    made.files["crossing.yaml"] = "behaviours: [agent.asl]\n";
    made.commands.push_back(
        {"run", "crossing.yaml", "--agents", "2", "--max-ticks", "4", "--max-cycles", "300"});
  } else {
    made.files["other.asl"] = one_of(choices, kPrograms);
    made.agents = {"agent.asl", "other.asl"};
  }
  return made;
}

}  // namespace jaywalk::fuzz::target::splices

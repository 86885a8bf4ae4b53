// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/mas/system.h"

#include <gtest/gtest.h>

#include "interpreter/agent/surroundings/host.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/environment/percepts.h"
#include "interpreter/syntax/load.h"

namespace jaywalk::test {
namespace {

std::shared_ptr<const Program> program_of(const std::string& name, std::string_view text,
                                          SymbolTable& symbols, std::string& error) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>(name + ".asl", std::string(text));
  const SourceTree tree = load_agent(source, {}, diagnostics);
  auto program = compile(tree, symbols, diagnostics);
  if (program == nullptr) error = diagnostics.render();
  return program;
}

}  // namespace

System::System(MasOptions with) : options(std::move(with)) {
  if (options.max_cycles == 0) options.max_cycles = 100'000;
  options.print = [this](std::string_view line) { printed.emplace_back(line); };
  options.log = [this](std::string_view line) { logged.emplace_back(line); };
  options.load_program = [this](const ProgramRequest& request, SymbolTable& run_symbols,
                                LoadProblem& problem) -> std::shared_ptr<const Program> {
    const auto found = files.find(request.file);
    if (found != files.end())
      return program_of(request.file, found->second, run_symbols, problem.text);
    problem.text = "no file " + request.file;
    return nullptr;
  };
}

void System::add(const std::string& name, std::string_view text) {
  std::string error;
  agents.push_back({.name = name, .program = program_of(name, text, *symbols, error)});
  ASSERT_EQ(error, "");
}

RunOutcome System::run(Environment* environment) {
  mas = std::make_unique<Mas>(symbols, options, environment);
  for (const AgentSpec& agent : agents) mas->add_agent(agent);
  return mas->run();
}

void TestWorld::perceive(AgentId, Percepts& percepts) const {
  percepts.add(tick_, {Value::number(now_)});
}

void TestWorld::execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) {
  std::string line;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (!line.empty()) line += ' ';
    line += std::to_string(static_cast<std::uint32_t>(actions[i].agent)) + ':' +
            std::string(symbols_.functor(actions[i].predicate));
    if (actions[i].predicate == refuse_) results[i] = {false, "the world says no"};
  }
  history.push_back(line);
}

}  // namespace jaywalk::test

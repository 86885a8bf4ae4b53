// SPDX-License-Identifier: Apache-2.0
#include "tests/helpers/run_agents.h"

#include <memory>

#include "interpreter/compile/compiler.h"

namespace jaywalk::test {
namespace {

std::string place_and_message(const Diagnostic& diagnostic) {
  if (diagnostic.where.source == nullptr) return diagnostic.message;
  const auto at = diagnostic.where.source->position(diagnostic.where.span.begin);
  return std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + diagnostic.message;
}

}  // namespace

std::vector<std::string> AgentRun::printed_by(std::string_view agent) const {
  const std::string prefix = "[" + std::string(agent) + "] ";
  std::vector<std::string> found;
  for (const std::string& line : printed) {
    if (line.starts_with(prefix)) found.push_back(line.substr(prefix.size()));
  }
  return found;
}

AgentRun run_agents(const std::vector<NamedProgram>& programs, MasOptions options,
                    const EnvironmentMaker& make_environment, Steps steps,
                    const IncludePath& includes) {
  AgentRun run;
  const auto symbols = std::make_shared<SymbolTable>();
  std::vector<AgentSpec> agents;
  for (const NamedProgram& program : programs) {
    Diagnostics diagnostics;
    const auto source = std::make_shared<const Source>(program.name + ".asl", program.text);
    const SourceTree tree = load_agent(source, includes, diagnostics);
    const auto compiled = compile(tree, *symbols, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.items()) {
      if (diagnostic.severity == Severity::error) {
        run.errors.push_back(place_and_message(diagnostic));
      }
    }
    if (compiled == nullptr) continue;
    agents.push_back({.name = program.name, .program = compiled, .settings = program.settings});
  }
  if (!run.errors.empty()) return run;
  options.print = [&](std::string_view line) { run.printed.emplace_back(line); };
  options.log = [&](std::string_view line) { run.logged.emplace_back(line); };
  if (options.max_cycles == 0) options.max_cycles = 100'000;
  std::unique_ptr<Environment> environment;
  if (make_environment) environment = make_environment(*symbols);
  Mas mas(symbols, options, environment.get());
  for (const AgentSpec& agent : agents) mas.add_agent(agent);
  while (steps == Steps::one ? mas.step() : mas.stride()) {
  }
  run.outcome = mas.outcome();
  return run;
}

std::vector<std::string> printed_by(std::string_view program, MasOptions options) {
  return run_agents({{"agent", std::string(program)}}, std::move(options)).printed_by("agent");
}

}  // namespace jaywalk::test

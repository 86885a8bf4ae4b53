// SPDX-License-Identifier: Apache-2.0
// Runs every program in this folder and compares what comes of it with what its comments say.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/surroundings/host.h"
#include "interpreter/agent/surroundings/observer.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/syntax/load.h"
#include "tests/conformance/board.h"
#include "tests/conformance/program_file.h"

namespace jaywalk::test {
namespace {

const std::filesystem::path kFolder = JAYWALK_SOURCE_DIR "/tests/conformance";

std::vector<std::string> program_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kFolder)) {
    if (entry.path().extension() != ".asl") continue;
    names.push_back(entry.path().lexically_relative(kFolder).replace_extension().generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string end_text(RunEnd end) {
  switch (end) {
    case RunEnd::stopped:
      return "stopped";
    case RunEnd::idle:
      return "idle";
    case RunEnd::finished:
      return "finished";
    case RunEnd::limit:
      return "limit";
    case RunEnd::looping:
      return "looping";
    case RunEnd::interrupted:
      return "interrupted";
  }
  return "unknown";
}

/// What programs can include: the test's own files.
IncludePath includes_of(const ProgramFile& file) {
  IncludePath includes;
  includes.given.assign(file.files.begin(), file.files.end());
  return includes;
}

/// Files are read from, and written to, the test's own.
void keep_files_in_memory(ProgramFile& file) {
  file.options.load_program = [&file](const ProgramRequest& request, SymbolTable& symbols,
                                      LoadProblem& problem) -> std::shared_ptr<const Program> {
    file.files.try_emplace("");  // an agent may be created without a program
    const auto found = file.files.find(request.file);
    if (found == file.files.end()) {
      problem.text = request.file + ": no such file";
      return nullptr;
    }
    Diagnostics diagnostics;
    const auto source = std::make_shared<const Source>(found->first, found->second);
    const SourceTree tree = load_agent(source, includes_of(file), diagnostics);
    auto program =
        compile(tree, symbols, diagnostics, {.ns = request.ns, .fresh_names = request.included});
    if (program == nullptr) problem.text = diagnostics.render();
    return program;
  };
  file.options.why_not_list = [](const std::string&) { return std::string(); };
  file.options.save_program = [&file](const std::string& name, const std::string& text,
                                      std::string&) {
    file.files[name] = text;
    return true;
  };
}

class Conformance : public ::testing::TestWithParam<std::string> {};

TEST_P(Conformance, DoesAsItsCommentsSay) {
  std::filesystem::current_path(JAYWALK_SOURCE_DIR);  // `.list_files` looks from there
  const std::string path = (kFolder / (GetParam() + ".asl")).string();
  ProgramFile file = read_program_file(path);
  keep_files_in_memory(file);
  ASSERT_THAT(file.problems, ::testing::IsEmpty());
  ASSERT_FALSE(file.printed.empty() && file.errors.empty() && file.logged.empty() &&
               file.end == "idle")
      << "the program expects nothing";
  const AgentRun run =
      file.on_board
          ? run_agents(file.agents, file.options,
                       [](SymbolTable& symbols) { return std::make_unique<Board>(symbols); })
          : run_agents(file.agents, file.options, {}, Steps::many, includes_of(file));
  EXPECT_EQ(run.errors, file.errors) << path;
  if (!run.errors.empty()) return;
  auto printed = file.printed;  // agents that are created while it runs among them
  for (const NamedProgram& agent : file.agents) printed.try_emplace(agent.name);
  for (const auto& [agent, lines] : printed) {
    EXPECT_EQ(run.printed_by(agent), lines) << path << ", agent " << agent;
  }
  for (const std::string& text : file.logged) {
    EXPECT_THAT(run.logged, ::testing::Contains(::testing::HasSubstr(text))) << path;
  }
  EXPECT_EQ(end_text(run.outcome.end), file.on_board && file.end == "idle" ? "limit" : file.end)
      << path << ": " << run.outcome.message;
  if (::testing::Test::HasFailure()) {
    for (const std::string& line : run.logged) std::printf("log: %s\n", line.c_str());
  }
}

// As `run_agents`, with the file's own world.
AgentRun run_on_threads(const std::string& path, std::size_t threads,
                        ReasoningObserver* observer = nullptr) {
  ProgramFile file = read_program_file(path);
  keep_files_in_memory(file);
  file.options.threads = threads;
  file.options.fewest_parallel = 1;
  file.options.observer = observer;
  EnvironmentMaker world;
  if (file.on_board) {
    world = [](SymbolTable& symbols) { return std::make_unique<Board>(symbols); };
  }
  return run_agents(file.agents, file.options, world, Steps::many, includes_of(file));
}

TEST_P(Conformance, DoesTheSameOnSeveralThreads) {
  const std::string path = (kFolder / (GetParam() + ".asl")).string();
  const AgentRun alone = run_on_threads(path, 1);
  const AgentRun beside = run_on_threads(path, 3);
  EXPECT_EQ(beside.printed, alone.printed) << path;
  EXPECT_EQ(beside.logged, alone.logged) << path;
  EXPECT_EQ(beside.outcome.end, alone.outcome.end) << path;
  EXPECT_EQ(beside.outcome.cycles, alone.outcome.cycles) << path;
}

// An observer sees each event with its literal, which is not made otherwise.
TEST_P(Conformance, DoesTheSameWhenObserved) {
  const std::string path = (kFolder / (GetParam() + ".asl")).string();
  ReasoningObserver nobody;
  const AgentRun alone = run_on_threads(path, 1);
  const AgentRun observed = run_on_threads(path, 1, &nobody);
  EXPECT_EQ(observed.printed, alone.printed) << path;
  EXPECT_EQ(observed.logged, alone.logged) << path;
  EXPECT_EQ(observed.outcome.end, alone.outcome.end) << path;
  EXPECT_EQ(observed.outcome.cycles, alone.outcome.cycles) << path;
}

INSTANTIATE_TEST_SUITE_P(Programs, Conformance, ::testing::ValuesIn(program_names()),
                         [](const auto& program) {
                           std::string name = program.param;
                           std::replace(name.begin(), name.end(), '/', '_');
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace jaywalk::test

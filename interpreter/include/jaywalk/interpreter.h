// SPDX-License-Identifier: Apache-2.0
#pragma once

// The interpreter within another program: load agents, run them, query them and send them messages.
// This is the header to begin with; it deals in texts, so that callers need not know terms.
// docs/guides/embed.md shows it at work.
//
//   jaywalk::Interpreter interpreter({.print = [](std::string_view line) { ... }});
//   const auto program = interpreter.load_text("counter", "!count(3). +!count(N) <- .print(N).");
//   if (!program) ... program.diagnostics().render() says what is wrong with it
//   const jaywalk::AgentId ann = interpreter.add_agent("ann", program.value());
//   interpreter.run();
//
// An Interpreter is used by one thread at a time; several of them share nothing.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <jaywalk/action.h>
#include <jaywalk/agent_class.h>
#include <jaywalk/diagnostics.h>
#include <jaywalk/environment.h>
#include <jaywalk/run.h>

namespace jaywalk {

class Mas;
struct IncludePath;

/// Where programs find what they include and what they read as they run. The program's own folder
/// and that of its project are searched, and may be read, in any case.
struct ProgramFolders {
  /// Searched for included files, in order; may be read.
  std::vector<std::string> included;
  /// Prefixes of names and the folders that stand for them: {"$lib", "/opt/agents"}.
  std::vector<std::pair<std::string, std::string>> mapped;
  /// May be read as well.
  std::vector<std::string> readable;
};

/// One solution of a query: the values of its variables, in the order of the query. Variables that
/// are still free are left out.
class Answer {
 public:
  struct Binding {
    std::string variable;
    /// As it would be printed: `3`, `p(a,[1,2])`, `"text"`.
    std::string term;
    /// The value of a number, the content of a string.
    std::optional<double> number;
    std::optional<std::string> text;
  };

  explicit Answer(std::vector<Binding> bindings) : bindings_(std::move(bindings)) {}
  [[nodiscard]] const std::vector<Binding>& bindings() const { return bindings_; }
  /// Null if the variable is free or not in the query.
  [[nodiscard]] const Binding* find(std::string_view variable) const;
  /// The variable's value as it would be printed; empty if it has none.
  [[nodiscard]] std::string operator[](std::string_view variable) const;

 private:
  std::vector<Binding> bindings_;
};

class Interpreter {
 public:
  /// Makes the agents' world; the names that it needs are put into the table in its constructor.
  using EnvironmentMaker = std::function<std::unique_ptr<Environment>(SymbolTable& symbols)>;

  /// `options` says where output goes, the seed and the limits. Without a world, agents think and
  /// talk only.
  explicit Interpreter(MasOptions options = {}, const EnvironmentMaker& make_environment = {});
  ~Interpreter();
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  /// Internal actions and functions beside the built-in ones; one of the same name replaces it. An
  /// action's name has a dot; `most_args` -1: any number. REQUIRES: no program has been loaded.
  void add_action(std::string name, int least_args, int most_args,
                  std::function<Outcome(Call& call)> body);
  void add_function(FunctionDefinition function);

  /// A program, to be run by any number of agents of this interpreter. Errors have their places.
  /// Its includes, and the files that agents load and list as they run, are read from its folder
  /// and from `folders`, nowhere else.
  [[nodiscard]] Result<std::shared_ptr<const Program>> load_file(
      const std::string& path, const ProgramFolders& folders = {});
  [[nodiscard]] Result<std::shared_ptr<const Program>> load_text(
      const std::string& name, std::string text, const ProgramFolders& folders = {});

  /// Agents may be added at any time; a name that is taken gets a suffix. Without a program an
  /// agent has no plans.
  AgentId add_agent(const std::string& name, std::shared_ptr<const Program> program);
  /// With functions of its own.
  AgentId add_agent(const std::string& name, std::shared_ptr<const Program> program,
                    AgentClass functions);

  /// Runs until all agents are idle, an agent stops the run, the environment is finished or a limit
  /// of the options is reached. After the first, it may be called again when there is more to do.
  /// Called from within a run, it only says how that stands.
  RunOutcome run();
  /// One tick, or without an environment one reasoning cycle of every agent that has something to
  /// do. False: the run has ended.
  bool step();

  // Each function returns errors in its text, or that the agent has ended or never existed, or that
  // a limit was reached. Without errors it has been done. A call from a function that this
  // interpreter calls (an action, an answer, output) returns an error, too.

  /// The first `most` answers to a formula of a plan's context (0: all): "age(X, N) & N > 18".
  [[nodiscard]] Result<std::vector<Answer>> ask(AgentId agent, const std::string& query,
                                                std::size_t most = 0);
  /// Each answer in turn, as it is found; `answer` returns false to stop.
  [[nodiscard]] Diagnostics ask(AgentId agent, const std::string& query,
                                const std::function<bool(const Answer&)>& answer);
  /// Each answer as terms: the query's variables that have a value.
  struct BoundVariable {
    std::string_view name;
    Value value;
  };
  using AnswerReader = std::function<bool(Terms terms, std::span<const BoundVariable> variables)>;
  [[nodiscard]] Diagnostics ask_terms(AgentId agent, const std::string& query,
                                      const AnswerReader& answer);
  /// Adds a belief, as the agent's own formula `+b` would: "speed(13)[source(radar)]".
  [[nodiscard]] Diagnostics believe(AgentId agent, const std::string& belief);
  /// Removes the first belief that unifies, as `-b` would: "speed(_)[source(radar)]".
  [[nodiscard]] Diagnostics forget(AgentId agent, const std::string& belief);
  /// Gives the agent a goal: "go_to(3, 4)".
  [[nodiscard]] Diagnostics achieve(AgentId agent, const std::string& goal);
  /// Gives the agent all beliefs, rules, goals and plans of a text. (It is kept until the
  /// interpreter goes, so for single beliefs the functions above are better.)
  [[nodiscard]] Diagnostics include(AgentId agent, const std::string& name, std::string text);

  /// An intention that Call::suspend made wait goes on behind its formula.
  [[nodiscard]] Diagnostics resume(AgentId agent, std::uint32_t intention);

  // How agents are.

  /// False for those that are gone, and for ids that were never given.
  [[nodiscard]] bool is_alive(AgentId agent) const;
  /// The name that it got. This and what follows is empty of an agent that is gone.
  [[nodiscard]] const std::string& agent_name(AgentId agent) const;
  /// Its beliefs as texts, in the order of the belief base.
  [[nodiscard]] std::vector<std::string> beliefs(AgentId agent) const;
  /// Its beliefs as terms; none while the interpreter is at work.
  void each_belief(AgentId agent, const std::function<void(Terms terms, Value belief)>& callback);
  /// The goals of each intention, the outermost first: "test_av > cross > step(right)".
  [[nodiscard]] std::vector<std::string> intentions(AgentId agent) const;
  /// Virtual time since the run began, in milliseconds.
  [[nodiscard]] double now_ms() const;

  // For the rest of this project, whose other headers are needed to use it: the whole system.
  [[nodiscard]] Mas& mas();
  [[nodiscard]] Result<std::shared_ptr<const Program>> load_file(const std::string& path,
                                                                 const IncludePath& include_path);
  [[nodiscard]] Result<std::shared_ptr<const Program>> load_text(const std::string& name,
                                                                 std::string text,
                                                                 const IncludePath& include_path);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace jaywalk

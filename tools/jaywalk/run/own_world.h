// SPDX-License-Identifier: Apache-2.0
#pragma once

// A world that is a program, as an option or a project names it; for the commands that start it.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "env/environment_process/process_environment.h"
#include "env/environments.h"
#include "interpreter/embed/project_agents.h"
#include "interpreter/support/diagnostics.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

/// The options that name a world for agents that are run.
inline constexpr OptionSpec kWorldOptions[] = {
    {option::kEnvironment, "COMMAND",
     "this program is the agents' world (a project's own is left out);\n"
     "docs/reference/environment_protocol.md says what it reads and answers"},
    {option::kEnvironmentTimeout, "S", "seconds that an answer of it may take (default 10)"}};

struct OwnWorld {
  /// The program and its arguments; the folder where it runs.
  std::vector<std::string> command;
  std::string folder;
  /// Terms for it, as text.
  std::vector<std::string> arguments;
  double answer_s = ProcessEnvironment::kAnswerS;
  /// Its place in a project; without one, the option or variable that names it.
  SourceSpan where;
  std::string named_by = option::kEnvironment.dashed();
  /// What messages call it; empty: the environment, by its command.
  std::string title = {};
  /// It has internal actions and functions for the agents, too (world_calls.h).
  bool has_actions = false;

  /// An error about it, at the place that names it.
  void error(std::string message, Diagnostics& diagnostics) const;
  /// Its failure, if it has failed, with the mistakes in its percepts.
  void report_failure(const ProcessEnvironment& world, Diagnostics& diagnostics) const;
};

/// The world that an option names, else a project in `folder`. None without either, and after
/// adding errors.
[[nodiscard]] std::optional<OwnWorld> own_world(const Arguments& arguments,
                                                const std::optional<ProjectEnvironment>& project,
                                                const std::string& folder,
                                                Diagnostics& diagnostics);

/// Ready to start; what it shows and writes to standard error goes to the console.
[[nodiscard]] std::unique_ptr<ProcessEnvironment> make_world(const OwnWorld& world,
                                                             Console& console);

/// The words that a world declares, for the checker. Lives no longer than the identity.
class DeclaredWords {
 public:
  explicit DeclaredWords(const EnvironmentIdentity& identity);
  /// Null if it does not declare both percepts and actions.
  [[nodiscard]] const EnvironmentKind* kind() const { return is_complete_ ? &kind_ : nullptr; }

 private:
  std::vector<EnvironmentWord> percepts_;
  std::vector<EnvironmentWord> actions_;
  EnvironmentKind kind_;
  bool is_complete_;
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The Java classes of a Jason project: a virtual machine runs them with the user's own Jason and
// speaks the environment protocol, so that it is a world like any other program (tools/jason).

#include <optional>
#include <string>
#include <vector>

#include "interpreter/embed/project_agents.h"
#include "interpreter/support/diagnostics.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/run/own_world.h"

namespace jaywalk {

/// The option that names the user's Jason.
inline constexpr OptionSpec kJasonOption = {
    option::kJason, "PATH",
    "of a project with Java classes: run its environment and internal\n"
    "actions with this Jason, a jar or a folder (default: JASON_HOME)"};

/// Whether the user has named a Jason, by that option or by JASON_HOME.
[[nodiscard]] bool has_jason(const Arguments& arguments);

/// Whether the programs call internal actions that no library has.
[[nodiscard]] bool calls_java(const std::vector<ProgramSource>& programs);

/// The virtual machine for the classes of a project in `folder`; none after adding an error.
/// REQUIRES: has_jason().
[[nodiscard]] std::optional<OwnWorld> java_world(const Arguments& arguments,
                                                 const ProjectJava& java, const std::string& folder,
                                                 Diagnostics& diagnostics);

}  // namespace jaywalk

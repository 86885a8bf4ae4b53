#pragma once

// The agents and scenarios that are installed with the command.

#include <string>

#include "interpreter/support/source_files.h"

namespace jaywalk {

/// The file that a word of the command line means: what stands there, or else what is installed
/// under that name (`scenarios/paper.yaml`), or else the word as it is.
[[nodiscard]] std::string located(const std::string& path);

/// The disk, and the agents that are installed as `$jaywalk/`.
[[nodiscard]] SourceFiles files_on_disk();

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The agents and scenarios that are installed with the command.

#include <string>

#include "interpreter/support/source_files.h"

namespace jaywalk {

/// The file that a word of the command line means: the file at that path, or else the installed one
/// of that name (`scenarios/paper.yaml`), or else the word as it is.
[[nodiscard]] std::string located(const std::string& path);

/// The folder where these are.
[[nodiscard]] std::string shipped_folder();

/// The disk, with the installed programs as `$jaywalk/`.
[[nodiscard]] SourceFiles files_on_disk();

/// `$jaywalk/assertions/crossing.yaml` for an installed list of assertions that was located() by
/// its path, so that a store that keeps the name says nothing of this machine; other paths as they
/// are.
[[nodiscard]] std::string portable_assertions(const std::string& path);

}  // namespace jaywalk

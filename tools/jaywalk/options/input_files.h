// SPDX-License-Identifier: Apache-2.0
#pragma once

// The files that operands name: where they are, and whether the command can do something with them.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"

namespace jaywalk {

/// The operand for standard input.
inline constexpr std::string_view kStandardInput = "-";

/// Each operand as it is; a folder becomes its files with one of the endings, those of its folders
/// included, by name. What is hidden (`.git`) is left out. False: a folder has none or cannot be
/// read, which is reported.
bool expand_folders(std::span<const std::string> operands,
                    std::span<const std::string_view> endings, Console& console,
                    std::vector<std::string>& files);

/// `search`: an experiment with `sut`. `store`: of tests or of searches.
enum class InputKind { program, project, scenario, search, assertions, store };

/// The file of an operand, or of an option's value: at that path, or else the installed one of that
/// name (shipped.h). Nothing after adding an error: there is no such file, or it is plainly of a
/// kind that is not `wanted`; then the error names the commands that take it.
[[nodiscard]] std::optional<std::string> input_file(const std::string& word,
                                                    std::span<const InputKind> wanted,
                                                    Diagnostics& diagnostics);

/// The input files among the words that are valid.
[[nodiscard]] std::vector<std::string> input_files(std::span<const std::string> words,
                                                   std::span<const InputKind> wanted,
                                                   Diagnostics& diagnostics);

/// The input file that is the only operand of `command`; errors call it `what`.
[[nodiscard]] std::optional<std::string> only_input(const Arguments& arguments,
                                                    std::string_view command, std::string_view what,
                                                    std::span<const InputKind> wanted,
                                                    Diagnostics& diagnostics);

/// Kinds that several commands take.
inline constexpr std::array kScenarios{InputKind::scenario};
inline constexpr std::array kStores{InputKind::store};
inline constexpr std::array kPrograms{InputKind::program};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The parameters of a program: initial beliefs that a scenario sets, and where programs are. Read
// reader.h first.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "env/config/reader.h"
#include "interpreter/support/source_files.h"

namespace jaywalk {

/// A number or the name of an atom.
using ParameterValue = std::variant<double, std::string>;

/// Replaces a program's initial beliefs of that name: `radius: 15` is radius(15).
struct ParameterSetting {
  std::string name;
  std::vector<ParameterValue> values;
  ValueOrigin origin;
};

/// Reads `{radius: 15, odds: [1, 11]}`; a name that is there already is given its new values.
void read_parameters(const ConfigNode& node, const ConfigReader& reader,
                     std::vector<ParameterSetting>& settings);

/// Whether a text can be an atom of AgentSpeak.
[[nodiscard]] bool is_atom(std::string_view text);

/// `folder`/`path`, or `path` if that is absolute.
[[nodiscard]] std::string path_in(const std::string& folder, const std::string& path);

/// The installed behaviours of a world, among the installed programs (source_files.h): those of its
/// folder, `$jaywalk/crossing/proximity.asl` of `crossing`, and those of `specialists` in it,
/// sorted by the names of the files. None if `files` are copies.
[[nodiscard]] std::vector<std::string> installed_behaviours(std::string_view world,
                                                            const SourceFiles& files);
/// `$jaywalk/crossing/proximity.asl` for `proximity` in `crossing`,
/// `$jaywalk/crossing/specialists/brink.asl` for `brink`. An unknown name gives a path in the
/// world's folder at which there is no file.
[[nodiscard]] std::string installed_behaviour(std::string_view world, std::string_view name,
                                              const SourceFiles& files);

/// The file of a program: as path_in, or an installed one, by its name in `$jaywalk/` or, without
/// folder and `.asl`, as a behaviour of the world (`proximity`).
[[nodiscard]] std::string program_path(const std::string& folder, const std::string& text,
                                       std::string_view world, const SourceFiles& files);

}  // namespace jaywalk

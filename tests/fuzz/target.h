// SPDX-License-Identifier: Apache-2.0
#pragma once

// A fuzzing target makes cases, each a function of its number alone. targets.def has a row
// for each target; campaign.h runs them.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/helpers/generate.h"

namespace jaywalk::fuzz {

using test::Choices;

/// Files in a folder of the case's own, and what is done there.
struct Case {
  std::map<std::string, std::string> files;
  /// Names of programs among `files` that run together in one system, under small limits.
  std::vector<std::string> agents;
  /// The words of `jaywalk` commands, carried out in this order in the folder.
  std::vector<std::vector<std::string>> commands;
  /// The commands' standard input.
  std::string input;
  /// The beginnings of names in the folder under which the commands may write. It does harm if they
  /// make another file there, or one beside the folder; empty: files are not looked at.
  std::vector<std::string> outputs = {};
};

struct Target {
  std::string_view name;
  std::string_view summary;
  Case (*make)(Choices& choices);
};

/// In the order of targets.def.
[[nodiscard]] std::span<const Target> targets();

#define JAYWALK_FUZZ_TARGET(name, summary)   \
  namespace target::name {                   \
  [[nodiscard]] Case make(Choices& choices); \
  }
#include "tests/fuzz/targets.def"
#undef JAYWALK_FUZZ_TARGET

}  // namespace jaywalk::fuzz

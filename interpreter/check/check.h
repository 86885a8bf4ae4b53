// SPDX-License-Identifier: Apache-2.0
#pragma once

// Warnings about programs that parse but cannot be meant so: goals without plans, misspelt beliefs,
// variables without a value, plans that are never reached. False alarms are worse than silence, for
// a program's beliefs, goals and plans may come from other agents. Each warning has a code, a row
// of checks.def; checks.md and formula_checks.md of docs/reference show when it is given.
//
// Comments silence them, and list what a file requires of programs that include it
// (support/remarks.h).

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

struct ProgramWords;

/// The words that a program may use without defining them.
struct Vocabulary {
  struct Entry {
    std::string name;
    int least_args = 0;
    int most_args = 0;  // -1: any number
    std::string summary;
    /// The atoms that each argument takes; none, or no entry, where it takes others, too.
    std::vector<std::vector<std::string>> values = {};
    /// For percepts that the scenario does not give: the keys that would give it.
    std::string absent_without = {};
    /// For internal actions: whether it is a function, whose value can stand in a term.
    bool is_function = false;
  };
  /// A scenario's values of an initial belief: `radius: 15` is radius(15).
  struct Setting {
    std::string name;
    /// The values that are atoms; entries of other values are empty.
    std::vector<std::string> atoms;
    /// The place of the setting in a file or option.
    SourceSpan where;
    std::string option = {};
  };

  /// A file that programs may include. Names are written `radius/1`, those of goals `!cross/0`.
  struct Library {
    std::string name;  // as in an include, "$jaywalk/crossing/shared/alone.asl"
    std::set<std::string, std::less<>> defines;
    std::set<std::string, std::less<>> asks;
  };

  /// Whether the environment is known: its percepts and actions are those below and no others.
  bool environment_known = false;
  std::vector<Entry> percepts;
  std::vector<Entry> actions;
  /// With their dots, functions such as math.abs included. Empty: they are not checked.
  std::vector<Entry> internal_actions;
  /// The performatives of messages. Empty: they are not checked.
  std::vector<std::string> performatives = {};
  std::vector<Setting> settings = {};
  /// Reads the installed libraries, which hints name; null: there are none.
  std::function<std::vector<Library>()> libraries = nullptr;
  /// Whether the program may be all there is: it is not, if it lies among those of a project.
  bool may_be_alone = true;
  /// Whether the agent is run without others that could give it a goal.
  bool begins_by_itself = false;
  /// Whether all agents of the system are known: the others can post, tell or ask for names in
  /// `named_by_others` only.
  bool others_known = false;
  std::set<std::string, std::less<>> named_by_others;
};

/// A row of checks.def: a warning that `check` or the reading of a program gives.
struct CheckInfo {
  std::string_view name;  // the code
  std::string_view summary;
};

[[nodiscard]] std::span<const CheckInfo> checks();

/// Adds warnings, by file and place. Of a program whose includes are not all there, or that adds
/// plans or beliefs of unknown content, only what these cannot change is reported.
void check_program(const SourceTree& program, const Vocabulary& vocabulary,
                   Diagnostics& diagnostics);
/// Checks a program for which the caller has `words_of(program)` already.
void check_program(const SourceTree& program, ProgramWords words, const Vocabulary& vocabulary,
                   Diagnostics& diagnostics);

/// All names of literals that a program's text mentions, within strings too: any of them may be
/// posted, told or asked for in other agents.
[[nodiscard]] std::set<std::string, std::less<>> names_in(const SourceTree& program);

}  // namespace jaywalk

#pragma once

// Warnings about programs that parse but cannot be meant so: goals without plans, misspelt beliefs,
// actions that the environment does not have. False alarms are worse than silence, for a program's
// beliefs, goals and plans may come from other agents; what is told is documented per code below.
//
// A comment `// jaywalk: allow unknown-goal` on the line or the line before silences a code there.

#include <string>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

/// The words that a program may use without defining them.
struct Vocabulary {
  struct Entry {
    std::string name;
    int least_args = 0;
    int most_args = 0;  // -1: any number
    std::string summary;
  };

  /// Whether the environment is known: its percepts and actions are those below and no others.
  bool environment_known = false;
  std::vector<Entry> percepts;
  std::vector<Entry> actions;
  /// With their dots, functions such as math.abs included. Empty: they are not checked.
  std::vector<Entry> internal_actions;
};

/// Adds warnings, by file and place:
///   unknown-goal             `!g` without a plan for it; other numbers of arguments are named
///   unused-plan              a plan for a goal that nobody posts, but whose name is almost a
///   goal's unknown-belief           a query that nothing can answer: only if its name is almost a
///   known
///                            one, or if the environment is known and the agents send no messages
///   unknown-action           an action that the known environment does not have
///   unknown-internal-action  neither an internal action nor a function of the vocabulary
/// Nothing but unknown-action and unknown-internal-action is told of a program whose includes are
/// not all there, or that adds plans of unknown content.
void check_program(const SourceTree& program, const Vocabulary& vocabulary,
                   Diagnostics& diagnostics);

}  // namespace jaywalk

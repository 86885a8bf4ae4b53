#pragma once

// The names that a program mentions outside of definitions: it may post, ask for or tell them, even
// indirectly (by a term in a variable, or a text that becomes a plan).

#include <string_view>
#include <unordered_set>

#include "interpreter/syntax/load.h"

namespace jaywalk {

/// REQUIRES: the program lives as long, whose texts these are.
struct Mentions {
  /// Functors anywhere but of the triggers of plans and the heads of rules, and all words within
  /// strings that may be names.
  std::unordered_set<std::string_view> names;
};

[[nodiscard]] Mentions mentions_in(const SourceTree& program);

/// Whether anything in a program shows that there are other agents: messages, names, sources.
[[nodiscard]] bool shows_other_agents(const SourceTree& program);

}  // namespace jaywalk

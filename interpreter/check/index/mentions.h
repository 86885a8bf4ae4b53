#pragma once

// The names that a program mentions anywhere but where it defines something: what it may post, ask
// for or tell, however roundabout its way (a term in a variable, a text that becomes a plan).

#include <set>
#include <string>

#include "interpreter/syntax/load.h"

namespace jaywalk {

struct Mentions {
  /// Functors anywhere but of the triggers of plans and the heads of rules, and all words within
  /// strings.
  std::set<std::string, std::less<>> names;
  /// Whether anything shows that there are other agents: messages, names, sources.
  bool other_agents = false;
};

[[nodiscard]] Mentions mentions_in(const SourceTree& program);

}  // namespace jaywalk

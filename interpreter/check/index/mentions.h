#pragma once

// The names that a program mentions anywhere but where it defines something: what it may post, ask
// for or tell, however roundabout its way (a term in a variable, a text that becomes a plan).

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>

#include "interpreter/syntax/load.h"

namespace jaywalk {

/// Of names, which are looked for without a copy.
struct NameHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view name) const {
    return std::hash<std::string_view>()(name);
  }
};

struct Mentions {
  /// Functors anywhere but of the triggers of plans and the heads of rules, and all words within
  /// strings.
  std::unordered_set<std::string, NameHash, std::equal_to<>> names;
  /// Whether anything shows that there are other agents: messages, names, sources.
  bool other_agents = false;
};

[[nodiscard]] Mentions mentions_in(const SourceTree& program);

}  // namespace jaywalk

#include "env/config/node.h"

#include <algorithm>
#include <utility>

namespace jaywalk {

const ConfigNode* ConfigNode::find(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const ConfigEntry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

void report(Diagnostics& diagnostics, const ValueOrigin& origin, std::string message,
            std::string hint) {
  if (origin.where.source) {
    diagnostics.error(origin.where, std::move(message), std::move(hint));
  } else {
    diagnostics.error(origin.option, std::move(message), std::move(hint));
  }
}

}  // namespace jaywalk

#pragma once

// The parsed values of a scenario or another YAML file of settings, each with the place where it
// was written. experiment/scenario/scenario_yaml.h makes them.

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// Where a value was given: a place in a file, or an option (`--set world.length=80`).
struct ValueOrigin {
  SourceSpan where;
  std::string option;
};

struct ConfigEntry;

/// A scalar, a list or a map as it was written; aliases are resolved.
struct ConfigNode {
  enum class Kind { null, scalar, list, map };

  Kind kind = Kind::null;
  std::string text;  // of a scalar
  ValueOrigin origin;
  std::vector<ConfigNode> items;     // of a list
  std::vector<ConfigEntry> entries;  // of a map, in the order of the file

  /// The value of a key of a map, or null.
  [[nodiscard]] const ConfigNode* find(std::string_view key) const;
};

struct ConfigEntry {
  std::string key;
  ValueOrigin origin;
  ConfigNode value;
};

void report(Diagnostics& diagnostics, const ValueOrigin& origin, std::string message,
            std::string hint = {});

}  // namespace jaywalk

#pragma once

// YAML as scenarios use it: values with the places where they were written. The library that
// parses it is seen by scenario_yaml.cpp alone. Read scenario.h before.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/scenario/scenario.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

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

/// More values than these, aliases counted as often as they are used, or deeper ones are refused.
inline constexpr std::size_t kMaxConfigValues = 20'000;
inline constexpr int kMaxConfigDepth = 32;

/// Parses one YAML document; an empty one is null. No value after adding errors.
[[nodiscard]] std::optional<ConfigNode> parse_config(const SourcePtr& source,
                                                     Diagnostics& diagnostics);

/// Parses `dotted.path=value` into maps within maps; the value may be any YAML. If another option
/// than `--set` gave it, `value` is what it gave, under the option's name.
[[nodiscard]] std::optional<ConfigNode> parse_setting(const std::string& setting,
                                                      Diagnostics& diagnostics,
                                                      const SourcePtr& value = nullptr);

void report(Diagnostics& diagnostics, const ValueOrigin& origin, std::string message,
            std::string hint = {});

}  // namespace jaywalk

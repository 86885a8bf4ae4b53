// SPDX-License-Identifier: Apache-2.0
#pragma once

// YAML as scenarios use it: values with the places where they were written. The library that
// parses it is seen by scenario_yaml.cpp alone. Read env/config/reader.h first.

#include <optional>
#include <string>

#include "env/config/reader.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// More values than these, aliases counted as often as they are used, or deeper ones are refused.
inline constexpr std::size_t kMaxConfigValues = 20'000;
inline constexpr int kMaxConfigDepth = 32;

/// Parses one YAML document; an empty one is null. No value after adding errors.
[[nodiscard]] std::optional<ConfigNode> parse_config(const SourcePtr& source,
                                                     Diagnostics& diagnostics);

/// Parses `dotted.path=value` into maps within maps; the value may be any YAML. If another option
/// than `--set` gave it, `value` is the text of that option, under the option's name.
[[nodiscard]] std::optional<ConfigNode> parse_setting(const std::string& setting,
                                                      Diagnostics& diagnostics,
                                                      const SourcePtr& value = nullptr);

}  // namespace jaywalk

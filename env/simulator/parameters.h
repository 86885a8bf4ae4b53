// SPDX-License-Identifier: Apache-2.0
#pragma once

// The simulator that moves a world's vehicles, and its settings under `world.simulator`. The keys
// are those of the simulator's row (simulator.h); the scenario's reader checks them by that table
// alone.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jaywalk {

/// The key of a choice, if a simulator has it, by which the model that drives the AV is chosen.
inline constexpr std::string_view kAvModelKey = "model";

enum class SettingKind {
  number,   ///< within the key's range
  text,     ///< any text
  choice,   ///< one of the key's words
  flag,     ///< true or false, as 1 or 0
  file,     ///< a file's path, found beside the scenario; stores keep its text
  command,  ///< a program and its arguments, as [python3, simulator.py]
  map,      ///< names and values, {tau: 1, sigma: 0}, the simulator's own to check
  list,     ///< such maps
};

/// A key of a simulator's section.
struct SettingKey {
  std::string_view name;
  SettingKind kind = SettingKind::text;
  std::string_view meaning;
  /// The range of a number.
  double least = 0;
  double most = 0;
  /// The words of a choice, separated by blanks.
  std::string_view words = {};
};

/// The scenario's value for a key.
struct SettingValue {
  double number = 0;
  std::string text;
  std::vector<std::string> command;
  std::vector<std::map<std::string, std::string>> maps;  // one, or those of a list

  friend bool operator==(const SettingValue&, const SettingValue&) = default;
};

struct SimulatorParameters {
  /// A row of simulators.def; empty: the world moves its vehicles by itself.
  std::string name;
  /// The length of one step of the simulator, in seconds; a tick has several.
  double step_s = 0.1;
  std::map<std::string, SettingValue, std::less<>> settings;

  /// Null if the scenario does not say.
  [[nodiscard]] const SettingValue* find(std::string_view key) const {
    const auto found = settings.find(key);
    return found == settings.end() ? nullptr : &found->second;
  }
  [[nodiscard]] double number(std::string_view key, double otherwise) const {
    const SettingValue* const value = find(key);
    return value == nullptr ? otherwise : value->number;
  }
  [[nodiscard]] std::string text(std::string_view key, std::string otherwise = {}) const {
    const SettingValue* const value = find(key);
    return value == nullptr ? std::move(otherwise) : value->text;
  }

  friend bool operator==(const SimulatorParameters&, const SimulatorParameters&) = default;
};

/// An error in a key's value, or in the whole section if `key` is empty.
struct SettingProblem {
  std::string key;
  std::string message;
  std::string hint = {};
  /// The key is one of the world's, as `crosswalks`.
  bool of_world = false;
};

}  // namespace jaywalk

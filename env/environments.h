// SPDX-License-Identifier: Apache-2.0
#pragma once

// The worlds that a scenario can name, with the words by which agents perceive and act in them and
// with how they are read. Each is a row of environments.def; the rows also feed `list
// environments`, the reference and the checker, which suggests the right word for a misspelt one.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <jaywalk/world.h>

namespace jaywalk {

/// Whether the published results are of the world and the parameters that a preset describes.
enum class PresetResults { published, other };

/// Named default values of a scenario. `text` has the form of a scenario; its parameters of
/// behaviours apply to the scenario's behaviours of these names.
struct Preset {
  std::string_view name;
  std::string_view summary;
  std::string_view text;
  PresetResults results = PresetResults::other;
};

class WorldSection;
class WorldSpec;

struct EnvironmentKind {
  std::string_view name;
  std::string_view summary;
  std::span<const EnvironmentWord> percepts;
  std::span<const EnvironmentWord> actions;
  /// A scenario that names no preset begins with the first one; may be empty.
  std::span<const Preset> presets;
  /// Makes the reader of a scenario's key `world` (world/world_section.h).
  std::unique_ptr<WorldSection> (*section)() = nullptr;
};

/// The first one is the world of scenarios that name none.
[[nodiscard]] std::span<const EnvironmentKind> environments();
/// Null if there is none of that name.
[[nodiscard]] const EnvironmentKind* find_environment(std::string_view name);

/// The first world as its defaults have it.
[[nodiscard]] std::shared_ptr<const WorldSpec> default_world();

/// The presets of all worlds.
[[nodiscard]] std::vector<Preset> presets();

/// The meaning, and the keys that a percept needs.
[[nodiscard]] std::string description(const EnvironmentWord& word);

/// The functor of a form, `at` of `at(X,Y)`, and its number of arguments.
[[nodiscard]] std::string_view functor(const EnvironmentWord& word);
[[nodiscard]] int arity(const EnvironmentWord& word);

/// The atoms that each argument takes, in the order of the form; none where it takes numbers.
[[nodiscard]] std::vector<std::vector<std::string>> argument_values(const EnvironmentWord& word);

}  // namespace jaywalk

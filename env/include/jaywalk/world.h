// SPDX-License-Identifier: Apache-2.0
#pragma once

// What scenarios can name: the worlds that agents act in, with the words by which they perceive and
// act there; how an automated vehicle (AV) drives; and the defects that it can have. `jaywalk list`
// shows the same.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

/// A percept or an action. The name and arity are those of its form: `at(X,Y)` is at/2.
struct EnvironmentWord {
  std::string_view form;
  std::string_view meaning;
  /// The atoms that arguments of the form take, by the arguments' names: "Way: left right; ...".
  std::string_view values = {};
  /// For percepts: the keys of a scenario under which agents have it; empty: they always do.
  std::string_view needs = {};
};

struct NamedOption {
  std::string_view name;
  /// One sentence.
  std::string_view summary;
};

struct WorldInfo {
  std::string_view name;
  std::string_view summary;
  std::span<const EnvironmentWord> percepts;
  std::span<const EnvironmentWord> actions;
  /// Values with which scenarios of this world can begin; those that name none begin with the
  /// first.
  std::vector<NamedOption> presets;
};

/// All worlds. The first one is that of scenarios that name none.
[[nodiscard]] std::vector<WorldInfo> world_list();

/// How an AV can drive: values of `world.av.model`.
[[nodiscard]] std::vector<NamedOption> vehicle_model_list();

struct DefectInfo {
  std::string_view name;
  std::string_view summary;
  /// The public report that it is known from, or that it is constructed.
  std::string_view source;
  /// The unit of its severity (s, m, m/s, m/s2, deg, g, %), and the usual severities, from the
  /// mildest. The unit is empty if the defect has no degrees.
  std::string_view unit;
  std::span<const double> severities;
};

/// Values of `world.av.defects` and `experiment.defects`.
[[nodiscard]] std::vector<DefectInfo> defect_list();

}  // namespace jaywalk

#pragma once

// The keys of a scenario: each layer (preset, file, option) is read into the same draft, in order.
// scenarios/README.md describes the keys. Read scenario_reader.h before.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiment/scenario/scenario.h"
#include "experiment/scenario/scenario_reader.h"

namespace jaywalk {

/// A scenario that is being read.
struct ScenarioDraft {
  Scenario scenario;
  /// In metres per second; takes the place of the speed in cells per tick.
  std::optional<double> speed_mps;
  /// The same of pedestrians, and of each actor.
  std::optional<double> pedestrian_mps;
  std::vector<std::optional<double>> actor_mps;
  /// The file with start cells, and where it was named.
  std::optional<std::string> start_cells_file;
  /// The file with assertions, and which of them to judge; all if none is named.
  std::optional<std::string> assertions_file;
  std::vector<std::pair<std::string, ValueOrigin>> judged;
  /// The files of policies, and where each was named.
  std::vector<std::pair<std::string, ValueOrigin>> policy_files;
  /// Of learners by their names, and the assertions that rewards name.
  std::map<std::string, LearnerSettings> learner_settings;
  std::vector<std::pair<std::string, ValueOrigin>> rewarded;
  /// Where each key was given last, by its path.
  std::map<std::string, ValueOrigin> origins;
};

/// Reads one layer into the draft. `folder` is what paths in it are relative to ("" the current
/// one).
void read_layer(const ConfigNode& root, const std::string& folder, ScenarioDraft& draft,
                Diagnostics& diagnostics);

/// `folder`/`path`, or `path` if that is absolute.
[[nodiscard]] std::string path_in(const std::string& folder, const std::string& path);

/// The file of a program: as path_in, or an installed one, by its name in `$jaywalk/` or, without
/// folder and `.asl`, as a behaviour (`proximity`).
[[nodiscard]] std::string program_path(const std::string& folder, const std::string& text);
/// `$jaywalk/crossing/proximity.asl` for `proximity`.
[[nodiscard]] std::string installed_behaviour(std::string_view name);

/// The name of a program's behaviour: its file name without folder and `.asl`.
[[nodiscard]] std::string behaviour_name(const std::string& program);

}  // namespace jaywalk

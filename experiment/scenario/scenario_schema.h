// SPDX-License-Identifier: Apache-2.0
#pragma once

// The keys of a scenario: each layer (preset, file, option) is read into the same draft, in order.
// docs/reference/scenarios.md describes the keys. Read env/world/world_section.h first.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "env/config/parameter_settings.h"
#include "env/config/section_reader.h"
#include "env/vehicle/vehicle_section.h"
#include "env/world/world_section.h"
#include "experiment/scenario/scenario.h"

namespace jaywalk {

/// A scenario that is being read.
struct ScenarioDraft {
  Scenario scenario;
  /// The name of its world, and what reads the world's section.
  std::string_view world_kind;
  std::unique_ptr<WorldSection> world;
  /// The file with assertions, and which of them to judge; all if none is named.
  std::optional<std::string> assertions_file;
  std::vector<std::pair<std::string, ValueOrigin>> judged;
  /// The files of policies, and where each was named.
  std::vector<std::pair<std::string, ValueOrigin>> policy_files;
  /// The file that says which situations tests can meet, and where it was named.
  std::optional<std::pair<std::string, ValueOrigin>> reachable_file;
  /// The settings of learners by their names, and the assertions that rewards name.
  std::map<std::string, LearnerSettings> learner_settings;
  std::vector<std::pair<std::string, ValueOrigin>> rewarded;
};

/// Reads one layer into the draft. `folder` is what paths in it are relative to ("" the current
/// one).
void read_layer(const ConfigNode& root, const std::string& folder, ScenarioDraft& draft,
                Diagnostics& diagnostics);

/// The name of a program's behaviour: its file name without folder and `.asl`.
[[nodiscard]] std::string behaviour_name(const std::string& program);

/// The common base of the readers of a layer's parts.
class LayerPart : protected SectionReader {
 protected:
  LayerPart(const std::string& folder, ScenarioDraft& draft, Diagnostics& diagnostics)
      : SectionReader({folder, draft.scenario.files, draft.scenario.origins, diagnostics}),
        folder_(folder),
        draft_(draft) {}

  const std::string& folder_;
  ScenarioDraft& draft_;
};

/// Reads the value of a key into the draft.
using PartReader = void(const ConfigNode& node, const std::string& path, const std::string& folder,
                        ScenarioDraft& draft, Diagnostics& diagnostics);

/// The keys `learning` and `policy`.
PartReader read_learning, read_policies;

}  // namespace jaywalk

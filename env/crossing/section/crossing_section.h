// SPDX-License-Identifier: Apache-2.0
#pragma once

// A crossing world while a scenario's section is being read, and the base of the readers of its
// parts. Read ../parameters.h and env/world/world_section.h first.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "env/config/section_reader.h"
#include "env/crossing/parameters.h"
#include "env/environments.h"
#include "env/grid/start_cells.h"
#include "env/world/world_section.h"

namespace jaywalk {

struct CrossingDraft {
  CrossingParameters world;
  /// The AV's speed in metres per second, if given; replaces the speed in cells per tick.
  std::optional<double> speed_mps;
  /// The speeds of pedestrians and of each actor in metres per second, if given.
  std::optional<double> pedestrian_mps;
  std::vector<std::optional<double>> actor_mps;
  /// The agents of the world's actors, in the same order.
  std::vector<WorldAgent> agents;
  /// The file with start cells, and its content.
  std::optional<std::string> start_cells_file;
  std::shared_ptr<const StartCells> start_cells;
};

class CrossingPart : protected SectionReader {
 protected:
  CrossingPart(const SectionContext& context, CrossingDraft& draft)
      : SectionReader(context), draft_(draft) {}

  [[nodiscard]] CrossingParameters& world() { return draft_.world; }

  CrossingDraft& draft_;
};

/// Reads the value of a key into the draft.
using CrossingPartReader = void(const ConfigNode& node, const std::string& path,
                                const SectionContext& context, CrossingDraft& draft);

/// The keys that are read in files of their own.
CrossingPartReader read_bands, read_map, read_crosswalks, read_obstacles, read_actors, read_av;

[[nodiscard]] std::unique_ptr<WorldSection> crossing_section();

[[nodiscard]] std::span<const Preset> crossing_presets();

}  // namespace jaywalk

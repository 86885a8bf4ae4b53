// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a world reads its section of a scenario, the key `world`: layer upon layer (preset, file,
// options), each into the same draft, then it is checked and finished. Read world_spec.h and
// env/config/section_reader.h first.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "env/config/parameter_settings.h"
#include "env/config/section_reader.h"
#include "env/world/world_spec.h"

namespace jaywalk {

/// An agent that a world has besides those under comparison.
struct WorldAgent {
  std::string name;
  /// The file of its program.
  std::string program;
  std::vector<ParameterSetting> parameters;
  ValueOrigin origin;
};

class WorldSection {
 public:
  virtual ~WorldSection() = default;
  /// Reads the section of one layer; `path` is that of the section. The keys `common` belong to all
  /// worlds, and come before the world's own.
  virtual void read(const ConfigNode& node, const std::string& path, const SectionContext& context,
                    std::span<const ConfigKey> common) = 0;
  /// Reports what does not fit together, once all layers are read; `scenario` is its name.
  virtual void check(const std::string& scenario, const SectionContext& context) = 0;
  /// Reads the files that it names. `sources` receives their texts.
  virtual void read_files(const SectionContext& /*context*/, std::vector<SourcePtr>& /*sources*/) {}
  /// The commands that tests start and files that they read, whose words may be replaced by those
  /// of copies until it is finished.
  [[nodiscard]] virtual std::vector<std::vector<std::string>*> commands() { return {}; }
  /// The world's other agents, in their order.
  [[nodiscard]] virtual std::vector<WorldAgent> agents() const { return {}; }
  /// Models of the AV that tests can be run with (`experiment.avs`).
  [[nodiscard]] virtual std::vector<std::string> av_models() const = 0;
  /// REQUIRES: nothing was wrong.
  [[nodiscard]] virtual std::shared_ptr<const WorldSpec> finish() const = 0;
};

}  // namespace jaywalk

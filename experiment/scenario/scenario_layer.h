#pragma once

// The draft that the readers of a scenario's parts fill in. Read scenario_schema.h first.

#include <string>
#include <string_view>
#include <vector>

#include "env/config/parameter_settings.h"
#include "env/config/section_reader.h"
#include "env/vehicle/section.h"
#include "experiment/scenario/scenario_schema.h"

namespace jaywalk {

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

/// The key `world` of a layer: the keys that all worlds have, and the world's own.
PartReader read_world;
/// The keys `learning` and `policy`.
PartReader read_learning, read_policies;

}  // namespace jaywalk

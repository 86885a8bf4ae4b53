#pragma once

// Values that scenarios of a world can begin with.

#include <string_view>

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

}  // namespace jaywalk

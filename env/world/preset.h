#pragma once

// Values that scenarios of a world can begin with.

#include <string_view>

namespace jaywalk {

/// Whether the published results are of the world and the parameters that a preset describes.
enum class PresetResults { published, other };

/// Values that a scenario begins with, by name. `text` is what a scenario would say; what it says
/// of behaviours goes to those of these names that the scenario has.
struct Preset {
  std::string_view name;
  std::string_view summary;
  std::string_view text;
  PresetResults results = PresetResults::other;
};

}  // namespace jaywalk

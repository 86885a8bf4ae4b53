#pragma once

// The presets of the crossing world.

#include <span>

#include "env/world/preset.h"

namespace jaywalk {

[[nodiscard]] std::span<const Preset> crossing_presets();

}  // namespace jaywalk

#pragma once

// The reader of the crossing's section of a scenario.

#include <memory>

#include "env/world/world_section.h"

namespace jaywalk {

[[nodiscard]] std::unique_ptr<WorldSection> crossing_section();

}  // namespace jaywalk

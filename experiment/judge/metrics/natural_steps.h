#pragma once

// How natural a road user's steps are: a person would hardly turn straight back, or stand still in
// the road.

#include "experiment/judge/signals/signals.h"

namespace jaywalk {

/// Whether a person might take the step that led to this tick's state. REQUIRES: tick > 0.
[[nodiscard]] bool is_natural_step(const TestView& view, ActorIndex actor, std::size_t tick);

}  // namespace jaywalk

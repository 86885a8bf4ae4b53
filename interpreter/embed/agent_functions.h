// SPDX-License-Identifier: Apache-2.0
#pragma once

// The engine's side of <jaywalk/agent_class.h>.

#include <memory>

#include "interpreter/agent/surroundings/customisation.h"
#include <jaywalk/agent_class.h>

namespace jaywalk {

/// Null if none of the functions is set.
[[nodiscard]] std::shared_ptr<const Customisation> customisation_of(AgentClass functions);

[[nodiscard]] EventView view_of(const Event& event);
[[nodiscard]] IntentionView view_of(const Intention& intention);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "interpreter/explain/explanation.h"

namespace jaywalk {

/// An array with an object for each deliberation.
[[nodiscard]] std::string explanation_json(std::span<const Deliberation> deliberations);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Expressions of assertions that stand in YAML, with the place in the file of each of their bytes:
// for readers of assertions (assertion_file.cpp) and of other requirements.

#include "env/config/reader.h"
#include "experiment/judge/assertions/expression.h"

namespace jaywalk {

/// REQUIRES: a scalar.
[[nodiscard]] stl::ExpressionText expression_text(const ConfigNode& node);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The engine's results as <jaywalk/scenario.h> and <jaywalk/comparison.h> have them.

#include "experiment/compare/comparison.h"
#include "experiment/compare/test_assessment.h"
#include "experiment/test_run/test_run.h"
#include <jaywalk/comparison.h>

namespace jaywalk {

/// A recording and its judgement. The outcome is left to the caller.
[[nodiscard]] TestReport report_of(const Recording& recording, const Criteria& criteria,
                                   const Ground& ground);
[[nodiscard]] ComparisonReport report_of(const Comparison& comparison);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// What <jaywalk/scenario.h> and its siblings have in common: the engine's results as they have
// them, and the files that they read.

#include <string>

#include "experiment/compare/comparison.h"
#include "experiment/compare/test_assessment.h"
#include "experiment/test_run/test_run.h"
#include <jaywalk/comparison.h>

namespace jaywalk {

/// A recording and its judgement. The outcome is left to the caller.
[[nodiscard]] TestReport report_of(const Recording& recording, const Criteria& criteria,
                                   const Ground& ground);
[[nodiscard]] ComparisonReport report_of(const Comparison& comparison);

/// The test, with the head start that the tests before it leave. Errors: there is no such test, or
/// it was interrupted.
[[nodiscard]] Result<TestSetup> setup_of(const RunnableScenario& scenario,
                                         const TestChoice& choice);

/// The files that a scenario or search may read; `data_folder` as in ScenarioChoice.
[[nodiscard]] SourceFiles readable_files(const std::string& data_folder,
                                         const ProgramFolders& folders);

}  // namespace jaywalk

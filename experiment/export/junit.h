#pragma once

// Verdicts as JUnit XML, which continuous integration reads.

#include <span>
#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

/// A suite for each assertion, a case for each behaviour and number of agents: failed if some test
/// violated it, skipped if no test exercised it.
[[nodiscard]] std::string to_junit(const Comparison& comparison);
/// A suite for one test, called `name`, a case for each assertion.
[[nodiscard]] std::string to_junit(const std::string& name, const Criteria& criteria,
                                   const TestAssessment& assessment);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenarios from text, for the tests of this folder.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiment/scenario/scenario.h"

namespace jaywalk::testing_scenario {

inline Result<Scenario> parse(std::string text, const ScenarioOptions& options = {}) {
  return parse_scenario(std::make_shared<const Source>("folder/test.yaml", std::move(text)),
                        options);
}

/// A scenario with one behaviour and settings as given to `--set`.
inline Result<Scenario> with(std::vector<std::string> sets) {
  ScenarioOptions options;
  options.sets = std::move(sets);
  return parse("behaviours: [walk.asl]\n", options);
}

/// The diagnostics as the user sees them, or the empty text.
inline std::string errors(const Result<Scenario>& result) {
  return result.ok() ? "" : result.diagnostics().render();
}

}  // namespace jaywalk::testing_scenario

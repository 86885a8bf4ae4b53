// SPDX-License-Identifier: Apache-2.0
#pragma once

// Worlds that reports are about, for the tests of sections that draw on their ground.

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "experiment/test_run/prepared_scenario.h"

namespace jaywalk::reporting {

/// A scenario of one behaviour, agents/crossing/NAME.asl, with more keys and a policy's text.
inline std::shared_ptr<const PreparedScenario> world_of(const std::string& name,
                                                        const std::string& more = {},
                                                        const std::string& policy = {}) {
  auto scenario = parse_scenario(std::make_shared<const Source>(
      "s.yaml", "behaviours: [" JAYWALK_SOURCE_DIR "/agents/crossing/" + name + ".asl]\n" + more));
  EXPECT_TRUE(scenario.ok()) << scenario.diagnostics().render();
  if (!policy.empty()) {
    scenario.value().policies.push_back(std::make_shared<const Source>("p.json", policy));
  }
  Diagnostics warnings;
  auto prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings);
  EXPECT_TRUE(prepared.ok()) << prepared.diagnostics().render();
  return prepared.value();
}

}  // namespace jaywalk::reporting

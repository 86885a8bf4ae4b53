#pragma once

// The page that plays a stored test. Read player.h first.

#include <optional>
#include <string>

#include "experiment/results/reader.h"

namespace jaywalk {

/// `election, 3 agents, seed 0, test 5`.
[[nodiscard]] std::string name_of(const ResultsReader& store, const StoredTest& test);

/// Of a test with a defect the same test of the healthy AV; nothing of others.
[[nodiscard]] Result<std::optional<Recording>> twin_recording(const ResultsReader& store,
                                                              const StoredTest& test);

/// Runs the test again, so that all minds can be seen. Error: it comes out otherwise than stored.
[[nodiscard]] Result<std::string> replay_page(const ResultsReader& store, const StoredTest& test);

}  // namespace jaywalk

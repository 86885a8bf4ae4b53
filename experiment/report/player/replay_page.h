#pragma once

// The page that plays a stored test. Read player.h first.

#include <optional>
#include <string>

#include "experiment/results/reader.h"

namespace jaywalk {

/// `election, 3 agents, seed 0, test 5`.
[[nodiscard]] std::string name_of(const ResultsReader& store, const StoredTest& test);

/// The recording of the same test with the healthy AV; nothing if the test has no defect.
[[nodiscard]] Result<std::optional<Recording>> twin_recording(const ResultsReader& store,
                                                              const StoredTest& test);

/// Runs the test again to record all beliefs and intentions. Error: its result differs from the
/// stored one.
[[nodiscard]] Result<std::string> replay_page(const ResultsReader& store, const StoredTest& test);

}  // namespace jaywalk

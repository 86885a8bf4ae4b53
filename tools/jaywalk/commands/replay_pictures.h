// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures of a stored test. The libraries that draw take longer to load than most commands to run,
// so `jaywalk` is not linked with them: for pictures it executes `jaywalk-draw` beside it, the same
// command with those libraries.

#include <cstdint>
#include <optional>

#include "experiment/results/reader.h"
#include "tools/jaywalk/commands/command.h"

namespace jaywalk {

struct ReplayWishes {
  /// The picture's tick; by default that of the first event, or the last tick if there is none.
  std::optional<std::uint64_t> tick;
  /// Ticks per second.
  double speed = 2;
};

/// Writes what --png and --gif name. In `jaywalk` it returns only if `jaywalk-draw` cannot be run.
[[nodiscard]] ExitCode write_pictures(const ResultsReader& store, const StoredTest& test,
                                      const ReplayWishes& wanted, const Arguments& arguments,
                                      Console& console);

}  // namespace jaywalk

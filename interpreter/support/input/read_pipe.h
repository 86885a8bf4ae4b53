// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads a named pipe, or the pipe of a shell's `<(command)`.

#include <chrono>
#include <cstddef>
#include <string>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// All that is written to the pipe; reading stops as soon as there are more than `max_bytes`.
/// Errors: it cannot be opened, or no process has opened it for writing when `patience` ends. A
/// writer that takes its time is waited for.
[[nodiscard]] Result<std::string> read_pipe(
    const std::string& path, std::size_t max_bytes,
    std::chrono::milliseconds patience = std::chrono::seconds(2));

}  // namespace jaywalk

#pragma once

// Reads a named pipe, or what a shell's `<(command)` is.

#include <cstddef>
#include <string>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// All that is written to the pipe; reading stops as soon as there are more than `max_bytes`.
/// Errors: it cannot be opened, or nobody opens it for writing within two seconds. A writer that
/// takes its time is waited for.
[[nodiscard]] Result<std::string> read_pipe(const std::string& path, std::size_t max_bytes);

}  // namespace jaywalk

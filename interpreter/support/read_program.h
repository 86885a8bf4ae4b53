#pragma once

// Programs in other encodings than UTF-8, of which there are many: Jason reads them all the same.

#include <string>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// Like read_source(), but invalid UTF-8 is read as U+FFFD, which may stand in comments, strings
/// and quoted atoms; a warning points at the first such byte.
[[nodiscard]] Result<SourcePtr> read_any_encoding(const std::string& path,
                                                  Diagnostics& diagnostics);

}  // namespace jaywalk

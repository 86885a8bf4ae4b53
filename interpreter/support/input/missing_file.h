#pragma once

#include <string>

namespace jaywalk {

/// Of a path where there is no file, "did you mean 'x'?": a file of that name one folder below,
/// else one of the same kind with a like name in the same folder. An empty text if there is
/// neither, or the folder has more than 10,000 entries.
[[nodiscard]] std::string hint_for_missing(const std::string& path);

}  // namespace jaywalk

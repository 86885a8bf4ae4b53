// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jaywalk {

/// For a path where there is no file, "did you mean 'x'?": a file of that name one folder below or
/// in a folder with a like name, one of that name with an ending, or else one of the same kind with
/// a like name in the same folder. What is looked for in vain from here is looked for below `root`,
/// too. An empty text if there is none, or the folder has more than 10,000 entries.
[[nodiscard]] std::string hint_for_missing(const std::string& path, const std::string& root = {});

}  // namespace jaywalk

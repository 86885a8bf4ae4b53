// SPDX-License-Identifier: Apache-2.0
#pragma once

// The text of a program: its digest, and its length, a measure of the effort to write a behaviour
// (metric M6).

#include <cstdint>
#include <string>
#include <string_view>

#include "interpreter/syntax/load.h"

namespace jaywalk {

/// 64 hexadecimal digits (FIPS 180-4).
[[nodiscard]] std::string sha256(std::string_view text);

/// Lines that hold more than blanks and comments.
[[nodiscard]] std::uint64_t code_lines(const SourcePtr& program);

/// Code lines of a program and all that it includes, each file counted once.
[[nodiscard]] std::uint64_t code_lines(const SourceTree& tree);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The checker's warnings about small programs, as text.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/check/check.h"

namespace jaywalk {

struct Row {
  const char* text;
  const char* warnings;
};

/// The vocabulary of an agent among others, in an unknown world.
[[nodiscard]] Vocabulary nothing_known();

/// The warnings as `line: code: message (hint)`, a line each, but for those of variables that occur
/// once: most programs of the tests have some.
[[nodiscard]] std::string warnings_of(const std::string& text,
                                      const Vocabulary& vocabulary = nothing_known());

/// The warnings of one code as `line:column message`.
[[nodiscard]] std::string warnings_of(std::string_view code, const std::string& text,
                                      const Vocabulary& vocabulary = nothing_known());

/// Names and texts of files that a program includes.
using Included = std::vector<std::pair<std::string, std::string>>;

/// Like warnings_of(text), but for a program that includes other files. Warnings in these begin
/// with the file's name.
[[nodiscard]] std::string warnings_with(const Included& included, const std::string& text,
                                        const Vocabulary& vocabulary = nothing_known());

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Java's String.format, as far as `.printf` needs it: numbers are doubles, everything else is text.

#include <span>
#include <string>
#include <string_view>

namespace jaywalk::actions {

struct FormatArgument {
  enum class Kind { number, truth, text };
  Kind kind = Kind::text;
  double number = 0;
  std::string text;  // as %s shows it
};

/// Appends to `out`; false if the format and the arguments do not fit: `error` says why.
[[nodiscard]] bool format_as_java(std::string_view format, std::span<const FormatArgument> args,
                                  std::string& out, std::string& error);

}  // namespace jaywalk::actions

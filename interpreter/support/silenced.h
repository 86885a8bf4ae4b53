#pragma once

// The comments that silence warnings: `// jaywalk: allow CODE` in its line and the next one,
// `// jaywalk: allow-file CODE` in the whole file. Several codes are separated by commas.

#include <cstdint>
#include <string_view>
#include <vector>

#include "interpreter/support/source.h"

namespace jaywalk {

/// A code that a comment of a text allows.
struct AllowedCode {
  std::string_view code;  // part of the source's text
  Span span;
  std::uint32_t line = 0;
  bool in_whole_file = false;
};

/// The codes of all such comments, in the order of the text.
[[nodiscard]] std::vector<AllowedCode> allowed_codes(const Source& source);

/// Whether a comment silences the warning of that code at a place.
[[nodiscard]] bool is_silenced(const Source& source, std::uint32_t offset, std::string_view code);

}  // namespace jaywalk

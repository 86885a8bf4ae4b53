#pragma once

// Characters that word processors and web pages substitute for plain ones.

#include <string_view>

namespace jaywalk {

struct Typographic {
  std::string_view text;
  std::string_view meant;  // the quotes; else empty
  std::string_view hint;
};

/// The one that a text begins with, or null.
[[nodiscard]] const Typographic* typographic_at(std::string_view text);

}  // namespace jaywalk

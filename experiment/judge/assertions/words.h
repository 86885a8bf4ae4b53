#pragma once

// The words of assertions' expressions, and suggestions for words of other languages.

#include <string>
#include <string_view>

namespace jaywalk::stl {

/// Letters, digits and `_`.
[[nodiscard]] bool is_word_character(char c);

/// Keywords, which are no names.
[[nodiscard]] bool is_reserved(std::string_view word);

/// A hint on how to write an operator of another language here; empty if it is not known.
[[nodiscard]] std::string hint_for(std::string_view rest);

/// A keyword that the last word of a text may be a slip for; empty if there is none.
[[nodiscard]] std::string keyword_hint(std::string_view before);

}  // namespace jaywalk::stl

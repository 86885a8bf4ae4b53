// SPDX-License-Identifier: Apache-2.0
#pragma once

// Texts as Java sees them. Ours are UTF-8; where a program can count characters or name one by its
// index, it counts UTF-16 units, as in Java.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace jaywalk::actions {

/// The character that begins at a byte; `size` receives its bytes. A byte that begins no character
/// stands for itself.
[[nodiscard]] char32_t character_at(std::string_view text, std::size_t byte, std::size_t& size);
void append_character(std::string& out, char32_t character);

[[nodiscard]] std::size_t utf16_length(std::string_view text);
/// The byte at which a UTF-16 unit begins; the end of the text if there are fewer. A unit within a
/// pair of surrogates is taken for the next character.
[[nodiscard]] std::size_t byte_of_unit(std::string_view text, std::size_t unit);
/// The units from `begin` up to `end`. REQUIRES: begin <= end.
[[nodiscard]] std::string_view utf16_slice(std::string_view text, std::size_t begin,
                                           std::size_t end);

[[nodiscard]] char32_t lower_case_of(char32_t character);
[[nodiscard]] char32_t upper_case_of(char32_t character);
[[nodiscard]] std::string lower_case_text(std::string_view text);
[[nodiscard]] std::string upper_case_text(std::string_view text);

/// Java's narrowing of a double to an int: towards zero, saturating, not a number to 0.
[[nodiscard]] std::int32_t java_int(double value);

}  // namespace jaywalk::actions

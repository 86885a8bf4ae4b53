// SPDX-License-Identifier: Apache-2.0
#pragma once

// Terms as text, exactly as Jason prints them.

#include <cstddef>
#include <string>
#include <string_view>

#include "interpreter/term/heap.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

/// No term and no action makes a longer text.
inline constexpr std::size_t kMaxTextBytes = std::size_t{64} << 20U;

/// Java's text of a double where it is whole and fits a long, as an integer: `3`, `0.1`,
/// `1.23456785E7`, `1.0E20`, `NaN`, `Infinity`; -0.0 is `0`.
void append_number(std::string& out, double value);
[[nodiscard]] std::string number_text(double value);

/// Appends a term. Strings stand in quotes, their content as it is; bound variables are followed,
/// unbound ones have their names, or are `_1`, `_2`, ... in the order of the text.
/// Throws HeapExhausted if the text is longer than kMaxTextBytes, as the following do.
void append_term(std::string& out, Value term, const SymbolTable& symbols);
[[nodiscard]] std::string term_text(Value term, const SymbolTable& symbols);

/// So many bytes of a term, a message or a formula stand in the log.
inline constexpr std::size_t kLongestLogged = 1000;

/// For people: the beginning of a term's text, at most `most` bytes, and "..." if that is not all.
/// It takes no longer for terms whose whole text no memory holds.
[[nodiscard]] std::string brief_text(Value term, const SymbolTable& symbols,
                                     std::size_t most = kLongestLogged);

/// Like brief_text(), with numbers rounded to 12 significant digits: 0.3 for 0.30000000000000004.
[[nodiscard]] std::string rounded_text(Value term, const SymbolTable& symbols,
                                       std::size_t most = kLongestLogged);

/// The term as it would be written in a program: strings are escaped so that they read back.
[[nodiscard]] std::string source_text(Value term, const SymbolTable& symbols);

/// As `.print` and `.concat` show an argument: strings without quotes, an unbound variable as
/// `X<no-value>`.
void append_argument(std::string& out, Value term, const SymbolTable& symbols);

}  // namespace jaywalk

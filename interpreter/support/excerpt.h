#pragma once

// Places of a text for people, beside what diagnostics.h does with them.

#include <cstdint>
#include <string>
#include <string_view>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// The line of a place and below it the caret, each with a line break. REQUIRES: a source.
[[nodiscard]] std::string excerpt(const SourceSpan& where, Colour colour = Colour::off);

/// The offset of a position; the end of its line, or of the text, if there is no such position.
[[nodiscard]] std::uint32_t offset_of(const Source& source, Source::Position position);

/// The diagnostics with the warnings of that code turned into errors; `hint` is added to theirs.
[[nodiscard]] Diagnostics with_errors(const Diagnostics& diagnostics, std::string_view code,
                                      std::string_view hint);

}  // namespace jaywalk

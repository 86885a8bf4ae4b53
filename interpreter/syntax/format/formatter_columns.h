#pragma once

// Columns of a layout: neighbouring lines whose arrows, colons or comments stood in one column keep
// one, the first that is wide enough for all of them.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/syntax/lexer.h"

namespace jaywalk::format {

struct ColumnMark {
  /// `:`, `<-` or `:-`, or end_of_text for a comment behind a line.
  TokenKind kind = TokenKind::end_of_text;
  /// The line of the layout in which it was written, from 0.
  std::size_t line = 0;
  std::size_t offset = 0;
  /// In which column it stood before.
  std::size_t former_column = 0;
};

/// The text with blanks before the marks where that makes columns of them again; lines that would
/// be longer than `width` stay. The marks are in the order of the text.
[[nodiscard]] std::string with_columns(std::string text, std::vector<ColumnMark> marks,
                                       std::size_t width);

}  // namespace jaywalk::format

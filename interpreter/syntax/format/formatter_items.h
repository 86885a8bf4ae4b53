// SPDX-License-Identifier: Apache-2.0
#pragma once

// The input of the formatter: a program's tokens and comments, and the blanks and line breaks
// between them.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/syntax/ast.h"
#include "interpreter/syntax/lexer.h"

namespace jaywalk::format {

struct Item {
  TokenKind kind = TokenKind::end_of_text;  // of a comment: end_of_text
  std::string_view text;
  bool is_comment = false;
  bool is_line_comment = false;
  /// A blank before it, if it stands behind the previous token on a line.
  bool blank_before = false;
  /// A line may be broken before it.
  bool may_break = false;
  /// How many line breaks there were before it, up to two.
  int breaks_before = 0;
  /// In which column it stood, from 0.
  std::size_t column = 0;
  /// It begins a formula, on a line of its own, without a semicolon before it: only the line break
  /// keeps the two apart.
  bool begins_formula = false;
  /// For a bracket: the index of the matching bracket.
  std::size_t partner = 0;
};

/// The items of a program. REQUIRES: it has no mistakes.
[[nodiscard]] std::vector<Item> items_of(const ast::File& file);

/// Columns of a layout: neighbouring lines whose arrows, colons or comments stood in one column
/// keep one, the first that is wide enough for all of them.
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

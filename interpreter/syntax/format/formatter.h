// SPDX-License-Identifier: Apache-2.0
#pragma once

// The canonical layout of a program's text. It works on tokens and comments, not on the syntax
// tree: nothing but blanks is added or taken away, so the program stays the same and no comment is
// lost. Formatting what has been formatted changes nothing.
//
// - Lines have at most kLineWidth columns where that is possible; wrapped lines go on indented.
// - A plan or rule that was written on one line stays on one, if it fits. Others are laid out as
//
//     @label
//     +!goal(X) : context(X)
//       <- first;
//          if (condition) {
//            second
//          } else {
//            third
//          }.
//
// - Arrows, colons and comments behind lines that stand in one column in neighbouring lines keep
// one.
// - Where a semicolon is missing, the line break that stands for it stays.
// - At most one empty line stays where there was one, between components and between formulas.

#include <string>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

inline constexpr std::size_t kLineWidth = 100;

/// The text in its layout, or its errors: only valid programs are laid out.
[[nodiscard]] Result<std::string> format_agent(const SourcePtr& source);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Comments for the checker, `// jaywalk: WORD ITEMS`; several items are separated by commas.
//
//   allow CODE        silences that warning in its line and in the next one
//   allow-file CODE   in the whole file
//   asks NAME/ARITY   a program that includes the file must define that belief or rule, or with
//                     `!NAME/ARITY` have a plan for that goal

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <jaywalk/diagnostics.h>

namespace jaywalk {

/// One item of such a comment. The texts are parts of the source's text.
struct Remark {
  static constexpr std::string_view kAllow = "allow";
  static constexpr std::string_view kAllowFile = "allow-file";
  static constexpr std::string_view kAsks = "asks";

  /// One of the words above, or another word that was written instead.
  std::string_view word;
  Span word_span;
  std::string_view item;  // empty if no item follows the word
  Span item_span;
  std::uint32_t line = 0;

  [[nodiscard]] bool allows() const { return word == kAllow || word == kAllowFile; }
};

/// The items of all such comments, in the order of the text.
[[nodiscard]] std::vector<Remark> remarks(const Source& source);

/// Whether a comment silences the warning of that code at a place.
[[nodiscard]] bool is_silenced(const Source& source, std::uint32_t offset, std::string_view code);

/// A name that a file asks for.
struct AskedName {
  std::string_view name;
  int arity = 0;
  bool is_goal = false;
};

/// The name that an item stands for, `time_to_cross/0` or `!cross/1`; empty if it is written
/// otherwise.
[[nodiscard]] std::optional<AskedName> asked_name(std::string_view item);

}  // namespace jaywalk

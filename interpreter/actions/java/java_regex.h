// SPDX-License-Identifier: Apache-2.0
#pragma once

// Regular expressions in Java's syntax, matched by PCRE2. What PCRE2 reads otherwise than Java is
// translated or refused before: docs/reference/language/library.md lists the differences. Works on
// UTF-8, by characters.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace jaywalk::actions {

class Regex {
 public:
  /// Nothing if the pattern is not one; `error` then says why.
  [[nodiscard]] static std::optional<Regex> parse(std::string_view pattern, std::string& error);

  /// Whether the whole text matches. A text that is not UTF-8 does not, nor one that takes more
  /// steps than the limit: `error` then says so.
  [[nodiscard]] bool matches(std::string_view text, std::string& error) const;
  /// Java's replaceAll: `$1` and `${name}` in the replacement are groups, `\` quotes. Nothing if
  /// the replacement is wrong, the result too long, or for a text that does not match() with an
  /// error.
  [[nodiscard]] std::optional<std::string> replace_all(std::string_view text,
                                                       std::string_view replacement,
                                                       std::string& error) const;

  /// Sets a function that is called now and then during a search; an exception from it ends the
  /// search.
  void watch(std::function<void()> look) { look_ = std::move(look); }

 private:
  struct Code;
  class Search;

  explicit Regex(std::shared_ptr<const Code> code) : code_(std::move(code)) {}

  std::shared_ptr<const Code> code_;
  std::function<void()> look_;
};

}  // namespace jaywalk::actions

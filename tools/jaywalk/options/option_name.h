#pragma once

// The name of an option of the command line.

#include <string>
#include <string_view>

namespace jaywalk {

class OptionName {
 public:
  /// `text`: without dashes; must outlive this (a literal).
  explicit constexpr OptionName(std::string_view text) : text_(text) {}

  [[nodiscard]] constexpr std::string_view text() const { return text_; }
  /// The name as the user writes it and as messages show it: `--seed`.
  [[nodiscard]] std::string dashed() const { return "--" + std::string(text_); }

  friend bool operator==(const OptionName&, const OptionName&) = default;

 private:
  std::string_view text_;
};

}  // namespace jaywalk

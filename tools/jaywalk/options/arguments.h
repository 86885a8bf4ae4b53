// SPDX-License-Identifier: Apache-2.0
#pragma once

// The arguments of one command. Options may stand anywhere; `--` ends them; an option's value
// follows as `--name value` or `--name=value`. Read from the command line by arguments.cpp alone.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// The name of an option.
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

/// Whether a command writes to the place that an option names: a file, or a folder that it makes.
enum class Written { no, file, folder };

struct OptionSpec {
  OptionName name;
  /// The name of its value in the help, "N"; empty if it has no value.
  std::string_view value;
  std::string_view summary;
  /// Places are tried before the command begins.
  Written written = Written::no;

  /// Whether it may be given several times: its summary says so.
  [[nodiscard]] constexpr bool is_repeatable() const {
    return summary.find("repeatable") != std::string_view::npos;
  }
};

/// --help and its like, which every command has.
[[nodiscard]] std::span<const OptionSpec> common_options();

class Arguments {
 public:
  /// The words that are not options, in order.
  [[nodiscard]] const std::vector<std::string>& operands() const { return operands_; }
  [[nodiscard]] bool has(OptionName option) const;
  /// Some option has this value.
  [[nodiscard]] bool has_value(std::string_view value) const;
  /// Its value; the last one if it was repeated.
  [[nodiscard]] std::optional<std::string> text(OptionName option) const;
  /// All values, in order.
  [[nodiscard]] std::vector<std::string> texts(OptionName option) const;
  /// Adds an error and returns nothing if the value is no whole number from `low` to `high`.
  [[nodiscard]] std::optional<std::uint64_t> number(
      OptionName option, std::uint64_t low, Diagnostics& diagnostics,
      std::uint64_t high = std::numeric_limits<std::uint64_t>::max()) const;
  /// A number of seconds or the like, greater than zero and at most 10^9.
  [[nodiscard]] std::optional<double> positive(OptionName option, Diagnostics& diagnostics) const;
  /// One of several words; the first of them if the option is not given.
  [[nodiscard]] std::size_t choice(OptionName option, std::span<const std::string> words,
                                   Diagnostics& diagnostics) const;

 private:
  friend Result<Arguments> parse_arguments(std::span<const std::string> words,
                                           std::span<const OptionSpec> options);

  std::vector<std::string> operands_;
  std::vector<std::pair<std::string, std::string>> options_;
};

/// Unknown options, missing values and second values of an option that is not repeatable are
/// errors.
[[nodiscard]] Result<Arguments> parse_arguments(std::span<const std::string> words,
                                                std::span<const OptionSpec> options);

/// All values of an option, each a list separated by commas, as one list.
[[nodiscard]] std::vector<std::string> listed(const Arguments& arguments, OptionName option);

/// --threads: as many as cores unless it is given, and never more than make sense.
[[nodiscard]] unsigned read_threads(const Arguments& arguments, Diagnostics& diagnostics);

}  // namespace jaywalk

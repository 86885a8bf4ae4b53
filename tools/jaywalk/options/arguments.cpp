// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <thread>

#include <boost/program_options.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/scenario/number_list.h"
#include "interpreter/support/text.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {
namespace {

namespace po = boost::program_options;

std::string unknown_hint(std::string_view name, std::span<const OptionSpec> options) {
  const auto dashes = std::min(name.find_first_not_of('-'), name.size());
  std::vector<std::string> known;
  for (const OptionSpec& option : options) known.emplace_back(option.name.text());
  const auto meant = closest(name.substr(dashes), known);
  return meant ? fmt::format("did you mean '--{}'?", *meant) : "--help names the options";
}

template <class Number>
std::optional<Number> parse(const std::string& text) {
  Number value{};
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc{} || end != last) return std::nullopt;
  return value;
}

po::options_description description_of(std::span<const OptionSpec> options) {
  po::options_description description;
  for (const OptionSpec& option : options) {
    const std::string name(option.name.text());
    if (option.value.empty()) {
      description.add_options()(name.c_str(), "");
    } else {
      description.add_options()(name.c_str(), po::value<std::string>());
    }
  }
  return description;
}

/// A second value would hide the first.
void report_repeated(const Arguments& arguments, std::span<const OptionSpec> options,
                     Diagnostics& diagnostics) {
  for (const OptionSpec& option : options) {
    const std::vector<std::string> values = arguments.texts(option.name);
    if (values.size() < 2 || option.value.empty() || option.is_repeatable()) continue;
    diagnostics.error(option.name.dashed(), fmt::format("given {} times, with the values '{}'",
                                                        values.size(), fmt::join(values, "', '")));
  }
}

}  // namespace

std::span<const OptionSpec> common_options() {
  static constexpr std::array kOptions = {
      OptionSpec{option::kColor, "WHEN", "colours: auto (default), always or never"},
      OptionSpec{option::kLogLevel, "LEVEL",
                 "what is logged: error, warning (default), info or debug"},
      OptionSpec{option::kHelp, "", "show this help"},
  };
  return kOptions;
}

bool Arguments::has(OptionName option) const { return text(option).has_value(); }

bool Arguments::has_value(std::string_view value) const {
  return std::ranges::any_of(options_, [&](const auto& option) { return option.second == value; });
}

std::optional<std::string> Arguments::text(OptionName option) const {
  std::vector<std::string> all = texts(option);
  if (all.empty()) return std::nullopt;
  return std::move(all.back());
}

std::vector<std::string> Arguments::texts(OptionName option) const {
  std::vector<std::string> values;
  for (const auto& [name, value] : options_) {
    if (name == option.text()) values.push_back(value);
  }
  return values;
}

std::optional<std::uint64_t> Arguments::number(OptionName option, std::uint64_t low,
                                               Diagnostics& diagnostics, std::uint64_t high) const {
  const auto given = text(option);
  if (!given) return std::nullopt;
  const auto value = parse<std::uint64_t>(*given);
  if (value && *value >= low && *value <= high) return value;
  diagnostics.error(
      option.dashed(),
      fmt::format("expected a whole number from {} to {}, found '{}'", low, high, *given));
  return std::nullopt;
}

std::optional<double> Arguments::positive(OptionName option, Diagnostics& diagnostics) const {
  const auto given = text(option);
  if (!given) return std::nullopt;
  constexpr std::uint64_t kMost = 1'000'000'000;
  const auto value = parse<double>(*given);
  if (value && *value > 0 && *value <= kMost) return value;
  diagnostics.error(
      option.dashed(),
      fmt::format("expected a number greater than 0, at most {}, found '{}'", kMost, *given));
  return std::nullopt;
}

std::size_t Arguments::choice(OptionName option, std::span<const std::string> words,
                              Diagnostics& diagnostics) const {
  const auto given = text(option);
  if (!given) return 0;
  const auto found = std::ranges::find(words, *given);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  diagnostics.error(option.dashed(),
                    fmt::format("expected one of {}, found '{}'", fmt::join(words, ", "), *given),
                    did_you_mean(*given, words));
  return 0;
}

Result<Arguments> parse_arguments(std::span<const std::string> words,
                                  std::span<const OptionSpec> options) {
  using po::command_line_style::style_t;
  constexpr int kStyle = style_t::allow_long | style_t::long_allow_next |
                         style_t::long_allow_adjacent | style_t::allow_short |
                         style_t::short_allow_next | style_t::allow_dash_for_short;
  Diagnostics diagnostics;
  try {
    const po::options_description description = description_of(options);
    const auto parsed =
        po::command_line_parser(std::vector<std::string>(words.begin(), words.end()))
            .options(description)
            .style(kStyle)
            .run();
    Arguments arguments;
    for (const auto& option : parsed.options) {
      if (option.string_key.empty()) {
        arguments.operands_.insert(arguments.operands_.end(), option.value.begin(),
                                   option.value.end());
      } else {
        arguments.options_.emplace_back(option.string_key,
                                        option.value.empty() ? "" : option.value.front());
      }
    }
    report_repeated(arguments, options, diagnostics);
    if (diagnostics.has_errors()) return diagnostics;
    return arguments;
  } catch (const po::unknown_option& error) {
    const std::string written = error.get_option_name();
    const std::string name = written.substr(0, written.find('='));
    diagnostics.error(name, "unknown option", unknown_hint(name, options));
  } catch (const po::error_with_option_name& error) {
    const std::string name = error.get_option_name();
    const auto spec = std::ranges::find(
        options, name, [](const OptionSpec& option) { return option.name.dashed(); });
    const bool flag = spec != options.end() && spec->value.empty();
    diagnostics.error(name, flag ? "takes no value" : "needs a value");
  } catch (const po::error& error) {
    diagnostics.error("arguments", error.what());
  }
  return diagnostics;
}

std::vector<std::string> listed(const Arguments& arguments, OptionName option) {
  std::vector<std::string> items;
  for (const std::string& text : arguments.texts(option)) {
    std::string_view rest = text;
    while (true) {
      const std::size_t comma = rest.find(',');
      items.emplace_back(trimmed(rest.substr(0, comma)));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
  }
  return items;
}

unsigned read_threads(const Arguments& arguments, Diagnostics& diagnostics) {
  const auto cores = std::clamp<std::uint64_t>(std::thread::hardware_concurrency(), 1, kMaxThreads);
  return static_cast<unsigned>(
      arguments.number(option::kThreads, 1, diagnostics, kMaxThreads).value_or(cores));
}

}  // namespace jaywalk

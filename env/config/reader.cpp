// SPDX-License-Identifier: Apache-2.0
#include "env/config/reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

constexpr std::size_t kMaxShownText = 40;

template <class T>
std::optional<T> parse_whole(std::string_view text) {
  T value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string found(const ConfigNode& node) {
  switch (node.kind) {
    case ConfigNode::Kind::null:
      return "nothing";
    case ConfigNode::Kind::list:
      return "a list";
    case ConfigNode::Kind::map:
      return "keys and values";
    case ConfigNode::Kind::scalar:
      break;
  }
  if (node.text.size() <= kMaxShownText) return fmt::format("'{}'", node.text);
  return fmt::format("'{}...'", node.text.substr(0, kMaxShownText));
}

/// A number and what stands behind it: `50 km/h`.
struct NumberAndRest {
  double number = 0;
  std::string_view rest;
};

std::optional<NumberAndRest> split_number(std::string_view text) {
  NumberAndRest parts;
  const char* const last = text.data() + text.size();
  const auto [end, code] = std::from_chars(text.data(), last, parts.number);
  if (code != std::errc()) return std::nullopt;
  parts.rest = trimmed({end, static_cast<std::size_t>(last - end)});
  return parts;
}

bool has_unit(std::string_view text) {
  const auto parts = split_number(text);
  return parts && !parts->rest.empty() && std::ranges::all_of(parts->rest, [](unsigned char c) {
           return std::isalpha(c) != 0 || c == '/' || c == '%' || c >= 0x80U;
         });
}

/// In m/s.
std::optional<double> speed_with_unit(std::string_view text) {
  struct Unit {
    std::string_view name;
    double mps;
  };
  constexpr std::array kUnits = {Unit{"km/h", 1 / 3.6}, Unit{"kmh", 1 / 3.6}, Unit{"kph", 1 / 3.6},
                                 Unit{"m/s", 1},        Unit{"mps", 1},       Unit{"mph", 0.44704}};
  const auto parts = split_number(text);
  if (!parts) return std::nullopt;
  const auto unit = std::ranges::find(kUnits, parts->rest, &Unit::name);
  return unit == kUnits.end() ? std::nullopt : std::optional(parts->number * unit->mps);
}

}  // namespace

const ConfigNode* ConfigNode::find(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const ConfigEntry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

void report(Diagnostics& diagnostics, const ValueOrigin& origin, std::string message,
            std::string hint) {
  if (origin.where.source) {
    diagnostics.error(origin.where, std::move(message), std::move(hint));
  } else {
    diagnostics.error(origin.option, std::move(message), std::move(hint));
  }
}

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> value = parse_whole<double>(text);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  return parse_whole<std::int64_t>(text);
}

void ConfigReader::error(const ValueOrigin& origin, std::string message, std::string hint) const {
  report(diagnostics_, origin, std::move(message), std::move(hint));
}

void ConfigReader::error_in(const ValueOrigin& origin, const Diagnostics& found) const {
  for (const Diagnostic& each : found.items()) {
    if (each.where.source != nullptr) {
      diagnostics_.add(each);
    } else {
      error(origin,
            fmt::format("the scenario cannot be read: {}{}{}", each.subject,
                        each.subject.empty() ? "" : ": ", each.message),
            each.hint);
    }
  }
}

void ConfigReader::unexpected(const ConfigNode& node, std::string_view expected,
                              std::string hint) const {
  error(node.origin, fmt::format("expected {}, found {}", expected, found(node)), std::move(hint));
}

void ConfigReader::report_choice(const ConfigNode& node, std::span<const std::string> words) const {
  unexpected(node, fmt::format("{}", fmt::join(words, " or ")), did_you_mean(node.text, words));
}

void ConfigReader::read_map(const ConfigNode& node, const std::string& path,
                            std::span<const ConfigKey> keys) const {
  std::vector<std::string> names;
  for (const ConfigKey& key : keys) names.emplace_back(key.name);
  if (node.kind != ConfigNode::Kind::map) {
    unexpected(node, fmt::format("keys and values ({})", fmt::join(names, ", ")));
    return;
  }
  for (const ConfigKey& key : keys) {
    const ConfigNode* value = node.find(key.name);
    if (value == nullptr) continue;
    key.read(*value, path.empty() ? std::string(key.name) : fmt::format("{}.{}", path, key.name));
  }
  for (const ConfigEntry& entry : node.entries) {
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    std::string hint = did_you_mean(entry.key, names);
    if (hint.empty()) hint = fmt::format("the keys here are {}", fmt::join(names, ", "));
    error(entry.origin,
          path.empty() ? fmt::format("unknown key '{}'", entry.key)
                       : fmt::format("unknown key '{}' in '{}'", entry.key, path),
          std::move(hint));
  }
}

std::optional<double> ConfigReader::number(const ConfigNode& node, NumberRange range) const {
  const std::optional<double> value =
      node.kind == ConfigNode::Kind::scalar ? parse_number(node.text) : std::nullopt;
  if (value && *value >= range.least && *value <= range.most) return value;
  unexpected(node, fmt::format("a number from {} to {}", range.least, range.most),
             has_unit(node.text) ? "write the number alone, without its unit" : "");
  return std::nullopt;
}

std::optional<double> ConfigReader::speed(const ConfigNode& node, NumberRange range,
                                          std::string_view mps_key) const {
  const std::optional<double> mps = speed_with_unit(node.text);
  if (!mps) return number(node, range);
  unexpected(node, fmt::format("a number from {} to {}", range.least, range.most),
             fmt::format("for that speed write '{}: {:.4g}', in m/s", mps_key, *mps));
  return std::nullopt;
}

std::optional<std::int64_t> ConfigReader::integer(const ConfigNode& node,
                                                  IntegerRange range) const {
  const std::optional<std::int64_t> value =
      node.kind == ConfigNode::Kind::scalar ? parse_integer(node.text) : std::nullopt;
  if (value && *value >= range.least && *value <= range.most) return value;
  unexpected(node, fmt::format("a whole number from {} to {}", range.least, range.most));
  return std::nullopt;
}

std::optional<std::string> ConfigReader::text(const ConfigNode& node,
                                              std::string_view expected) const {
  if (node.kind == ConfigNode::Kind::scalar && !node.text.empty()) return node.text;
  unexpected(node, expected);
  return std::nullopt;
}

std::optional<Interval> ConfigReader::interval(const ConfigNode& node, IntegerRange range) const {
  if (node.kind != ConfigNode::Kind::list || node.items.size() != 2) {
    unexpected(node, "two whole numbers, [first, last]");
    return std::nullopt;
  }
  const std::optional<std::int64_t> first = integer(node.items[0], range);
  const std::optional<std::int64_t> last = integer(node.items[1], range);
  if (!first || !last) return std::nullopt;
  if (*first > *last) {
    error(node.origin,
          fmt::format("the first number, {}, is greater than the last, {}", *first, *last));
    return std::nullopt;
  }
  return Interval{static_cast<int>(*first), static_cast<int>(*last)};
}

std::optional<std::array<double, 2>> ConfigReader::number_pair(const ConfigNode& node,
                                                               NumberRange range,
                                                               PairOrder order) const {
  if (node.kind != ConfigNode::Kind::list || node.items.size() != 2) {
    unexpected(node, order == PairOrder::any ? "two numbers" : "two numbers, [from, to]");
    return std::nullopt;
  }
  const std::optional<double> from = number(node.items[0], range);
  const std::optional<double> to = number(node.items[1], range);
  if (!from || !to) return std::nullopt;
  if (order == PairOrder::rising && *from > *to) {
    error(node.origin,
          fmt::format("the first number, {}, is greater than the second, {}", *from, *to));
    return std::nullopt;
  }
  return std::array{*from, *to};
}

}  // namespace jaywalk

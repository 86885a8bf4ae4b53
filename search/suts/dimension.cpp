// SPDX-License-Identifier: Apache-2.0
#include "search/suts/dimension.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace jaywalk::search {
namespace {

constexpr NumberRange kAnyNumber{-1e6, 1e6};

std::optional<Dimension> read_word_list(const ConfigNode& node, const ConfigReader& reader) {
  Dimension dimension{.kind = Dimension::Kind::word};
  for (const ConfigNode& item : node.items) {
    const auto word = reader.text(item, "a word");
    if (!word) return std::nullopt;
    dimension.words.push_back(*word);
  }
  return dimension;
}

}  // namespace

std::size_t choice(double value, std::size_t count) {
  const double share = std::clamp((value + 1) / 2, 0.0, 1.0);
  return std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)));
}

std::size_t Dimension::distinct_values() const {
  switch (kind) {
    case Kind::word:
      return words.size();
    case Kind::whole:
      return static_cast<std::size_t>((std::lround(to) - std::lround(from)) / step) + 1;
    case Kind::number:
      break;
  }
  return 0;
}

double Dimension::number(double value) const {
  if (kind == Kind::whole) {
    const auto steps = static_cast<long>(choice(value, distinct_values()));
    return static_cast<double>(std::lround(from) + steps * step);
  }
  return from + (to - from) * (value + 1) / 2;
}

std::string Dimension::text(double value) const {
  switch (kind) {
    case Kind::word:
      return words[choice(value, words.size())];
    case Kind::whole:
      return fmt::format("{:.0f}", number(value));
    case Kind::number:
      break;
  }
  return fmt::format("{:.6g}", number(value));
}

bool read_bounds(const ConfigNode& node, const ConfigReader& reader, Dimension& dimension) {
  const auto numbers = reader.number_pair(node, kAnyNumber);
  if (!numbers) return false;
  dimension.from = (*numbers)[0];
  dimension.to = (*numbers)[1];
  return true;
}

std::vector<ConfigKey> whole_keys(Dimension& dimension, const ConfigReader& reader) {
  return {{"whole",
           [&](const ConfigNode& value, const std::string&) {
             if (read_bounds(value, reader, dimension)) dimension.kind = Dimension::Kind::whole;
           }},
          {"step", [&](const ConfigNode& value, const std::string&) {
             if (const auto step = reader.integer(value, {1, 1'000'000})) {
               dimension.step = static_cast<int>(*step);
             }
           }}};
}

std::optional<Dimension> read_dimension(const ConfigNode& node, const ConfigReader& reader) {
  Dimension dimension;
  if (node.find("whole") != nullptr) {
    reader.read_map(node, "parameters", whole_keys(dimension, reader));
    if (dimension.kind != Dimension::Kind::whole) return std::nullopt;
    return dimension;
  }
  const bool is_list = node.kind == ConfigNode::Kind::list && !node.items.empty();
  if (is_list && (node.items.size() != 2 || !parse_number(node.items.front().text))) {
    return read_word_list(node, reader);
  }
  if (!read_bounds(node, reader, dimension)) return std::nullopt;
  return dimension;
}

}  // namespace jaywalk::search

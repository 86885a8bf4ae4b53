// SPDX-License-Identifier: Apache-2.0
#include "search/suts/crossing_space.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "experiment/scenario/scenario_schema.h"

namespace jaywalk::search {
namespace {

/// Numbers and atoms, which need not be read as a scenario's.
bool is_plain(const std::string& word) {
  return parse_number(word) || (is_atom(word) && word != "true" && word != "false");
}

/// The parameter that a dimension sets for all agents of the behaviour; empty: none.
std::string parameter_name(const Dimension& dimension, const std::string& behaviour) {
  const std::string above = fmt::format("behaviours.{}.parameters.", behaviour);
  if (!dimension.key.starts_with(above)) return {};
  if (!std::ranges::all_of(dimension.words, is_plain)) return {};
  std::string name = dimension.key.substr(above.size());
  return name.find('.') == std::string::npos ? name : std::string();
}

}  // namespace

CrossingSpace::CrossingSpace(std::vector<Dimension> dimensions, std::string behaviour,
                             CrossingStarts starts)
    : dimensions_(std::move(dimensions)),
      behaviour_(std::move(behaviour)),
      starts_(std::move(starts)) {
  for (const Dimension& each : dimensions_) {
    names_.push_back(parameter_name(each, behaviour_));
    distinct_.push_back(each.distinct_values());
  }
  for (std::uint32_t i = 0; i < starts_.searched; ++i) {
    distinct_.push_back(starts_.rows.size());
    distinct_.push_back(std::ranges::max(starts_.cells, {}, &std::vector<int>::size).size());
  }
  if (!starts_.given.empty()) distinct_.push_back(starts_.given.size());
}

std::vector<std::size_t> CrossingSpace::distinct_values() const {
  // A space without dimensions is a single test.
  return distinct_.empty() ? std::vector<std::size_t>{1} : distinct_;
}

Validity CrossingSpace::check(const TestInput& input) const {
  if (input.form != Form::vector || input.values.size() != dimension()) {
    return {fmt::format("expected a vector of {} numbers", dimension())};
  }
  const bool within =
      std::ranges::all_of(input.values, [](double value) { return value >= -1 && value <= 1; });
  return {within ? "" : "a number is not from -1 to 1"};
}

TestInput CrossingSpace::draw_initial(Random& random) const {
  TestInput input{Form::vector, std::vector<double>(dimension())};
  for (double& value : input.values) value = random.uniform(-1, 1);
  return input;
}

std::vector<std::string> CrossingSpace::settings(const TestInput& input) const {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < dimensions_.size(); ++i) {
    all.push_back(fmt::format("{}={}", dimensions_[i].key, dimensions_[i].text(input.values[i])));
  }
  if (!starts_.moves.empty()) {
    all.push_back(fmt::format("behaviours.{}.parameters.moves={}", behaviour_,
                              starts_.moves[given_start(input)]));
  }
  return all;
}

std::string CrossingSpace::describe(const TestInput& input) const {
  std::string text;
  for (std::size_t i = 0; i < dimensions_.size(); ++i) {
    const std::string& name = names_[i].empty() ? dimensions_[i].key : names_[i];
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", name, dimensions_[i].text(input.values[i]));
  }
  for (const Position& start : starts(input)) {
    text += fmt::format("{}from row {}, cell {}", text.empty() ? "" : ", ", start.x, start.y);
  }
  if (!starts_.moves.empty()) text += ", moves " + starts_.moves[given_start(input)];
  return text;
}

std::vector<std::string> CrossingSpace::world_settings(const TestInput& input) const {
  std::vector<std::string> all = settings(input);
  std::vector<std::string> others;
  for (std::size_t i = 0; i < dimensions_.size(); ++i) {
    if (names_[i].empty()) others.push_back(std::move(all[i]));
  }
  return others;
}

std::vector<ParameterSetting> CrossingSpace::parameters(const TestInput& input) const {
  std::vector<ParameterSetting> all;
  for (std::size_t i = 0; i < dimensions_.size(); ++i) {
    if (names_[i].empty()) continue;
    std::string text = dimensions_[i].text(input.values[i]);
    const auto number = parse_number(text);
    all.push_back({.name = names_[i],
                   .values = {number ? ParameterValue(*number) : ParameterValue(std::move(text))},
                   .origin = {}});
  }
  if (!starts_.moves.empty()) {
    all.push_back({.name = "moves", .values = {starts_.moves[given_start(input)]}, .origin = {}});
  }
  return all;
}

std::size_t CrossingSpace::given_start(const TestInput& input) const {
  return choice(input.values[dimensions_.size()], starts_.given.size());
}

std::vector<Position> CrossingSpace::starts(const TestInput& input) const {
  const std::size_t first = dimensions_.size();
  if (!starts_.given.empty()) return starts_.given[given_start(input)];
  std::vector<Position> positions;
  for (std::size_t i = 0; i < starts_.searched; ++i) {
    const std::size_t at = first + 2 * i;
    const std::size_t row = choice(input.values[at], starts_.rows.size());
    const std::vector<int>& cells = starts_.cells[row];
    positions.push_back({starts_.rows[row], cells[choice(input.values[at + 1], cells.size())]});
  }
  return positions;
}

void read_dimensions(const ConfigNode& node, const ConfigReader& reader,
                     std::vector<Dimension>& dimensions, const std::string& above) {
  if (node.kind != ConfigNode::Kind::map) {
    reader.unexpected(node, "keys of the scenario and their ranges");
    return;
  }
  for (const ConfigEntry& entry : node.entries) {
    const std::string key = above + entry.key;
    const ConfigNode& value = entry.value;
    const bool is_inner = value.kind == ConfigNode::Kind::map && value.find("whole") == nullptr;
    if (is_inner && !value.entries.empty()) {
      read_dimensions(value, reader, dimensions, key + '.');
    } else if (auto dimension = read_dimension(value, reader)) {
      dimension->key = key;
      // Another layer may have given it in the other form.
      std::erase_if(dimensions, [&](const Dimension& each) { return each.key == key; });
      dimensions.push_back(std::move(*dimension));
    }
  }
}

}  // namespace jaywalk::search

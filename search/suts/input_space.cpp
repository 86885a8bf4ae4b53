// SPDX-License-Identifier: Apache-2.0
#include "search/suts/input_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "interpreter/support/markup.h"

namespace jaywalk::search {
namespace {

using Json = nlohmann::json;

/// Generators compare tests and train networks with as many inputs.
constexpr std::size_t kMostInputs = 1000;
constexpr std::size_t kMostSamples = 100'000;
/// A time that is the end of a piece but for rounding is that end.
constexpr double kRounding = 1e-9;

/// At a share of the duration, 0 to 1.
double piece_at(std::span<const double> pieces, double share) {
  const auto piece =
      static_cast<std::size_t>(share * static_cast<double>(pieces.size()) + kRounding);
  return pieces[std::min(piece, pieces.size() - 1)];
}

double line_at(std::span<const double> points, double share) {
  if (points.size() == 1) return points.front();
  const double place = share * static_cast<double>(points.size() - 1);
  const std::size_t from = std::min(static_cast<std::size_t>(place), points.size() - 2);
  const double beyond = place - static_cast<double>(from);
  return points[from] + beyond * (points[from + 1] - points[from]);
}

std::string range_text(const Dimension& dimension) {
  switch (dimension.kind) {
    case Dimension::Kind::word:
      return fmt::format("{}", fmt::join(dimension.words, " or "));
    case Dimension::Kind::whole:
      return fmt::format("{:g} to {:g} in steps of {}", dimension.from, dimension.to,
                         dimension.step);
    case Dimension::Kind::number:
      break;
  }
  return fmt::format("{:g} to {:g}", dimension.from, dimension.to);
}

class InputReader {
 public:
  explicit InputReader(const ConfigReader& reader) : reader_(reader) {}

  std::optional<NamedInput> read(const ConfigEntry& entry, const std::string& path) {
    if (!is_identifier(entry.key)) {
      reader_.error(entry.origin, fmt::format("'{}' cannot be the name of an input", entry.key),
                    std::string(kIdentifierHint));
      return std::nullopt;
    }
    NamedInput input;
    if (entry.value.kind == ConfigNode::Kind::map) {
      if (!read_signal(entry.value, path, input)) return std::nullopt;
    } else {
      auto dimension = read_dimension(entry.value, reader_);
      if (!dimension) return std::nullopt;
      input.dimension = std::move(*dimension);
    }
    input.dimension.key = entry.key;
    return input;
  }

 private:
  /// `{range: [0, 100], pieces: 6, interpolation: linear}` or `{whole: [1, 5], step: 1, pieces:
  /// 3}`.
  bool read_signal(const ConfigNode& node, const std::string& path, NamedInput& input) {
    static constexpr std::array kInterpolations = {
        Choice<Interpolation>{"constant", Interpolation::constant},
        Choice<Interpolation>{"linear", Interpolation::linear}};
    bool well = true;
    bool is_given = false;
    std::vector<ConfigKey> keys = whole_keys(input.dimension, reader_);
    keys.push_back({"range", [&](const ConfigNode& value, const std::string&) {
                      is_given = true;
                      well = read_bounds(value, reader_, input.dimension) && well;
                    }});
    keys.push_back({"pieces", [&](const ConfigNode& value, const std::string&) {
                      const auto pieces = reader_.integer(value, {1, kMostInputs});
                      if (pieces) input.pieces = static_cast<std::size_t>(*pieces);
                    }});
    keys.push_back({"interpolation", [&](const ConfigNode& value, const std::string&) {
                      const auto chosen = reader_.choice(
                          value, std::span<const Choice<Interpolation>>(kInterpolations));
                      input.interpolation = chosen.value_or(Interpolation::constant);
                    }});
    reader_.read_map(node, path, keys);
    const bool is_whole = node.find("whole") != nullptr;
    if (!is_given && !is_whole) {
      reader_.error(node.origin, fmt::format("'{}' has no range", path),
                    "write range: [from, to], or whole: [from, to]");
      return false;
    }
    if (is_given && is_whole) {
      reader_.error(node.origin, fmt::format("'{}' has both 'range' and 'whole'", path));
      return false;
    }
    if (is_whole && input.interpolation == Interpolation::linear) {
      reader_.error(node.find("interpolation")->origin,
                    "between whole numbers nothing is interpolated", "leave 'interpolation' out");
    }
    if (input.pieces == 0 && node.find("interpolation") != nullptr) {
      reader_.error(node.find("interpolation")->origin,
                    fmt::format("'{}' is one value, no signal", path),
                    "'pieces' says of how many values a signal consists");
    }
    return well;
  }

  const ConfigReader& reader_;
};

}  // namespace

InputSpace::InputSpace(InputSpaceSettings settings) : settings_(std::move(settings)) {
  for (const NamedInput& input : settings_.inputs) {
    distinct_.insert(distinct_.end(), input.size(), input.dimension.distinct_values());
  }
}

Validity InputSpace::check(const TestInput& input) const {
  if (input.form != Form::vector || input.values.size() != dimension()) {
    return {fmt::format("expected a vector of {} numbers", dimension())};
  }
  const bool within =
      std::ranges::all_of(input.values, [](double value) { return value >= -1 && value <= 1; });
  return {within ? "" : "a number is not from -1 to 1"};
}

TestInput InputSpace::draw_initial(Random& random) const {
  TestInput input{Form::vector, std::vector<double>(dimension())};
  for (double& value : input.values) value = random.uniform(-1, 1);
  return input;
}

std::string InputSpace::describe(const TestInput& input) const {
  std::string text;
  const double* values = input.values.data();
  for (const NamedInput& each : settings_.inputs) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", each.dimension.key);
    for (std::size_t i = 0; i < each.size(); ++i) text += ' ' + each.dimension.text(values[i]);
    values += each.size();
  }
  return text;
}

std::size_t InputSpace::samples() const {
  return static_cast<std::size_t>(settings_.duration_s / settings_.sample_s + kRounding) + 1;
}

nlohmann::json InputSpace::json_of(const NamedInput& input, const double* values) const {
  const Dimension& dimension = input.dimension;
  if (dimension.kind == Dimension::Kind::word) {
    const std::string word = dimension.text(*values);
    const auto number = parse_number(word);
    return number ? Json(*number) : Json(word);
  }
  std::vector<double> pieces;
  for (std::size_t i = 0; i < input.size(); ++i) pieces.push_back(dimension.number(values[i]));
  const auto sent = [&](double number) {
    return dimension.kind == Dimension::Kind::whole ? Json(std::lround(number)) : Json(number);
  };
  if (input.pieces == 0) return sent(pieces.front());
  Json sampled = Json::array();
  if (settings_.sample_s == 0) {
    for (const double piece : pieces) sampled.push_back(sent(piece));
    return sampled;
  }
  for (std::size_t i = 0; i < samples(); ++i) {
    const double share = static_cast<double>(i) * settings_.sample_s / settings_.duration_s;
    sampled.push_back(sent(input.interpolation == Interpolation::linear ? line_at(pieces, share)
                                                                        : piece_at(pieces, share)));
  }
  return sampled;
}

nlohmann::json InputSpace::request(const TestInput& input) const {
  Json inputs = Json::object();
  const double* values = input.values.data();
  for (const NamedInput& each : settings_.inputs) {
    inputs[each.dimension.key] = json_of(each, values);
    values += each.size();
  }
  Json json{{"inputs", std::move(inputs)}};
  if (settings_.duration_s > 0) json["duration_s"] = settings_.duration_s;
  if (settings_.sample_s > 0) {
    Json times = Json::array();
    for (std::size_t i = 0; i < samples(); ++i) {
      times.push_back(static_cast<double>(i) * settings_.sample_s);
    }
    json["time"] = std::move(times);
  }
  return json;
}

std::string InputSpace::text() const {
  std::vector<std::string> parts;
  for (const NamedInput& each : settings_.inputs) {
    std::string part = fmt::format("{} {}", each.dimension.key, range_text(each.dimension));
    if (each.pieces > 0) {
      part += fmt::format(
          " in {} {}", each.pieces,
          each.interpolation == Interpolation::linear ? "points, linear between" : "pieces");
    }
    parts.push_back(std::move(part));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

void read_inputs(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                 InputSpaceSettings& space) {
  if (node.kind != ConfigNode::Kind::map || node.entries.empty()) {
    return reader.unexpected(node, "names of inputs and their ranges, as {throttle: [0, 100]}");
  }
  std::size_t values = 0;
  for (const ConfigEntry& entry : node.entries) {
    auto input = InputReader(reader).read(entry, fmt::format("{}.{}", path, entry.key));
    if (!input) continue;
    values += input->size();
    space.inputs.push_back(std::move(*input));
  }
  if (values > kMostInputs) {
    reader.error(node.origin, fmt::format("the inputs have {} values in all, more than {}", values,
                                          kMostInputs));
  }
}

void check_inputs(const ConfigNode& node, const ConfigReader& reader,
                  const InputSpaceSettings& space) {
  const ConfigNode* const sample = node.find("sample_s");
  if (sample != nullptr && space.duration_s == 0) {
    reader.error(sample->origin, "samples of signals whose duration is not given",
                 "'duration_s' says how long signals last");
  } else if (space.sample_s > 0 &&
             space.duration_s / space.sample_s > static_cast<double>(kMostSamples)) {
    reader.error(sample->origin, fmt::format("more than {} samples of a signal", kMostSamples));
  }
  const bool is_linear = std::ranges::any_of(space.inputs, [](const NamedInput& each) {
    return each.interpolation == Interpolation::linear;
  });
  if (is_linear && space.sample_s == 0) {
    reader.error(node.find("inputs")->origin, "linear signals are sent as samples",
                 "'sample_s' says how far apart; without it the program gets the pieces' values");
  }
}

}  // namespace jaywalk::search

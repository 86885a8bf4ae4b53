#include "search/suts/crossing_space.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace jaywalk::search {
namespace {

/// From -1 ... 1 to 0 ... count - 1, all of them equally wide.
std::size_t choice(double value, std::size_t count) {
  const double share = std::clamp((value + 1) / 2, 0.0, 1.0);
  return std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)));
}

std::string value_text(const CrossingDimension& dimension, double value) {
  switch (dimension.kind) {
    case CrossingDimension::Kind::word:
      return dimension.words[choice(value, dimension.words.size())];
    case CrossingDimension::Kind::whole: {
      const auto count = static_cast<std::size_t>(std::lround(dimension.to - dimension.from)) + 1;
      return fmt::format("{}",
                         std::lround(dimension.from) + static_cast<long>(choice(value, count)));
    }
    case CrossingDimension::Kind::number:
      break;
  }
  return fmt::format("{:.6g}", dimension.from + (dimension.to - dimension.from) * (value + 1) / 2);
}

}  // namespace

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
    all.push_back(
        fmt::format("{}={}", dimensions_[i].key, value_text(dimensions_[i], input.values[i])));
  }
  return all;
}

std::vector<Position> CrossingSpace::starts(const TestInput& input) const {
  std::vector<Position> positions;
  for (std::size_t i = 0; i < searched_starts_; ++i) {
    const std::size_t at = dimensions_.size() + 2 * i;
    positions.push_back(
        {rows_[choice(input.values[at], rows_.size())],
         static_cast<int>(choice(input.values[at + 1], static_cast<std::size_t>(cells_)))});
  }
  return positions;
}

}  // namespace jaywalk::search

#include "search/suts/read_road_space.h"

#include <fmt/format.h>

namespace jaywalk::search {

void read_road_space(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                     RoadSpaceSettings& space) {
  const auto number = [&](double& target, NumberRange range) {
    return [&target, range, &reader](const ConfigNode& value, const std::string&) {
      if (const auto read = reader.number(value, range)) target = *read;
    };
  };
  const auto count = [&](std::size_t& target, IntegerRange range) {
    return [&target, range, &reader](const ConfigNode& value, const std::string&) {
      if (const auto read = reader.integer(value, range)) target = static_cast<std::size_t>(*read);
    };
  };
  const std::vector<ConfigKey> keys{
      {"curvatures", count(space.curvatures, {1, 100})},
      {"step_m", number(space.step_m, {1, 100})},
      {"most_curvature", number(space.most_curvature, {0.001, 1})},
      {"most_difference", number(space.most_difference, {0, 1})},
      {"sequence_step_m", number(space.sequence_step_m, {1, 100})},
      {"sequence_length", count(space.sequence_length, {3, 200})},
      {"sequence_spread", count(space.sequence_spread, {0, 100})},
      {"map_m", number(space.rules.map_m, {50, 10'000})},
      {"least_length_m", number(space.rules.least_length_m, {0, 10'000})},
      {"least_radius_ft", number(space.rules.least_radius_ft, {0, 10'000})},
  };
  reader.read_map(node, path, keys);
  if (space.sequence_spread + 3 > space.sequence_length) {
    reader.error(node.origin, "sequence_spread leaves sequences of fewer than 3 values");
  }
}

SutSetting road_setting(const RoadSpaceSettings& space) {
  return {
      "roads",
      fmt::format("vectors of {} curvatures {:.6g} m apart, sequences of {} to {} values {:.6g} m "
                  "apart, up to {:.6g} 1/m; a map of {:.6g} m × {:.6g} m",
                  space.curvatures, space.step_m, space.sequence_length - space.sequence_spread,
                  space.sequence_length + space.sequence_spread, space.sequence_step_m,
                  space.most_curvature, space.rules.map_m, space.rules.map_m)};
}

}  // namespace jaywalk::search

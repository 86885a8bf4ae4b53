// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/env_lane/data.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace jaywalk::lane {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

std::string beside(const std::string& name) {
  return std::string(JAYWALK_SOURCE_DIR) + "/tests/unit/env_lane/data/" + name;
}

/// Calls `row` with the fields of each row; comments and the header are left out.
void read(const std::string& path,
          const std::function<void(const std::vector<std::string>&)>& row) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  bool header = true;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    if (!header) row(split(line, ','));
    header = false;
  }
}

}  // namespace

std::vector<JudgedRoad> judged_roads() {
  std::vector<JudgedRoad> roads;
  read(beside("road_verdicts.csv"), [&](const std::vector<std::string>& fields) {
    JudgedRoad road{fields.at(0), std::stoul(fields.at(1)), fields.at(2), {}};
    for (const std::string& point : split(fields.at(3), ';')) {
      const std::vector<std::string> xy = split(point, ' ');
      road.points.push_back({std::stod(xy.at(0)), std::stod(xy.at(1))});
    }
    roads.push_back(std::move(road));
  });
  return roads;
}

std::vector<ExecutedRoad> executed_roads() {
  std::vector<ExecutedRoad> roads;
  const char* const other = std::getenv("JAYWALK_EXECUTED_ROADS");
  read(other != nullptr ? other : beside("beamng_random.csv"),
       [&](const std::vector<std::string>& fields) {
         ExecutedRoad road{std::stod(fields.at(fields.size() - 2)), {}};
         for (const std::string& number : split(fields.back(), ';')) {
           road.curvatures.push_back(std::stod(number));
         }
         roads.push_back(std::move(road));
       });
  return roads;
}

Polyline ExecutedRoad::points() const {
  constexpr double kStep_m = 10;
  double heading = 1.57;
  Polyline line{{0, 0}};
  for (std::size_t i = 0; i + 1 < curvatures.size(); ++i) {
    const double next = heading + kStep_m / 2 * (curvatures[i] + curvatures[i + 1]);
    line.push_back({line.back().x_m + kStep_m / 2 * (std::cos(next) + std::cos(heading)),
                    line.back().y_m + kStep_m / 2 * (std::sin(next) + std::sin(heading))});
    heading = next;
  }
  return line;
}

}  // namespace jaywalk::lane

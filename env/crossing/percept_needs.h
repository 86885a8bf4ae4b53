#pragma once

// Under which keys of a scenario percepts of the crossing world exist: the column `need` of
// percepts.def.

#include <algorithm>
#include <string_view>

#include "env/crossing/parameters.h"

namespace jaywalk {

struct PerceptNeed {
  /// The scenario's keys that give the percept, as `list environments` shows them; empty: it always
  /// exists.
  std::string_view keys;
  bool (*met)(const CrossingParameters&);
};

namespace percept_needs {

inline constexpr PerceptNeed always{"", [](const CrossingParameters&) { return true; }};
// Agents perceive what ends a test only if the test goes on after it.
inline constexpr PerceptNeed aftermath{
    "world.aftermath or world.until", [](const CrossingParameters& world) {
      return world.end != TestEnd::precondition || world.aftermath > 0;
    }};
inline constexpr PerceptNeed after_collision{
    "world.aftermath or world.until", [](const CrossingParameters& world) {
      return world.end != TestEnd::collision || world.aftermath > 0;
    }};
inline constexpr PerceptNeed crosswalks{
    "world.crosswalks", [](const CrossingParameters& world) { return !world.crosswalks.empty(); }};
inline constexpr PerceptNeed signals{
    "world.crosswalks of kind signalled", [](const CrossingParameters& world) {
      return std::any_of(
          world.crosswalks.begin(), world.crosswalks.end(),
          [](const Crosswalk& each) { return each.kind == CrosswalkKind::signalled; });
    }};
inline constexpr PerceptNeed obstacles{
    "world.obstacles", [](const CrossingParameters& world) { return !world.obstacles.empty(); }};
inline constexpr PerceptNeed blocked_cells{
    "world.obstacles or world.map",
    [](const CrossingParameters& world) { return !world.obstacles.empty() || !world.map.empty(); }};
inline constexpr PerceptNeed sight{"world.pedestrians.sight", [](const CrossingParameters& world) {
                                     return world.pedestrians.sight > 0;
                                   }};
inline constexpr PerceptNeed features{
    "world.pedestrians.features",
    [](const CrossingParameters& world) { return world.pedestrians.features; }};

}  // namespace percept_needs

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The words of the crossing world (percepts.def), as tables and as symbols.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "env/crossing/parameters.h"
#include "env/crossing/road_user.h"
#include "env/environments.h"
#include "env/grid/grid.h"
#include "interpreter/term/symbol.h"
#include "interpreter/term/value.h"

namespace jaywalk {

/// Under which keys of a scenario a percept exists: the column `need` of percepts.def.
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

#define JAYWALK_PERCEPT(id, need, form, ...) id,
#define JAYWALK_ACTION(id, form, ...)
enum class CrossingPercept : std::size_t {
#include "env/crossing/percepts.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

/// A row's percept, with its need.
constexpr EnvironmentWord crossing_percept(const PerceptNeed& need, std::string_view form,
                                           std::string_view meaning, std::string_view values = {}) {
  return {.form = form, .meaning = meaning, .values = values, .needs = need.keys};
}

#define JAYWALK_PERCEPT(id, need, ...) crossing_percept(percept_needs::need, __VA_ARGS__),
#define JAYWALK_ACTION(id, form, ...)
inline constexpr std::array kCrossingPercepts{
#include "env/crossing/percepts.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

#define JAYWALK_PERCEPT(id, need, form, ...)
#define JAYWALK_ACTION(id, form, ...) EnvironmentWord{form, __VA_ARGS__},
inline constexpr std::array kCrossingActions{
#include "env/crossing/percepts.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

/// Which percepts agents have in a world of these parameters, in the order of kCrossingPercepts.
[[nodiscard]] std::array<bool, kCrossingPercepts.size()> given_percepts(
    const CrossingParameters& parameters);

/// The words interned in one symbol table; made once, before the table is shared.
class CrossingVocabulary {
 public:
  explicit CrossingVocabulary(SymbolTable& symbols);

  [[nodiscard]] Predicate percept(CrossingPercept percept) const {
    return percepts_[static_cast<std::size_t>(percept)];
  }
  [[nodiscard]] Predicate move() const { return move_; }
  [[nodiscard]] Predicate move_by() const { return move_by_; }
  [[nodiscard]] Predicate stay() const { return stay_; }
  [[nodiscard]] Predicate show() const { return show_; }
  [[nodiscard]] Value atom(Direction direction) const {
    return directions_[static_cast<std::size_t>(direction)];
  }
  [[nodiscard]] Value atom(Surface ground) const {
    return surfaces_[static_cast<std::size_t>(ground)];
  }
  [[nodiscard]] Value atom(SignalColour colour) const {
    return colours_[static_cast<std::size_t>(colour)];
  }
  [[nodiscard]] Value atom(ActorKind kind) const { return kinds_[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] Value atom(CrosswalkKind kind) const {
    return crosswalks_[static_cast<std::size_t>(kind)];
  }

 private:
  std::array<Predicate, kCrossingPercepts.size()> percepts_{};
  std::array<Value, kDirectionCount> directions_{};
  std::array<Value, 4> surfaces_{};
  std::array<Value, 3> colours_{};
  std::array<Value, 4> kinds_{};
  std::array<Value, 2> crosswalks_{};
  Predicate move_;
  Predicate move_by_;
  Predicate stay_;
  Predicate show_;
};

}  // namespace jaywalk

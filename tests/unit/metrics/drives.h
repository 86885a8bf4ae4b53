// SPDX-License-Identifier: Apache-2.0
#pragma once

// Recordings made by hand: an automated vehicle (AV) of 4 m x 2 m that drives along x = 0, and road
// users of 0.5 m x 0.5 m.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "experiment/judge/signals/signals.h"

namespace jaywalk {

struct Place {
  double x = 0;
  double y = 0;
};

/// Everybody's middle at each tick; speeds and headings follow from the way to the next place, at
/// the last tick from the way to it.
inline Recording drive(double tick_s, std::vector<std::vector<Place>> ways) {
  std::vector<Actor> actors{{"av", ActorKind::vehicle, 4, 2}};
  for (std::size_t i = 1; i < ways.size(); ++i) {
    actors.push_back({"p" + std::to_string(i), ActorKind::pedestrian, 0.5, 0.5});
  }
  Recording recording(tick_s, actors);
  const std::size_t ticks = ways.front().size();
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    Scene scene;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const std::size_t from = ticks == 1 ? 0 : std::min(tick, ticks - 2);
      const Place a = ways[i][from];
      const Place b = ways[i][ticks == 1 ? 0 : from + 1];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      double heading = i == 0 ? std::numbers::pi / 2 : 0;
      if (i > 0 && length > 0) heading = std::atan2(b.y - a.y, b.x - a.x);
      scene.push_back({ways[i][tick].x, ways[i][tick].y, length / tick_s, heading});
    }
    recording.add(scene);
  }
  return recording;
}

/// So many places, beginning at one, each a step from the last.
inline std::vector<Place> steps(Place from, Place step, std::size_t count) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = static_cast<double>(i);
    places.push_back({from.x + n * step.x, from.y + n * step.y});
  }
  return places;
}

/// One moment with given velocities: the AV's middle at the origin.
inline Recording moment(double av_speed, Place place, Place velocity) {
  return drive(1, {steps({0, 0}, {0, av_speed}, 2), steps(place, velocity, 2)});
}

/// A lane 6 m wide in which the AV drives, another one to its right, pavements beside them.
inline Ground road() {
  const auto strip = [](double left, double right) {
    return std::vector<Point>{{left, -100}, {right, -100}, {right, 1000}, {left, 1000}};
  };
  return {{{AreaKind::pavement, strip(-6, -3), false},
           {AreaKind::lane, strip(-3, 3), true},
           {AreaKind::lane, strip(3, 9), false},
           {AreaKind::pavement, strip(9, 12), false}}};
}

}  // namespace jaywalk

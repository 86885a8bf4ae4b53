// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/console/frame_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace jaywalk {
namespace {

constexpr std::string_view kPavementStyle = "\x1b[48;5;250;38;5;244m";
constexpr std::string_view kLaneStyle = "\x1b[48;5;238;38;5;246m";
constexpr std::string_view kCrosswalkStyle = "\x1b[48;5;238;38;5;255;1m";
constexpr std::string_view kBlockedStyle = "\x1b[48;5;52;38;5;180m";
constexpr std::string_view kZoneStyle = "\x1b[48;5;136;38;5;230m";
constexpr std::string_view kAvStyle = "\x1b[48;5;25;38;5;255;1m";
constexpr std::string_view kPedestrianStyle = "\x1b[48;5;230;38;5;0;1m";
constexpr std::string_view kOtherStyle = "\x1b[48;5;96;38;5;255;1m";
constexpr std::string_view kHitStyle = "\x1b[48;5;160;38;5;255;1m";
constexpr std::string_view kGreenStyle = "\x1b[48;5;28;38;5;255;1m";
constexpr std::string_view kAmberStyle = "\x1b[48;5;214;38;5;0;1m";
constexpr std::string_view kRedStyle = "\x1b[48;5;160;38;5;255;1m";

Glyph signal_glyph(SignalColour colour) {
  switch (colour) {
    case SignalColour::green:
      return {'G', kGreenStyle};
    case SignalColour::amber:
      return {'A', kAmberStyle};
    case SignalColour::red:
      return {'R', kRedStyle};
  }
  return {};
}

std::size_t crosswalk_of(const Crossing& crossing, std::size_t body) {
  return crossing.parameters().actors[body - crossing.positions().size()].crosswalk;
}

bool is_hit(const CrossingResult& result, std::size_t body) {
  return std::ranges::find(result.met_by, body) != result.met_by.end() ||
         std::ranges::any_of(result.collisions,
                             [body](const Collision& each) { return each.body == body; });
}

bool lies_in(const std::vector<Obstacle>& obstacles, Position cell) {
  return std::ranges::any_of(obstacles, [cell](const Obstacle& each) {
    return each.rows.contains(cell.x) && each.cells.contains(cell.y);
  });
}

/// The cells whose middles lie within a box round the middle of one.
Interval cells_of(double middle, double half_m, double cell_m) {
  const double half = half_m / cell_m;
  const auto own = static_cast<int>(std::floor(middle + 0.5));  // as cell() has it
  return {std::min(own, static_cast<int>(std::ceil(middle - half))),
          std::max(own, static_cast<int>(std::floor(middle + half)))};
}

bool has_letter(const CrossingParameters& parameters, char letter) {
  return std::ranges::any_of(
      parameters.map, [letter](const std::string& row) { return row.find(letter) != row.npos; });
}

bool has_kind(const CrossingParameters& parameters, ActorKind kind) {
  return std::ranges::any_of(parameters.actors,
                             [kind](const ActorParameters& each) { return each.kind == kind; });
}

/// Signals stand on both sides of their crosswalk, where its lanes end.
bool is_beside_road(const Crossing& crossing, Position cell) {
  const Layout& layout = crossing.layout();
  const auto is_road = [&layout](Position at) {
    return layout.grid().contains(at) && layout.is_road(at);
  };
  return !is_road(cell) && (is_road({cell.x - 1, cell.y}) || is_road({cell.x + 1, cell.y}));
}

}  // namespace

char letter_of(const Crossing& crossing, std::size_t body) {
  constexpr std::string_view kLetters = "123456789abcdefghijklmnopqrstuvwxyz";
  switch (crossing.bodies()[body].kind) {
    case ActorKind::pedestrian:
      return body < kLetters.size() ? kLetters[body] : '&';
    case ActorKind::cyclist:
      return 'C';
    case ActorKind::vehicle:
      return 'V';
    case ActorKind::signal:
      return signal_glyph(crossing.signal(crosswalk_of(crossing, body))).letter;
  }
  return '&';
}

AvSituation av_situation(const Crossing& crossing) {
  if (!crossing.result().success) return {crossing.av_edge(), crossing.zone_cells()};
  const int origin = *crossing.result().hit_origin;
  const Interval ahead = zone_ahead(crossing.parameters());
  return {.edge = crossing.av_edge(),
          .zone = {.first = origin + ahead.first, .last = origin + ahead.last}};
}

FrameCells::FrameCells(const Crossing& crossing)
    : crossing_(crossing), av_(av_situation(crossing)) {
  const double cell_m = crossing.parameters().cell_m;
  const auto all = crossing.bodies();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].kind == ActorKind::signal) continue;
    const BoxSize half = half_extent(all[i]);
    const bool walks = all[i].kind == ActorKind::pedestrian;
    const std::string_view style = walks ? kPedestrianStyle : kOtherStyle;
    bodies_.push_back(
        {.rows = cells_of(all[i].place.x, walks ? 0 : half.width_m, cell_m),
         // A pedestrian is drawn in its own cell alone, by which the precondition goes.
         .cells = cells_of(all[i].place.y, walks ? 0 : half.length_m, cell_m),
         .glyph = {letter_of(crossing, i), is_hit(crossing.result(), i) ? kHitStyle : style}});
  }
}

Glyph FrameCells::ground(Position cell) const {
  const CrossingParameters& parameters = crossing_.parameters();
  if (parameters.av.rows.contains(cell.x) && cell.y <= av_.edge &&
      cell.y > av_.edge - parameters.av.length) {
    return {.letter = cell.y == av_.edge ? '>' : '=', .style = kAvStyle};
  }
  if (crossing_.zone_rows().contains(cell.x) && av_.zone.contains(cell.y)) {
    return {.letter = ':', .style = kZoneStyle};
  }
  for (std::size_t i = 0; i < parameters.crosswalks.size(); ++i) {
    const Crosswalk& crosswalk = parameters.crosswalks[i];
    if (crosswalk.kind != CrosswalkKind::signalled || cell.y != crosswalk.cells.first) continue;
    if (is_beside_road(crossing_, cell)) return signal_glyph(crossing_.signal(i));
  }
  switch (crossing_.layout().at(cell)) {
    case Surface::pavement:
      return {'.', kPavementStyle};
    case Surface::crosswalk:
      return {'|', kCrosswalkStyle};
    case Surface::blocked:
      return {lies_in(parameters.obstacles, cell) ? 'X' : '#', kBlockedStyle};
    case Surface::lane:
      break;
  }
  const bool junction =
      !parameters.map.empty() &&
      parameters.map[static_cast<std::size_t>(cell.x)][static_cast<std::size_t>(cell.y)] == 'x';
  return {junction ? '+' : ' ', kLaneStyle};
}

Glyph FrameCells::at(Position cell) const {
  const auto stands_here = [cell](const Body& body) {
    return body.rows.contains(cell.x) && body.cells.contains(cell.y);
  };
  const auto first = std::ranges::find_if(bodies_, stands_here);
  if (first == bodies_.end()) return ground(cell);
  Glyph glyph = first->glyph;
  for (auto other = first + 1; other != bodies_.end(); ++other) {
    if (!stands_here(*other)) continue;
    glyph.letter = '*';
    // Of several bodies in a cell, one that was hit decides the colour.
    if (other->glyph.style == kHitStyle) glyph.style = kHitStyle;
  }
  return glyph;
}

std::vector<std::string> legend(const Crossing& crossing) {
  const CrossingParameters& parameters = crossing.parameters();
  const auto has_crosswalk = [&parameters](CrosswalkKind kind) {
    return std::ranges::find(parameters.crosswalks, kind, &Crosswalk::kind) !=
           parameters.crosswalks.end();
  };
  std::vector<std::string> entries{"=> AV", ": zone", "1 pedestrian", "* several"};
  const auto add = [&entries](bool occurs, const char* text) {
    if (occurs) entries.emplace_back(text);
  };
  add(has_kind(parameters, ActorKind::cyclist), "C cyclist");
  add(has_kind(parameters, ActorKind::vehicle), "V vehicle");
  add(has_crosswalk(CrosswalkKind::zebra), "| zebra");
  add(has_crosswalk(CrosswalkKind::signalled), "| signalled crosswalk");
  add(has_crosswalk(CrosswalkKind::signalled), "G A R signal: green, amber, red");
  add(!parameters.obstacles.empty(), "X parked car");
  add(has_letter(parameters, '#'), "# building");
  add(has_letter(parameters, 'x'), "+ junction");
  return entries;
}

}  // namespace jaywalk

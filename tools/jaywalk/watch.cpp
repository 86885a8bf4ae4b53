#include "tools/jaywalk/watch.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace jaywalk {
namespace {

/// What a cell shows: a letter, and how it is coloured on a terminal that can.
struct Glyph {
  char letter = ' ';
  std::string_view style;
};

constexpr std::string_view kPlain = "\x1b[0m";
constexpr std::string_view kPavement = "\x1b[48;5;250;38;5;244m";
constexpr std::string_view kLane = "\x1b[48;5;238;38;5;246m";
constexpr std::string_view kZone = "\x1b[48;5;136;38;5;230m";
constexpr std::string_view kAv = "\x1b[48;5;25;38;5;255;1m";
constexpr std::string_view kPedestrian = "\x1b[48;5;230;38;5;0;1m";
constexpr std::string_view kHit = "\x1b[48;5;160;38;5;255;1m";

constexpr int kLabelWidth = 13;

/// Pedestrians are shown by number, from 1; those above 35 all alike.
char letter_of(std::size_t index) {
  constexpr std::string_view kLetters = "123456789abcdefghijklmnopqrstuvwxyz";
  return index < kLetters.size() ? kLetters[index] : '&';
}

bool is_hit(const CrossingResult& result, std::size_t index) {
  return std::ranges::find(result.hit_by, index) != result.hit_by.end();
}

/// Where the AV stands and which cells are at stake: those that the next tick tests, or, once the
/// precondition was met, those in which that happened, before the AV moved on.
struct Situation {
  int edge = 0;
  Interval zone;
};

Situation av_situation(const Crossing& crossing) {
  if (!crossing.result().success) return {crossing.av_edge(), crossing.zone_cells()};
  const CrossingParameters& parameters = crossing.parameters();
  const int origin = *crossing.result().hit_origin;
  const Interval ahead = zone_ahead(parameters);
  return {.edge = crossing.av_edge() - (crossing.av_cell() - origin),
          .zone = {.first = origin + ahead.first, .last = origin + ahead.last}};
}

Glyph ground(const Crossing& crossing, Position cell) {
  const CrossingParameters& parameters = crossing.parameters();
  const auto [edge, zone] = av_situation(crossing);
  if (parameters.av.rows.contains(cell.x) && cell.y <= edge &&
      cell.y > edge - parameters.av.length) {
    return {.letter = cell.y == edge ? '>' : '=', .style = kAv};
  }
  if (crossing.zone_rows().contains(cell.x) && zone.contains(cell.y)) {
    return {.letter = ':', .style = kZone};
  }
  const bool pavement = band_kind(parameters, cell.x) == BandKind::pavement;
  return pavement ? Glyph{.letter = '.', .style = kPavement} : Glyph{.style = kLane};
}

Glyph glyph(const Crossing& crossing, Position cell) {
  const auto positions = crossing.positions();
  const auto here = std::ranges::count(positions, cell);
  if (here == 0) return ground(crossing, cell);
  const auto first =
      static_cast<std::size_t>(std::ranges::find(positions, cell) - positions.begin());
  return {.letter = here == 1 ? letter_of(first) : '*',
          .style = is_hit(crossing.result(), first) ? kHit : kPedestrian};
}

std::string band_label(const Band& band) {
  if (band.kind == BandKind::pavement) return "pavement";
  return band.direction == Direction::forward ? "lane ->" : "lane <-";
}

/// The cells that fit on the screen, with the AV in sight.
Interval visible_cells(const Crossing& crossing, int columns) {
  const int length = crossing.parameters().length;
  const int fitting = columns <= 0 ? length : std::clamp(columns - kLabelWidth, 10, length);
  const int first = std::clamp(av_situation(crossing).edge - fitting / 4, 0, length - fitting);
  return {.first = first, .last = first + fitting - 1};
}

std::string road(const Crossing& crossing, const FrameOptions& options) {
  const CrossingParameters& parameters = crossing.parameters();
  const Interval cells = visible_cells(crossing, options.columns);
  const auto rows = band_rows(parameters);
  std::string text;
  for (std::size_t band = 0; band < rows.size(); ++band) {
    for (int x = rows[band].first; x <= rows[band].last; ++x) {
      const std::string label = x == rows[band].first ? band_label(parameters.bands[band]) : "";
      std::string line = fmt::format("{:>2} {:<9} ", x, label);
      std::string_view style;
      for (int y = cells.first; y <= cells.last; ++y) {
        const Glyph each = glyph(crossing, {.x = x, .y = y});
        if (options.colour == Colour::on && each.style != style) line += style = each.style;
        line += each.letter;
      }
      if (options.colour == Colour::on) line += kPlain;
      line.erase(line.find_last_not_of(' ') + 1);
      text += line + '\n';
    }
  }
  // The scale: every tenth cell.
  std::string scale(kLabelWidth, ' ');
  for (int y = cells.first; y <= cells.last; ++y) {
    const auto column = static_cast<std::size_t>(kLabelWidth + y - cells.first);
    if (y % 10 == 0)
      scale += std::string(column - std::min(column, scale.size()), ' ') + std::to_string(y);
  }
  return text + scale + '\n';
}

/// Its intentions as they are described, less the annotation that every goal of its own has.
std::string intentions_of(const Mas& mas, AgentId id) {
  constexpr std::string_view kOwn = "[source(self)]";
  std::string text = fmt::format("{}", fmt::join(mas.describe_intentions(id), "; "));
  for (auto at = text.find(kOwn); at != std::string::npos; at = text.find(kOwn, at)) {
    text.erase(at, kOwn.size());
  }
  return text.empty() ? "no intention" : text;
}

std::string pedestrian_lines(const Crossing& crossing, const Mas& mas) {
  std::string text;
  for (std::size_t i = 0; i < crossing.positions().size(); ++i) {
    const Position at = crossing.positions()[i];
    const PedestrianOutcome& outcome = crossing.result().pedestrians[i];
    text += fmt::format("{} at {:>2},{:<3} score {:>4}  {}\n", letter_of(i), at.x, at.y,
                        outcome.reward - outcome.cost, intentions_of(mas, static_cast<AgentId>(i)));
  }
  return text;
}

}  // namespace

std::string draw_frame(const Crossing& crossing, const Mas& mas,
                       const std::vector<std::string>& printed, const FrameOptions& options) {
  const auto [edge, zone] = av_situation(crossing);
  std::string text = fmt::format("{}\ntick {}: AV at {}", options.title, crossing.ticks(), edge);
  if (crossing.result().success) {
    text += fmt::format(", precondition met in its zone, {} to {}", zone.first, zone.last);
  } else if (!crossing.finished()) {
    text += fmt::format(", zone of the next tick {} to {}", zone.first, zone.last);
  }
  text += '\n' + road(crossing, options) + pedestrian_lines(crossing, mas);
  for (const std::string& line : printed) text += fmt::format("  {}\n", line);
  return text;
}

std::string describe_result(const CrossingResult& result) {
  if (!result.success) {
    return fmt::format("precondition not met in {} ticks, score {:.2f}", result.ticks,
                       result.score());
  }
  std::vector<std::string> names;
  for (const std::size_t index : result.hit_by) names.push_back(std::to_string(index + 1));
  return fmt::format("precondition met in tick {} at cell {} by pedestrian{} {}, score {:.2f}",
                     result.ticks, *result.hit_cell, names.size() == 1 ? "" : "s",
                     fmt::join(names, ", "), result.score());
}

}  // namespace jaywalk

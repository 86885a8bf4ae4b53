// SPDX-License-Identifier: Apache-2.0
// The section with the places on the road where agents met the precondition.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

using Places = std::map<Square, std::uint64_t>;

/// All numbers of agents together.
Places places_of(const ReportData& data, const std::string& behaviour) {
  Places all;
  for (std::size_t row = 0; row < data.facts.size(); ++row) {
    if (data.comparison.summaries[row].behaviour != behaviour) continue;
    for (const auto& [square, count] : data.facts[row].places) all[square] += count;
  }
  return all;
}

/// Squares of the world's cells, coarser where there would be too many to see.
double square_size(const ReportData& data) {
  constexpr double kMostSquares = 140;
  const GroundPlan plan = data.prepared->scenario().world->plan();
  return plan.cell_m * std::max(1.0, std::ceil(plan.length_m() / plan.cell_m / kMostSquares));
}

Places coarsened(const Places& places, double size_m) {
  Places coarse;
  for (const auto& [square, count] : places) {
    const auto index = [&](int part) {
      return static_cast<int>(std::floor((part + 0.5) * kSquare_m / size_m));
    };
    coarse[{index(square.first), index(square.second)}] += count;
  }
  return coarse;
}

/// The root lets rare places be seen beside frequent ones.
double opacity(std::uint64_t count, std::uint64_t most) {
  return std::max(0.06, std::sqrt(static_cast<double>(count) / static_cast<double>(most)));
}

/// The legend of a picture's colours: samples with their numbers of agents.
std::string scale(std::uint64_t most, const RoadPicture& road) {
  std::string drawn;
  double x = 6;
  for (const std::uint64_t count : std::set<std::uint64_t>{1, (most + 3) / 4, most}) {
    drawn += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"14\" height=\"12\" class=\"heat\" "
        "fill-opacity=\"{:.2f}\"/>",
        x, road.legend_line() - 7, opacity(count, most));
    const std::string label = grouped(count);
    drawn += svg_text(x + 18, road.legend_line() + 4, "start", label) + '\n';
    x += 30 + 7 * static_cast<double>(label.size());
  }
  return drawn + svg_text(x, road.legend_line() + 4, "start", "agents") + '\n';
}

std::string heat(const Places& places, double size_m, std::uint64_t most, std::uint64_t all,
                 const RoadPicture& road) {
  std::string drawn;
  for (const auto& [square, count] : places) {
    drawn += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"heat\" "
        "fill-opacity=\"{:.2f}\"><title>{:g} m along, {:g} m from the left: {} ({:.1f} "
        "%)</title></rect>\n",
        road.across(square.second * size_m), road.down(square.first * size_m), road.length(size_m),
        road.breadth(size_m), opacity(count, most), (square.second + 0.5) * size_m,
        (square.first + 0.5) * size_m, grouped(count),
        100 * static_cast<double>(count) / static_cast<double>(all));
  }
  return most == 0 ? drawn : drawn + scale(most, road);
}

}  // namespace

std::string section::places(const ReportData& data) {
  if (!data.prepared || data.facts.empty()) return {};
  const double size_m = square_size(data);
  const Ground ground = data.prepared->scenario().world->ground();
  const RoadPicture road(ground);
  std::string figures;
  for (const std::string& behaviour : behaviours_of(data.comparison)) {
    const Places places = coarsened(places_of(data, behaviour), size_m);
    std::uint64_t all = 0;
    std::uint64_t most = 0;
    Square hottest;
    for (const auto& [square, count] : places) {
      all += count;
      if (count > most) hottest = square;
      most = std::max(most, count);
    }
    const std::string said =
        all == 0 ? "nobody met it"
                 : fmt::format("{}; most at {:g} m along the road", plural(all, "agent"),
                               (hottest.second + 0.5) * size_m);
    figures += figure(fmt::format("{}<small>{}</small>", escaped(behaviour), said),
                      road.draw("where the precondition was met: " + behaviour,
                                heat(places, size_m, most, all, road)));
  }
  const std::string explanation = fmt::format(
      "The more agents met the precondition in a square of {:g} m, the stronger its colour, "
      "for all numbers of agents together; each picture has a scale of its own, which grows as the "
      "root of the number. The automated vehicle drives from left to right.",
      size_m);
  return paragraph(explanation) + gallery(figures, PictureSize::wide);
}

}  // namespace jaywalk::reporting

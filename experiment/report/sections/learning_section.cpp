// SPDX-License-Identifier: Apache-2.0
// The section of learning: the progress of policies, their choices at each place before the AV, and
// the results of other behaviours in the same tests.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "experiment/compare/measures/measures.h"
#include "experiment/policy/policy.h"
#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "experiment/report/policy_map.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

/// Tests that are run again for a map.
constexpr std::uint64_t kMapTests = 1000;
constexpr double kMapWidth = 520;

struct LearnedBehaviour {
  std::size_t index = 0;  // among the prepared ones
  std::size_t series = 0;
  std::string name;
  const Policy* policy = nullptr;
};

std::vector<LearnedBehaviour> learned_behaviours(const ReportData& data) {
  std::vector<LearnedBehaviour> learned;
  const std::vector<std::string> names = behaviours_of(data.comparison);
  const std::vector<PreparedBehaviour>& prepared = data.prepared->behaviours();
  for (std::size_t series = 0; series < names.size(); ++series) {
    const auto found = std::ranges::find(prepared, names[series], &PreparedBehaviour::name);
    if (found == prepared.end() || found->policy == nullptr) continue;
    learned.push_back({static_cast<std::size_t>(found - prepared.begin()), series, found->name,
                       found->policy.get()});
  }
  return learned;
}

std::string origins(const std::vector<LearnedBehaviour>& learned) {
  Table table;
  table.columns({"behaviour", "learner", "scenario"}, Align::left);
  table.columns({"agents", "seed", "tests", "discount"});
  for (const LearnedBehaviour& each : learned) {
    const PolicyOrigin& origin = each.policy->origin();
    table.row({escaped(each.name), escaped(origin.spec.learner), escaped(origin.scenario),
               std::to_string(origin.agents), std::to_string(origin.seed), grouped(origin.tests),
               decimal(origin.spec.discount, 2)});
  }
  return table.html();
}

/// A curve for each behaviour over the tests that it had learned from.
std::string learning_curves(const std::vector<LearnedBehaviour>& learned, std::string_view title,
                            double LearningPoint::*value, std::optional<double> most) {
  PlotAxes axes{.x_title = "tests learned from", .y_title = std::string(title)};
  if (most) {
    axes.least = 0;
    axes.most = most;
  }
  std::vector<PlotSeries> series;
  for (const LearnedBehaviour& each : learned) {
    PlotSeries curve{.name = each.name, .number = each.series};
    for (const LearningPoint& point : each.policy->origin().curve) {
      curve.points.push_back({static_cast<double>(point.tests), point.*value, {}, {}});
      axes.x_most = std::max(axes.x_most, static_cast<double>(point.tests));
    }
    series.push_back(std::move(curve));
  }
  return figure(title, curves(axes, series));
}

/// The places of a map's squares on its picture: ahead of the AV is right, the AV's right is below.
struct MapFrame {
  int first_row = 0, last_row = 0;
  int first_ahead = 0, last_ahead = 0;
  double side = 1;

  MapFrame(const PolicyMap& map, int rows) : last_row(rows - 1) {
    for (const auto& [square, chosen] : map.places) {
      first_row = std::min(first_row, square.first);
      last_row = std::max(last_row, square.first);
      first_ahead = std::min(first_ahead, square.second);
      last_ahead = std::max(last_ahead, square.second);
    }
    side = kMapWidth / (last_ahead - first_ahead + 1);
  }
  [[nodiscard]] double across(double ahead) const { return (ahead - first_ahead) * side; }
  [[nodiscard]] double down(double row) const { return 2 + (row - first_row) * side; }
};

std::string option_key(const std::vector<std::string>& options, double line) {
  std::string drawn;
  double x = 0;
  for (std::size_t i = 0; i < options.size(); ++i) {
    drawn += fmt::format(
        "<rect class=\"c{}\" fill=\"currentColor\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"12\" "
        "height=\"12\"/>",
        i % kColours, x, line - 10);
    drawn += svg_text(x + 16, line, "start", options[i]) + '\n';
    x += 36 + 8.2 * static_cast<double>(options[i].size());
  }
  return drawn;
}

std::string squares(const PolicyMap& map, const MapFrame& frame, double cell_m) {
  std::string drawn;
  for (const auto& [square, chosen] : map.places) {
    std::uint64_t all = 0;
    for (const std::uint64_t count : chosen) all += count;
    const auto best = static_cast<std::size_t>(std::ranges::max_element(chosen) - chosen.begin());
    std::string said;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (chosen[i] == 0) continue;
      said += fmt::format(", {} {:.0f} %", escaped(map.options[i]),
                          100 * static_cast<double>(chosen[i]) / static_cast<double>(all));
    }
    drawn += fmt::format(
        "<rect class=\"c{}\" fill=\"currentColor\" fill-opacity=\"{:.2f}\" x=\"{:.1f}\" "
        "y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"><title>{:g} m ahead, {:g} m from the "
        "left: {}{}</title></rect>\n",
        best % kColours, static_cast<double>(chosen[best]) / static_cast<double>(all),
        frame.across(square.second), frame.down(square.first), frame.side * 0.94, frame.side * 0.94,
        (square.second + 0.5) * cell_m, (square.first + 0.5) * cell_m, plural(all, "choice"), said);
  }
  return drawn;
}

std::string map_picture(const std::string& behaviour, const PolicyMap& map,
                        const PreparedScenario& prepared) {
  const WorldSpec& world = *prepared.scenario().world;
  const GroundPlan plan = world.plan();
  const MapFrame frame(map, plan.grid.rows);
  std::string drawn = fmt::format(
      "<rect class=\"pavement\" x=\"0\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
      frame.down(frame.first_row), kMapWidth, (frame.last_row - frame.first_row + 1) * frame.side);
  for (const Area& area : world.ground().areas) {
    if (area.kind != AreaKind::lane || plan.is_drawn) continue;
    const auto [left, right] = std::ranges::minmax(area.corners, {}, &Point::x_m);
    drawn += fmt::format(
        "<rect class=\"lane\" x=\"0\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
        frame.down(left.x_m / plan.cell_m), kMapWidth,
        (right.x_m - left.x_m) / plan.cell_m * frame.side);
  }
  drawn += squares(map, frame, plan.cell_m);
  const double bottom = frame.down(frame.last_row + 1);
  drawn += svg_line(frame.across(0.5), 0, frame.across(0.5), bottom + 4, "class=\"axis\"");
  drawn += svg_text(frame.across(0), bottom + 15, "start", "AV");
  const Axis axis{.least = frame.first_ahead * plan.cell_m,
                  .most = (frame.last_ahead + 1) * plan.cell_m,
                  .begin = 0,
                  .end = kMapWidth};
  for (const double mark : axis.marks(8)) {
    if (mark <= 0) continue;
    const double place = axis.at(mark);
    const bool is_last = place > kMapWidth - 24;
    drawn += svg_text(is_last ? kMapWidth : place, bottom + 15, is_last ? "end" : "middle",
                      fmt::format("{:g} m", mark));
  }
  drawn += option_key(map.options, bottom + 36);
  const std::string label = fmt::format("{} chooses {}", behaviour, map.part);
  return figure(fmt::format("{}: {}<small>{}</small>", escaped(behaviour), escaped(map.part),
                            plural(map.choices, "choice")),
                svg(kMapWidth, bottom + 42, label, drawn));
}

std::string maps(const ReportData& data, const std::vector<LearnedBehaviour>& learned) {
  std::string figures;
  for (const LearnedBehaviour& each : learned) {
    const std::vector<std::uint32_t> agents = agents_of(data.comparison);
    const PolicyMapTests tests{.behaviour = each.index,
                               .agents = agents.front(),
                               .seed = data.description.seed,
                               .first = data.description.first_test,
                               .count = std::min(kMapTests, data.description.tests)};
    for (const PolicyMap& map : policy_maps(*data.prepared, tests)) {
      figures += map_picture(each.name, map, *data.prepared);
    }
  }
  if (figures.empty()) return {};
  return paragraph(
             "What an agent chooses where it stands before the AV, which drives from left to "
             "right: "
             "the option that was drawn most often there, the stronger its colour, the more often. "
             "The first tests of the fewest agents were run once more for it.") +
         gallery(figures, PictureSize::wide);
}

std::string compared_behaviours(const ReportData& data,
                                const std::vector<LearnedBehaviour>& learned) {
  constexpr std::array kMeasures = {"accuracy", "score"};
  Table table;
  table.columns({"behaviour", "learned"}, Align::left);
  table.column("agents");
  for (const char* name : kMeasures) table.column(name);
  for (const std::string& behaviour : behaviours_of(data.comparison)) {
    const bool is_learned =
        std::ranges::find(learned, behaviour, &LearnedBehaviour::name) != learned.end();
    for (const std::uint32_t agents : agents_of(data.comparison)) {
      const Summary* const summary = find_summary(data.comparison, behaviour, agents);
      if (summary == nullptr) continue;
      std::vector<std::string> cells{escaped(behaviour), is_learned ? "yes" : "no",
                                     std::to_string(agents)};
      for (const char* name : kMeasures) {
        cells.push_back(decimal(find_measure(name)->estimate(*summary).value, 1));
      }
      table.row(std::move(cells));
    }
  }
  return table.html();
}

}  // namespace

std::string section::learning(const ReportData& data) {
  if (!data.prepared) return {};
  const std::vector<LearnedBehaviour> learned = learned_behaviours(data);
  if (learned.empty()) return {};
  const std::string figures =
      learning_curves(learned, "Tests that met the precondition, %", &LearningPoint::success_pct,
                      100) +
      learning_curves(learned, "Discounted reward of an agent", &LearningPoint::reward, {});
  return origins(learned) +
         paragraph(
             "While it was learned, of the tests since the mark before, in which options were "
             "also tried:") +
         gallery(figures) + maps(data, learned) +
         paragraph("What is learned beside the other behaviours of the comparison:") +
         compared_behaviours(data, learned);
}

}  // namespace jaywalk::reporting

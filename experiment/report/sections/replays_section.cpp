// SPDX-License-Identifier: Apache-2.0
// The section of selected tests: a picture of all actors' ways, and a link to the page that plays
// the test.

#include <fmt/format.h>

#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

/// Whether an event of that kind concerns the actor.
bool concerned(const Recording& recording, std::size_t actor, std::string_view kind) {
  for (const RecordedEvent& event : recording.events()) {
    if (event.kind == kind && event.actor == actor) return true;
  }
  return false;
}

std::string way(const Recording& recording, std::size_t actor, const RoadPicture& road) {
  std::string points;
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    const ActorState& state = recording.scene(tick)[actor];
    points += fmt::format("{}{:.1f} {:.1f}", tick == 0 ? "M" : "L", road.across(state.y_m),
                          road.down(state.x_m));
  }
  return points;
}

std::string tracks(const Recording& recording, const RoadPicture& road) {
  std::string drawn;
  for (std::size_t actor = 0; actor < recording.actors().size(); ++actor) {
    const Actor& each = recording.actors()[actor];
    const ActorState& last = recording.scene(recording.scenes() - 1)[actor];
    const double x = road.across(last.y_m);
    const double y = road.down(last.x_m);
    const bool met = concerned(recording, actor, "precondition");
    const std::string_view style = each.kind == ActorKind::vehicle ? "ink" : met ? "c1" : "c0";
    drawn += fmt::format("<g class=\"{}\"><path d=\"{}\"/>", style, way(recording, actor, road));
    if (each.kind == ActorKind::vehicle) {
      const double length = road.length(each.length_m);
      const double width = road.breadth(each.width_m);
      drawn += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"av\"/>",
          x - length / 2, y - width / 2, length, width);
    } else {
      drawn += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"currentColor\"/>",
                           x, y, met ? 3.5 : 2.5);
    }
    drawn += fmt::format("<title>{}{}</title></g>\n", escaped(each.name),
                         met ? ", met the precondition" : "");
  }
  return drawn;
}

std::string command(const ReportData& data, const ReplayLink& link) {
  return fmt::format("jaywalk replay {} --behaviour {} --agents {} --test {}",
                     shell_quoted(data.store_path.empty() ? "STORE.gpkg" : data.store_path),
                     shell_quoted(data.description.behaviours[link.test.behaviour].name),
                     link.test.agents, link.test.number);
}

}  // namespace

std::string section::replays(const ReportData& data) {
  if (data.replays.empty() || !data.prepared) return {};
  const Ground ground = data.prepared->scenario().world->ground();
  const RoadPicture road(ground);
  std::string figures;
  for (const ReplayLink& link : data.replays) {
    std::string title = fmt::format("{}, {}, test {}",
                                    escaped(data.description.behaviours[link.test.behaviour].name),
                                    plural(link.test.agents, "agent"), link.test.number);
    if (!link.page.empty()) {
      title = fmt::format("<a href=\"{}\">{}</a>", escaped_uri(link.page), title);
    }
    std::string picture;
    if (link.recording.scenes() > 0) {
      picture = road.draw("ways of all actors", tracks(link.recording, road));
    }
    picture += fmt::format("<p class=\"note\"><code>{}</code></p>\n", escaped(command(data, link)));
    figures += figure(fmt::format("{}<small>{}</small>", title, escaped(link.reason)), picture);
  }
  return paragraph(
             "Everybody’s way from the beginning of the test to its end, where the dot is; "
             "<span class=\"c1\">those who met the precondition</span>, <span class=\"c0\">the "
             "others</span>. The command plays the test in the terminal; <code>--html FILE</code> "
             "writes a page with the agents’ beliefs and intentions, <code>--png</code> and "
             "<code>--gif</code> pictures.") +
         gallery(figures, PictureSize::wide);
}

}  // namespace jaywalk::reporting

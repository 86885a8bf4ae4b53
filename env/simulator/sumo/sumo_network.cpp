// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/sumo/sumo_network.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "env/simulator/sumo/sumo_process.h"

namespace jaywalk {
namespace {

// Above any vehicle's own speed, so that the lane's limit never slows one down.
constexpr double kNoLimitMps = 100;

// Debian's package has no type maps, without which netconvert reads no maps of others. These are
// the roads for cars of OpenStreetMap, with pavements, and the lanes of OpenDRIVE; it leaves out
// the rest.
constexpr std::string_view kOpenStreetMapTypes = R"(<types>
<type id="highway.motorway" numLanes="2" speed="33.3" priority="14" disallow="pedestrian"/>
<type id="highway.trunk" numLanes="2" speed="27.8" priority="12" disallow="pedestrian"/>
<type id="highway.primary" numLanes="1" speed="13.9" priority="10" sidewalkWidth="2"/>
<type id="highway.secondary" numLanes="1" speed="13.9" priority="8" sidewalkWidth="2"/>
<type id="highway.tertiary" numLanes="1" speed="13.9" priority="6" sidewalkWidth="2"/>
<type id="highway.unclassified" numLanes="1" speed="13.9" priority="5" sidewalkWidth="2"/>
<type id="highway.residential" numLanes="1" speed="13.9" priority="4" sidewalkWidth="2"/>
<type id="highway.living_street" numLanes="1" speed="2.8" priority="3"/>
<type id="highway.service" numLanes="1" speed="5.6" priority="2"/>
</types>
)";
constexpr std::string_view kOpenDriveTypes = R"(<types>
<type id="driving" numLanes="1" speed="27.8" priority="1" disallow="pedestrian"/>
<type id="sidewalk" numLanes="1" speed="1.5" priority="1" allow="pedestrian"/>
<type id="none" discard="true"/>
<type id="border" discard="true"/>
<type id="shoulder" discard="true"/>
<type id="median" discard="true"/>
<type id="parking" discard="true"/>
<type id="restricted" discard="true"/>
<type id="biking" discard="true"/>
</types>
)";

/// Bands beside each other that are one edge.
using Group = std::span<const RoadBand>;

std::vector<Group> groups_of(std::span<const RoadBand> bands) {
  std::vector<Group> groups;
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= bands.size(); ++end) {
    const bool goes_on = end < bands.size() && bands[end].kind == AreaKind::lane &&
                         bands[begin].kind == AreaKind::lane &&
                         bands[end].oncoming == bands[begin].oncoming;
    if (goes_on) continue;
    groups.push_back(bands.subspan(begin, end - begin));
    begin = end;
  }
  return groups;
}

// Stop lines that are no further apart have one light, at the first of them.
constexpr double kOneLineM = 1;

/// Where the vehicles of some lanes stop, and the crosswalks, by index, for which they do.
struct LightLine {
  double at_m = 0;
  std::vector<std::size_t> crosswalks;
};

/// In the order of the traffic: it stops where a crosswalk begins for it.
std::vector<LightLine> light_lines(const Ground& ground, bool back) {
  std::vector<LightLine> each;
  for (std::size_t i = 0; i < ground.crosswalks.size(); ++i) {
    const GroundCrosswalk& crosswalk = ground.crosswalks[i];
    if (crosswalk.zebra) continue;
    double far_m = crosswalk.begins_m;
    for (const Rectangle& part : crosswalk.parts) far_m = std::max(far_m, part.far);
    each.push_back({back ? far_m : crosswalk.begins_m, {i}});
  }
  std::ranges::stable_sort(each, {},
                           [&](const LightLine& line) { return back ? -line.at_m : line.at_m; });
  std::vector<LightLine> lines;
  for (const LightLine& line : each) {
    if (lines.empty() || std::fabs(line.at_m - lines.back().at_m) > kOneLineM) {
      lines.push_back(line);
    } else {
      lines.back().crosswalks.push_back(line.crosswalks.front());
    }
  }
  return lines;
}

class Planner {
 public:
  Planner(SumoNetworkPlan& plan, const Ground& ground) : plan_(plan), ground_(ground) {}

  void add(Group group, std::size_t number) {
    const RoadBand& first = group.front();
    const bool walking = first.kind == AreaKind::pavement;
    const std::string name = fmt::format("{}{}", walking ? "pavement" : "road", number);
    const double middle_m = (first.left_m + group.back().right_m) / 2;
    plan_.nodes += fmt::format(
        "<node id=\"{0}a\" x=\"{1:.9g}\" y=\"{2:.9g}\"/>\n<node id=\"{0}b\" x=\"{1:.9g}\" "
        "y=\"{3:.9g}\"/>\n",
        name, middle_m, plan_.from_m, plan_.to_m);
    if (walking) {
      add_edge(group, name, name + 'a', name + 'b');
      if (plan_.walking_edge.empty()) plan_.walking_edge = name;
    } else {
      add_course(group, name, first.oncoming);
    }
  }

 private:
  struct Course {
    std::vector<std::string> edges;
    std::vector<double> begins_m;
  };

  /// Lane 0 is the outermost one: the first from the left where traffic keeps to the left and the
  /// edge leads forward, or where it does neither.
  [[nodiscard]] const RoadBand& band_of(Group group, std::size_t lane) const {
    const bool from_left = plan_.left_hand != group.front().oncoming;
    return group[from_left ? lane : group.size() - 1 - lane];
  }

  /// The lanes' permissions. A pedestrian at a light is between two edges, and SUMO then requires
  /// that both allow pedestrians.
  [[nodiscard]] std::string_view who_may(Group group) const {
    if (group.front().kind == AreaKind::pavement) return "allow=\"pedestrian\"";
    return parted_ ? "allow=\"all\"" : "disallow=\"pedestrian\"";
  }

  /// From one end of the network to the other, with a light at each stop line.
  void add_course(Group group, const std::string& name, bool back) {
    const std::vector<LightLine> lines = light_lines(ground_, back);
    parted_ = !lines.empty();
    Course course{.edges = {name}, .begins_m = {0}};
    std::string from = name + (back ? 'b' : 'a');
    for (const LightLine& line : lines) {
      const std::string light = fmt::format("{}light{}", name, course.edges.size());
      add_light(group, light, line, back);
      add_edge(group, course.edges.back(), from, light);
      course.edges.push_back(fmt::format("{}after{}", name, course.edges.size()));
      const double way_m = back ? plan_.to_m - line.at_m : line.at_m - plan_.from_m;
      course.begins_m.push_back(way_m + kLightM);
      from = light;
    }
    add_edge(group, course.edges.back(), from, name + (back ? 'a' : 'b'));
    add_lanes(group, course);
  }

  /// A junction over the lanes' whole width.
  void add_light(Group group, const std::string& name, const LightLine& line, bool back) {
    const double near_m = back ? line.at_m - kLightM : line.at_m;
    const double left_m = group.front().left_m;
    const double right_m = group.back().right_m;
    plan_.nodes += fmt::format(
        "<node id=\"{0}\" x=\"{1:.9g}\" y=\"{2:.9g}\" type=\"traffic_light\" "
        "shape=\"{4:.9g},{3:.9g} {5:.9g},{3:.9g} {5:.9g},{6:.9g} {4:.9g},{6:.9g}\"/>\n",
        name, (left_m + right_m) / 2, near_m + kLightM / 2, near_m, left_m, right_m,
        near_m + kLightM);
    plan_.lights.push_back({name, group.size(), line.crosswalks});
  }

  void add_edge(Group group, const std::string& edge, const std::string& from,
                const std::string& to) {
    plan_.edges += fmt::format(
        "<edge id=\"{}\" from=\"{}\" to=\"{}\" numLanes=\"{}\" speed=\"{}\" "
        "spreadType=\"center\">\n",
        edge, from, to, group.size(), kNoLimitMps);
    for (std::size_t lane = 0; lane < group.size(); ++lane) {
      const RoadBand& band = band_of(group, lane);
      plan_.edges += fmt::format("<lane index=\"{}\" width=\"{:.9g}\" {}/>\n", lane,
                                 band.right_m - band.left_m, who_may(group));
    }
    plan_.edges += "</edge>\n";
  }

  void add_lanes(Group group, const Course& course) {
    for (std::size_t lane = 0; lane < group.size(); ++lane) {
      const RoadBand& band = band_of(group, lane);
      plan_.lanes.push_back({course.edges, course.begins_m, static_cast<int>(lane), band.left_m,
                             band.right_m, band.oncoming});
    }
  }

  SumoNetworkPlan& plan_;
  const Ground& ground_;
  bool parted_ = false;
};

// Shorter pieces have no direction to speak of.
constexpr double kShortestM = 1e-3;
constexpr double kAhead = std::numbers::pi / 2;

}  // namespace

bool keeps_left(std::span<const RoadBand> bands) {
  const auto first = [&](bool oncoming) {
    return std::ranges::find_if(bands, [&](const RoadBand& band) {
      return band.kind == AreaKind::lane && band.oncoming == oncoming;
    });
  };
  return first(true) != bands.end() && first(false) < first(true);
}

SumoNetworkPlan plan_sumo_network(const SimulatedRoad& road, double first_m, double last_m) {
  SumoNetworkPlan plan;
  plan.left_hand = keeps_left(road.bands);
  plan.from_m = first_m;
  plan.to_m = last_m;
  plan.nodes = "<nodes>\n";
  plan.edges = "<edges>\n";
  Planner planner(plan, road.ground);
  std::size_t number = 0;
  for (const Group group : groups_of(road.bands)) planner.add(group, ++number);
  if (plan.walking_edge.empty()) {
    // Persons have to begin on a pavement; they are put where they are in the first step.
    const RoadBand beside{.kind = AreaKind::pavement, .left_m = -22, .right_m = -20};
    planner.add(Group(&beside, 1), ++number);
  }
  plan.nodes += "</nodes>\n";
  plan.edges += "</edges>\n";
  std::ranges::sort(plan.lanes, {}, &SumoLane::left_m);
  return plan;
}

std::string make_sumo_network(const SumoNetworkPlan& plan, const std::string& path) {
  MemoryFile nodes;
  MemoryFile edges;
  if (!nodes.write(plan.nodes) || !edges.write(plan.edges)) return "there is no memory for a map";
  return run_sumo_tool({"netconvert", "--node-files", nodes.path(), "--edge-files", edges.path(),
                        "--output-file", path, "--lefthand", plan.left_hand ? "true" : "false",
                        "--offset.disable-normalization", "true", "--no-turnarounds", "true",
                        "--precision", "6", "--no-warnings", "true"});
}

bool is_sumo_network(const std::string& map) { return map.ends_with(".net.xml"); }

std::string convert_to_sumo_network(const std::string& map, bool left_hand,
                                    const std::string& path) {
  std::vector<std::string> command{"netconvert",
                                   "--output-file",
                                   path,
                                   "--lefthand",
                                   left_hand ? "true" : "false",
                                   "--precision",
                                   "6",
                                   "--no-turnarounds",
                                   "true",
                                   "--no-warnings",
                                   "true"};
  MemoryFile types;
  std::vector<std::string> inputs{"--node-files", map, "--edge-files", map};
  std::string_view known;
  if (map.ends_with(".xodr")) {
    inputs = {"--opendrive-files", map, "--sidewalks.guess", "true"};
    known = kOpenDriveTypes;
  } else if (map.ends_with(".osm") || map.ends_with(".osm.xml")) {
    inputs = {"--osm-files", map};
    known = kOpenStreetMapTypes;
  }
  if (!known.empty()) {
    if (!types.write(known)) return "there is no memory for a map";
    inputs.insert(inputs.end(), {"--type-files", types.path()});
  }
  command.insert(command.end(), inputs.begin(), inputs.end());
  return run_sumo_tool(command);
}

RoadFrame::RoadFrame(const std::vector<TraciPoint>& line, double begin_m, double line_x_m)
    : begin_m_(begin_m), line_x_m_(line_x_m) {
  double end_m = 0;
  TraciPoint from = line.front();
  for (const TraciPoint& to : line) {
    const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
    if (length_m < kShortestM) continue;
    segments_.push_back({from, std::atan2(to.y_m - from.y_m, to.x_m - from.x_m), length_m});
    end_m += length_m;
    ends_m_.push_back(end_m);
    from = to;
  }
  assert(!segments_.empty() && "a line has a direction");
}

std::size_t RoadFrame::segment_at(double along_m) const {
  const auto found = std::ranges::upper_bound(ends_m_, along_m);
  return std::min(static_cast<std::size_t>(found - ends_m_.begin()), segments_.size() - 1);
}

RoadFrame::Pose RoadFrame::to_map(Pose world) const {
  if (segments_.empty()) return world;
  const double along_m = world.y_m + begin_m_;
  const std::size_t index = segment_at(along_m);
  const Segment& segment = segments_[index];
  const double on_m = along_m - (ends_m_[index] - segment.length_m);
  const double right_m = world.x_m - line_x_m_;
  const double cosine = std::cos(segment.heading_rad);
  const double sine = std::sin(segment.heading_rad);
  return {segment.from.x_m + on_m * cosine + right_m * sine,
          segment.from.y_m + on_m * sine - right_m * cosine,
          world.heading_rad + segment.heading_rad - kAhead};
}

RoadFrame::Pose RoadFrame::to_world(Pose map) const {
  if (segments_.empty()) return map;
  Pose nearest;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& segment = segments_[i];
    const double x_m = map.x_m - segment.from.x_m;
    const double y_m = map.y_m - segment.from.y_m;
    const double cosine = std::cos(segment.heading_rad);
    const double sine = std::sin(segment.heading_rad);
    const double on_m = x_m * cosine + y_m * sine;
    const double right_m = x_m * sine - y_m * cosine;
    // The first and the last segment go on.
    const double before_m = i == 0 ? 0 : std::max(0.0, -on_m);
    const double behind_m = i + 1 == segments_.size() ? 0 : std::max(0.0, on_m - segment.length_m);
    const double off_m = std::hypot(right_m, before_m + behind_m);
    if (off_m >= least_m) continue;
    least_m = off_m;
    const double kept_m = on_m + before_m - behind_m;
    nearest = {line_x_m_ + right_m, ends_m_[i] - segment.length_m + kept_m - begin_m_,
               map.heading_rad - segment.heading_rad + kAhead};
  }
  return nearest;
}

}  // namespace jaywalk

#include "env/simulator/sumo/sumo_network.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "env/simulator/sumo/memory_file.h"
#include "env/simulator/sumo/sumo_process.h"

namespace jaywalk {
namespace {

// No vehicle is to be held up by a limit of the lane: each has a speed of its own.
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

class Planner {
 public:
  Planner(SumoNetworkPlan& plan) : plan_(plan) {}

  void add(Group group, std::size_t number) {
    const RoadBand& first = group.front();
    const bool walking = first.kind == AreaKind::pavement;
    const std::string edge = fmt::format("{}{}", walking ? "pavement" : "road", number);
    const double middle_m = (first.left_m + group.back().right_m) / 2;
    plan_.nodes += fmt::format(
        "<node id=\"{0}a\" x=\"{1:.9g}\" y=\"{2:.9g}\"/>\n<node id=\"{0}b\" x=\"{1:.9g}\" "
        "y=\"{3:.9g}\"/>\n",
        edge, middle_m, plan_.from_m, plan_.to_m);
    const bool back = !walking && first.oncoming;
    plan_.edges += fmt::format(
        "<edge id=\"{0}\" from=\"{0}{1}\" to=\"{0}{2}\" numLanes=\"{3}\" speed=\"{4}\" "
        "spreadType=\"center\">\n",
        edge, back ? 'b' : 'a', back ? 'a' : 'b', group.size(), kNoLimitMps);
    // Lane 0 is the outermost one: the first from the left where traffic keeps to the left and the
    // edge leads forward, or where it does neither.
    const bool from_left = plan_.left_hand != back;
    for (std::size_t i = 0; i < group.size(); ++i) {
      const std::size_t index = from_left ? i : group.size() - 1 - i;
      add_lane(group[index], edge, i, walking);
    }
    plan_.edges += "</edge>\n";
    if (walking && plan_.walking_edge.empty()) plan_.walking_edge = edge;
  }

 private:
  void add_lane(const RoadBand& band, const std::string& edge, std::size_t index, bool walking) {
    plan_.edges += fmt::format("<lane index=\"{}\" width=\"{:.9g}\" {}=\"pedestrian\"/>\n", index,
                               band.right_m - band.left_m, walking ? "allow" : "disallow");
    if (walking) return;
    plan_.lanes.push_back(
        {edge, static_cast<int>(index), band.left_m, band.right_m, band.oncoming});
  }

  SumoNetworkPlan& plan_;
};

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
  Planner planner(plan);
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
    inputs = {"--opendrive-files", map};
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

}  // namespace jaywalk

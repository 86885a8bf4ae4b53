#include "env/simulator/sumo/sumo_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "env/simulator/sumo/sumo_network.h"

namespace jaywalk {
namespace {

// How much longer than the road the network is: vehicles come into sight before they are near, and
// no test ends because the AV has left it.
constexpr double kBeforeM = 150;
constexpr double kBeyondM = 600;
// Lanes within a junction between two edges: more are no way of anybody.
constexpr int kMostLanesOfAJunction = 20;

SumoWay way_of(const SumoLane& lane, const SumoNetworkPlan& plan) {
  return {.edges = lane.edges,
          .begins_m = lane.begins_m,
          .lane = lane.index,
          .zero_m = lane.oncoming ? plan.to_m : -plan.from_m,
          .length_m = plan.to_m - plan.from_m,
          .middle_x_m = (lane.left_m + lane.right_m) / 2,
          .oncoming = lane.oncoming};
}

/// A lane that one leads to, and the one through the junction to there; empty: there is none.
struct LaneLink {
  std::string lane;
  std::string via;
};

/// SUMO counts the links of a lane and has eight values for each.
std::vector<LaneLink> links_of(const TraciValue& value) {
  constexpr std::size_t kValuesOfALink = 8;
  std::vector<LaneLink> links;
  for (std::size_t at = 1; at + kValuesOfALink <= value.items.size(); at += kValuesOfALink) {
    links.push_back({value.items[at].text, value.items[at + 1].text});
  }
  return links;
}

/// Where a lane of an edge begins on the way.
struct WayEdge {
  int lane = 0;
  double begin_m = 0;
};

double length_of(const std::vector<TraciPoint>& line) {
  double length_m = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length_m += std::hypot(line[i].x_m - line[i - 1].x_m, line[i].y_m - line[i - 1].y_m);
  }
  return length_m;
}

/// Follows lanes on a map that a SUMO has loaded.
class LaneWalker {
 public:
  explicit LaneWalker(SumoProcess& sumo) : sumo_(sumo) {}

  /// The places along lanes that lead from edge to edge. Why there are none.
  std::string walk(const std::vector<std::string>& edges, std::vector<TraciPoint>& line,
                   std::vector<WayEdge>& ways) {
    std::string problem;
    for (int lane = 0; has_lane(edges.front(), lane, problem); ++lane) {
      line.clear();
      ways.clear();
      if (follow(lane_name(edges.front(), lane), edges, 1, line, ways, problem)) return {};
      if (!problem.empty()) return problem;
    }
    if (!problem.empty()) return problem;
    return fmt::format("no lane of the edge '{}' leads through all edges of the route",
                       edges.front());
  }

  /// The first of the edges onto which pedestrians may; empty if they may onto none.
  std::string walkable(const std::vector<std::string>& edges, std::string& problem) {
    for (const std::string& edge : edges) {
      for (int lane = 0; has_lane(edge, lane, problem); ++lane) {
        if (lets_in("pedestrian", lane_name(edge, lane), problem)) return edge;
        if (!problem.empty()) return {};
      }
    }
    return {};
  }

 private:
  static std::string lane_name(const std::string& edge, int lane) {
    return fmt::format("{}_{}", edge, lane);
  }

  bool has_lane(const std::string& edge, int lane, std::string& problem) {
    TraciMessage message;
    message.get(TraciCommand::edge_get, TraciVariable::lane_count, edge);
    const TraciAnswer answer = sumo_.ask(message);
    problem = answer.error;
    if (!problem.empty() || answer.objects.empty()) return false;
    const TraciValue* const count =
        answer.objects.front().find(TraciVariable::lane_count, TraciType::integer);
    return count != nullptr && lane < static_cast<int>(count->number);
  }

  /// Whether those of a class may be there: a list of who may, that is empty where all may.
  bool lets_in(std::string_view who, const std::string& lane, std::string& problem) {
    TraciMessage message;
    message.get(TraciCommand::lane_get, TraciVariable::allowed, lane);
    const TraciAnswer answer = sumo_.ask(message);
    problem = answer.error;
    if (!problem.empty() || answer.objects.empty()) return false;
    const TraciValue* const found =
        answer.objects.front().find(TraciVariable::allowed, TraciType::texts);
    return found != nullptr &&
           (found->texts.empty() || std::ranges::find(found->texts, who) != found->texts.end());
  }

  bool ask(const std::string& lane, std::vector<TraciPoint>& shape, std::vector<LaneLink>& links,
           std::string& problem) {
    TraciMessage message;
    message.get(TraciCommand::lane_get, TraciVariable::shape, lane);
    message.get(TraciCommand::lane_get, TraciVariable::links, lane);
    const TraciAnswer answer = sumo_.ask(message);
    problem = answer.error;
    if (!problem.empty() || answer.objects.size() != 2) return false;
    const TraciValue* const points =
        answer.objects[0].find(TraciVariable::shape, TraciType::polygon);
    const TraciValue* const found =
        answer.objects[1].find(TraciVariable::links, TraciType::compound);
    if (points == nullptr || found == nullptr) return false;
    shape = points->points;
    links = links_of(*found);
    return true;
  }

  /// On from a lane to the edges from number `next` on.
  bool follow(const std::string& lane, const std::vector<std::string>& edges, std::size_t next,
              std::vector<TraciPoint>& line, std::vector<WayEdge>& ways, std::string& problem) {
    std::vector<TraciPoint> shape;
    std::vector<LaneLink> links;
    if (!lets_in("passenger", lane, problem)) return false;
    if (!ask(lane, shape, links, problem) || shape.size() < 2) return false;
    const std::size_t before = line.size();
    line.insert(line.end(), shape.begin(), shape.begin() + 1);
    ways.push_back({std::stoi(lane.substr(lane.rfind('_') + 1)), length_of(line)});
    line.insert(line.end(), shape.begin() + 1, shape.end());
    if (next == edges.size()) return true;
    for (const LaneLink& link : links) {
      if (link.lane.substr(0, link.lane.rfind('_')) != edges[next]) continue;
      if (!cross_junction(link.via, line, problem)) return false;
      if (follow(link.lane, edges, next + 1, line, ways, problem)) return true;
      if (!problem.empty()) return false;
    }
    line.resize(before);
    ways.pop_back();
    return false;
  }

  bool cross_junction(std::string via, std::vector<TraciPoint>& line, std::string& problem) {
    for (int i = 0; !via.empty() && i < kMostLanesOfAJunction; ++i) {
      std::vector<TraciPoint> shape;
      std::vector<LaneLink> links;
      if (!ask(via, shape, links, problem)) return false;
      line.insert(line.end(), shape.begin(), shape.end());
      via = links.empty() ? std::string() : links.front().via;
    }
    return true;
  }

  SumoProcess& sumo_;
};

}  // namespace

WayPlace place_on(const SumoWay& way, double position_m) {
  WayPlace place{.edge = 0, .along_m = position_m};
  for (std::size_t i = 1; i < way.begins_m.size(); ++i) {
    if (position_m < way.begins_m[i]) {
      const double end_m = way.begins_m[i] - kLightM - way.begins_m[i - 1];
      place.along_m = std::min(place.along_m, end_m);
      break;
    }
    place = {.edge = i, .along_m = position_m - way.begins_m[i]};
  }
  return place;
}

std::string SumoMap::path() const {
  return is_sumo_network(settings_.net) ? settings_.net : made_.path();
}

std::string SumoMap::prepare(const SimulatedTest& test, bool& changed) {
  if (settings_.net.empty()) return prepare_bands(test, changed);
  changed = !surveyed_;
  if (changed && !is_sumo_network(settings_.net)) {
    std::string problem =
        convert_to_sumo_network(settings_.net, keeps_left(test.road.bands), made_.path());
    if (!problem.empty()) return problem;
  }
  if (changed) av_way_ = {.edges = settings_.route, .begins_m = {}};
  flow_ways_.clear();
  for (const SumoFlow& flow : settings_.traffic) {
    flow_ways_.push_back(
        {.edges = flow.route, .begins_m = {}, .lane = flow.lane > 0 ? flow.lane - 1 : kBestLane});
  }
  return {};
}

std::string SumoMap::prepare_bands(const SimulatedTest& test, bool& changed) {
  if (test.road.bands.empty()) {
    return "SUMO's network is made from bands: a ground that is drawn as a map has none";
  }
  const double rear_m = test.av_start.y_m - test.av.length_m / 2;
  const SumoNetworkPlan plan =
      plan_sumo_network(test.road, std::min(0.0, rear_m) - kBeforeM, test.road.length_m + kBeyondM);
  const auto own = std::ranges::find_if(plan.lanes, [&](const SumoLane& lane) {
    return lane.left_m <= test.av_start.x_m && test.av_start.x_m <= lane.right_m && !lane.oncoming;
  });
  if (own == plan.lanes.end()) return "the AV begins in no lane that leads forward";
  av_way_ = way_of(*own, plan);
  flow_ways_.clear();
  for (const SumoFlow& flow : settings_.traffic) {
    const auto number = static_cast<std::size_t>(std::max(flow.lane, 1));
    if (number > plan.lanes.size()) {
      return fmt::format("a flow of traffic has lane {}, but there are only {}", number,
                         plan.lanes.size());
    }
    flow_ways_.push_back(way_of(plan.lanes[number - 1], plan));
  }
  lights_ = plan.lights;
  walking_edge_ = plan.walking_edge;
  std::string text = fmt::format("{}{}{}", plan.left_hand, plan.nodes, plan.edges);
  changed = text != made_from_;
  if (!changed) return {};
  made_from_.clear();
  std::string problem = make_sumo_network(plan, made_.path());
  if (problem.empty()) made_from_ = std::move(text);
  return problem;
}

std::string SumoMap::survey(const SimulatedTest& test, SumoProcess& sumo) {
  if (settings_.net.empty() || surveyed_) return {};
  std::vector<TraciPoint> line;
  std::vector<WayEdge> ways;
  LaneWalker walker(sumo);
  std::string problem = walker.walk(settings_.route, line, ways);
  if (problem.empty()) walking_edge_ = walker.walkable(settings_.route, problem);
  if (!problem.empty()) return problem;
  if (walking_edge_.empty()) {
    return "no edge of the route lets pedestrians onto it (netconvert --sidewalks.guess makes "
           "some)";
  }
  frame_ = RoadFrame(line, settings_.begin_m, test.av_start.x_m);
  // The edge on which the AV begins.
  const double front_m = settings_.begin_m + test.av_start.y_m + test.av.length_m / 2;
  std::size_t first = 0;
  while (first + 1 < ways.size() && ways[first + 1].begin_m <= front_m) ++first;
  av_way_.edges.assign(settings_.route.begin() + static_cast<std::ptrdiff_t>(first),
                       settings_.route.end());
  av_way_.lane = ways[first].lane;
  av_way_.zero_m = settings_.begin_m - ways[first].begin_m;
  av_way_.length_m = frame_.length_m();
  const double needed_m = settings_.begin_m + test.road.length_m;
  if (frame_.length_m() < needed_m) {
    return fmt::format("the route is {:.1f} m long, the scenario's road ends at {:.1f} m of it",
                       frame_.length_m(), needed_m);
  }
  surveyed_ = true;
  return {};
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/sumo/sumo_map.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "env/simulator/sumo/sumo_network.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {
namespace {

// How much longer than the road the network is: vehicles come into sight before they are near, and
// no test ends because the AV has left it.
constexpr double kBeforeM = 150;
constexpr double kBeyondM = 600;
// The most lanes within a junction between two edges of a way.
constexpr int kMostLanesOfAJunction = 20;
constexpr std::size_t kMostListed = 40;

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

}  // namespace

/// Follows lanes on a map that a SUMO has loaded.
class LaneWalker {
 public:
  explicit LaneWalker(SumoProcess& sumo) : sumo_(sumo) {}

  /// The edges of routes that the map does not have.
  void find_missing(const SumoSettings& settings, std::vector<SettingProblem>& problems) {
    std::string problem;
    const std::vector<std::string> edges = edges_of_map(problem);
    if (!problem.empty()) return problems.push_back({"net", std::move(problem)});
    const auto look_up = [&](std::string_view key, const std::vector<std::string>& route) {
      for (const std::string& edge : route) {
        if (std::ranges::find(edges, edge) != edges.end()) continue;
        std::string hint = did_you_mean(edge, edges);
        if (hint.empty()) hint = listed(edges);
        problems.push_back({std::string(key), fmt::format("the map has no edge '{}'", edge), hint});
      }
    };
    look_up("route", settings.route);
    for (const SumoFlow& flow : settings.traffic) look_up("traffic", flow.route);
  }

  /// Where vehicles begin faster than SUMO lets them: it gives up then.
  void find_too_fast(const SumoSettings& settings, const SumoWay& av_way, double av_mps,
                     std::vector<SettingProblem>& problems) {
    const auto compare = [&](std::string_view key, std::string_view who, const std::string& edge,
                             double wanted_mps, std::string_view hint) {
      std::string problem;
      const double allowed_mps = fastest(edge, problem);
      if (!problem.empty()) return problems.push_back({std::string(key), std::move(problem)});
      if (wanted_mps <= allowed_mps) return;
      problems.push_back(
          {std::string(key),
           fmt::format("{} begins at {:g} m/s on the edge '{}', which allows {:g} m/s", who,
                       wanted_mps, edge, allowed_mps),
           std::string(hint)});
    };
    compare("route", "the AV", av_way.edges.front(), av_mps,
            "lower world.av.speed_mps, or begin on another edge");
    for (std::size_t i = 0; i < settings.traffic.size(); ++i) {
      const SumoFlow& flow = settings.traffic[i];
      compare("traffic", fmt::format("flow {}", i + 1), flow.route.front(), flow.speed_mps,
              "lower the flow's speed, or begin its route with another edge");
      if (flow.lane > 0) find_closed_lane(flow, problems);
    }
  }

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
  void find_closed_lane(const SumoFlow& flow, std::vector<SettingProblem>& problems) {
    const std::string& edge = flow.route.front();
    std::string problem;
    const bool open = has_lane(edge, flow.lane - 1, problem) &&
                      lets_in("passenger", lane_name(edge, flow.lane - 1), problem);
    if (!problem.empty()) return problems.push_back({"traffic", std::move(problem)});
    if (open) return;
    problems.push_back(
        {"traffic", fmt::format("cars may not drive in lane {} of the edge '{}'", flow.lane, edge),
         "lanes are counted from the edge's outer side, pavements with them"});
  }

  static std::string lane_name(const std::string& edge, int lane) {
    return fmt::format("{}_{}", edge, lane);
  }

  /// In SUMO's order, without those within junctions.
  std::vector<std::string> edges_of_map(std::string& problem) {
    TraciMessage message;
    message.get(TraciCommand::edge_get, TraciVariable::ids, {});
    const TraciAnswer answer = sumo_.ask(message);
    problem = answer.error;
    if (!problem.empty() || answer.objects.empty()) return {};
    const TraciValue* const found =
        answer.objects.front().find(TraciVariable::ids, TraciType::texts);
    if (found == nullptr) return {};
    std::vector<std::string> edges = found->texts;
    std::erase_if(edges, [](const std::string& edge) { return edge.starts_with(':'); });
    return edges;
  }

  static std::string listed(const std::vector<std::string>& edges) {
    const std::size_t shown = std::min(edges.size(), kMostListed);
    return fmt::format(
        "its edges are {}{}", fmt::join(std::span(edges).first(shown), ", "),
        shown < edges.size() ? fmt::format(" and {} others", edges.size() - shown) : "");
  }

  /// How fast the fastest lane of an edge lets cars be.
  double fastest(const std::string& edge, std::string& problem) {
    double mps = 0;
    for (int lane = 0; has_lane(edge, lane, problem); ++lane) {
      if (!lets_in("passenger", lane_name(edge, lane), problem)) continue;
      TraciMessage message;
      message.get(TraciCommand::lane_get, TraciVariable::max_speed, lane_name(edge, lane));
      const TraciAnswer answer = sumo_.ask(message);
      problem = answer.error;
      if (!problem.empty() || answer.objects.empty()) return 0;
      const TraciValue* const found =
          answer.objects.front().find(TraciVariable::max_speed, TraciType::real);
      if (found != nullptr) mps = std::max(mps, found->number);
    }
    return mps;
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

  /// Whether a class of vehicles may use a lane; SUMO lists no classes if all may.
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

std::vector<SettingProblem> SumoMap::survey(const SimulatedTest& test, SumoProcess& sumo) {
  std::vector<SettingProblem> problems;
  if (settings_.net.empty() || surveyed_) return problems;
  LaneWalker walker(sumo);
  walker.find_missing(settings_, problems);
  if (!problems.empty()) return problems;
  if (auto problem = find_way(test, walker)) return {std::move(*problem)};
  walker.find_too_fast(settings_, av_way_, test.cruise_mps, problems);
  surveyed_ = problems.empty();
  return problems;
}

std::optional<SettingProblem> SumoMap::find_way(const SimulatedTest& test, LaneWalker& walker) {
  std::vector<TraciPoint> line;
  std::vector<WayEdge> ways;
  std::string problem = walker.walk(settings_.route, line, ways);
  if (problem.empty()) walking_edge_ = walker.walkable(settings_.route, problem);
  if (!problem.empty()) return SettingProblem{"route", std::move(problem)};
  if (walking_edge_.empty()) {
    return SettingProblem{"net", "no edge of the route lets pedestrians onto it",
                          "netconvert --sidewalks.guess makes pavements"};
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
  if (frame_.length_m() >= needed_m) return std::nullopt;
  return SettingProblem{
      "route", fmt::format("the route is {:.1f} m long, the scenario's road ends at {:.1f} m of it",
                           frame_.length_m(), needed_m)};
}

}  // namespace jaywalk

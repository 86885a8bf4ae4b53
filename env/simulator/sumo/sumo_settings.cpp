// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/sumo/sumo_settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "env/simulator/simulator.h"

namespace jaywalk {
namespace {

constexpr std::string_view kModels =
    "constant Krauss KraussOrig1 PWagner2009 BKerner IDM EIDM IDMM Wiedemann W99 ACC CACC";

constexpr std::array kSumoKeys{
    SettingKey{.name = "model",
               .kind = SettingKind::choice,
               .meaning = "the AV's car-following model; `constant` never brakes",
               .words = kModels},
    SettingKey{.name = "accel",
               .kind = SettingKind::number,
               .meaning = "m/s² of its acceleration, `world.av.acceleration` if not given",
               .least = 0.01,
               .most = 100},
    SettingKey{.name = "decel",
               .kind = SettingKind::number,
               .meaning = "m/s² of its usual braking, 4.5 if not given",
               .least = 0.01,
               .most = 100},
    SettingKey{.name = "emergencyDecel",
               .kind = SettingKind::number,
               .meaning = "m/s² of its hardest braking, `world.av.deceleration` or 9 if not given",
               .least = 0.01,
               .most = 100},
    SettingKey{.name = "minGap",
               .kind = SettingKind::number,
               .meaning = "m that it leaves to whom it stops for, 2.5 if not given",
               .least = 0,
               .most = 1000},
    SettingKey{.name = "tau",
               .kind = SettingKind::number,
               .meaning = "s of the headway that it keeps, 1 if not given",
               .least = 0.01,
               .most = 100},
    SettingKey{.name = "sigma",
               .kind = SettingKind::number,
               .meaning = "how imperfectly it drives, 0 if not given",
               .least = 0,
               .most = 1},
    SettingKey{.name = "brakes_for_pedestrians",
               .kind = SettingKind::flag,
               .meaning = "`false`: pedestrians are left out of SUMO, so nobody brakes for them"},
    SettingKey{.name = "traffic", .kind = SettingKind::list, .meaning = "flows of other vehicles"},
    SettingKey{.name = "net",
               .kind = SettingKind::file,
               .meaning = "a map: a network of SUMO's (.net.xml), its nodes and edges (.xml), "
                          "OpenStreetMap's (.osm) or OpenDRIVE's (.xodr)"},
    SettingKey{.name = "route",
               .kind = SettingKind::text,
               .meaning = "the edges of the map that the AV drives along, separated by blanks"},
    SettingKey{.name = "begin",
               .kind = SettingKind::number,
               .meaning = "m of the route before the road of the scenario begins",
               .least = 0,
               .most = 1e6},
};

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream words{text};
  return {std::istream_iterator<std::string>(words), {}};
}

std::optional<double> number_of(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// A key of a flow: where its number goes, and its range.
struct FlowNumber {
  std::string_view name;
  double least = 0;
  double most = 0;
  void (*put)(double value, SumoFlow& flow);
};

constexpr std::array kFlowNumbers{
    FlowNumber{"lane", 1, 50, [](double v, SumoFlow& flow) { flow.lane = static_cast<int>(v); }},
    FlowNumber{"every", 0.5, 3600, [](double v, SumoFlow& flow) { flow.every_s = v; }},
    FlowNumber{"speed", 0.1, 100, [](double v, SumoFlow& flow) { flow.speed_mps = v; }},
    FlowNumber{"length", 0.1, 100, [](double v, SumoFlow& flow) { flow.length_m = v; }},
    FlowNumber{"width", 0.1, 10, [](double v, SumoFlow& flow) { flow.width_m = v; }},
    FlowNumber{"accel", 0.01, 100, [](double v, SumoFlow& flow) { flow.model.accel_mps2 = v; }},
    FlowNumber{"decel", 0.01, 100, [](double v, SumoFlow& flow) { flow.model.decel_mps2 = v; }},
    FlowNumber{"emergencyDecel", 0.01, 100,
               [](double v, SumoFlow& flow) { flow.model.emergency_decel_mps2 = v; }},
    FlowNumber{"minGap", 0, 1000, [](double v, SumoFlow& flow) { flow.model.min_gap_m = v; }},
    FlowNumber{"tau", 0.01, 100, [](double v, SumoFlow& flow) { flow.model.tau_s = v; }},
    FlowNumber{"sigma", 0, 1, [](double v, SumoFlow& flow) { flow.model.sigma = v; }},
};

bool is_model(const std::string& name) {
  const std::vector<std::string> names = words_of(std::string(kModels));
  return std::ranges::find(names, name) != names.end();
}

/// Stores one value in a flow. Returns an error about the value, and empty text if it is valid.
std::string read_flow_key(const std::string& key, const std::string& value, SumoFlow& flow) {
  if (key == "route") {
    flow.route = words_of(value);
    return flow.route.empty() ? "the route of a flow has no edges" : "";
  }
  if (key == "model") {
    flow.model.name = value;
    return is_model(value) ? "" : fmt::format("unknown model '{}' of a flow", value);
  }
  const auto row = std::ranges::find(kFlowNumbers, key, &FlowNumber::name);
  if (row == kFlowNumbers.end()) return fmt::format("unknown key '{}' of a flow", key);
  const std::optional<double> number = number_of(value);
  if (!number || !(*number >= row->least && *number <= row->most)) {
    return fmt::format("'{}' of a flow is a number from {:g} to {:g}", key, row->least, row->most);
  }
  row->put(*number, flow);
  return {};
}

std::string flow_hint() {
  std::string hint = "a flow has the keys route, model";
  for (const FlowNumber& each : kFlowNumbers) hint += fmt::format(", {}", each.name);
  return hint;
}

SumoFlow flow_of(const std::map<std::string, std::string>& values,
                 std::vector<SettingProblem>& problems) {
  SumoFlow flow;
  for (const auto& [key, value] : values) {
    std::string problem = read_flow_key(key, value, flow);
    if (!problem.empty()) problems.push_back({"traffic", std::move(problem), flow_hint()});
  }
  return flow;
}

std::optional<double> given(const SimulatorParameters& parameters, std::string_view key) {
  const SettingValue* const value = parameters.find(key);
  if (value == nullptr) return std::nullopt;
  return value->number;
}

/// Between which sides the AV or a flow's vehicles drive on the network that is made from bands.
struct DrivenStrip {
  double left_m = 0;
  double right_m = 0;
};

std::vector<RoadBand> lanes_of(const SimulatedRoad& road) {
  std::vector<RoadBand> lanes;
  std::ranges::copy_if(road.bands, std::back_inserter(lanes),
                       [](const RoadBand& band) { return band.kind == AreaKind::lane; });
  return lanes;
}

void check_flow_lane(const SumoFlow& flow, const std::vector<RoadBand>& lanes,
                     std::vector<DrivenStrip>& driven, std::vector<SettingProblem>& problems) {
  const auto number = static_cast<std::size_t>(std::max(flow.lane, 1));
  if (number > lanes.size()) {
    problems.push_back({"traffic", fmt::format("a flow has lane {}, but there are only {}", number,
                                               lanes.size())});
    return;
  }
  const double middle = (lanes[number - 1].left_m + lanes[number - 1].right_m) / 2;
  driven.push_back({middle - flow.width_m / 2, middle + flow.width_m / 2});
}

void check_bands(const SumoSettings& settings, const SimulatedSite& site,
                 std::vector<SettingProblem>& problems) {
  if (site.road.bands.empty()) {
    problems.push_back({"map", "SUMO's network is made from bands, and a drawn ground has none",
                        "give the world bands, or SUMO a map (world.simulator.net)", true});
    return;
  }
  const std::vector<RoadBand> lanes = lanes_of(site.road);
  const double middle = site.av_start.x_m;
  const double half = site.av.width_m / 2;
  if (std::ranges::none_of(lanes, [&](const RoadBand& lane) {
        return !lane.oncoming && lane.left_m <= middle && middle <= lane.right_m;
      })) {
    problems.push_back({"av.rows", "SUMO's AV drives in a lane that leads forward", {}, true});
  }
  std::vector<DrivenStrip> driven{{middle - half, middle + half}};
  for (const SumoFlow& flow : settings.traffic) check_flow_lane(flow, lanes, driven, problems);
  for (const Rectangle& obstacle : site.road.ground.obstacles) {
    if (std::ranges::none_of(driven, [&](const DrivenStrip& strip) {
          return strip.left_m < obstacle.right && obstacle.left < strip.right_m;
        })) {
      continue;
    }
    problems.push_back(
        {"obstacles",
         fmt::format("SUMO's vehicles would drive through the obstacle at {:g} m", obstacle.near),
         "obstacles beside where vehicles drive hide pedestrians from the AV", true});
  }
}

void check_site(const SumoSettings& settings, const SimulatedSite& site,
                std::vector<SettingProblem>& problems) {
  if (sumo_steps(site.tick_s, settings.step_s) == 0) {
    problems.push_back(
        {"tick", "SUMO's steps are whole milliseconds, so a tick has to be", {}, true});
  }
  if (settings.net.empty()) return check_bands(settings, site, problems);
  if (std::ranges::any_of(site.road.ground.crosswalks,
                          [](const GroundCrosswalk& each) { return !each.zebra; })) {
    problems.push_back({"crosswalks", "on a given map SUMO's vehicles see the map's signals alone",
                        "leave signalled crosswalks out, or let the network be made from bands",
                        true});
  }
}

}  // namespace

int sumo_steps(double tick_s, double step_s) {
  const auto tick_ms = std::lround(tick_s * 1000);
  if (tick_ms < 1 || std::fabs(tick_s * 1000 - static_cast<double>(tick_ms)) > 1e-6) return 0;
  int steps = steps_of(tick_s, step_s);
  while (tick_ms % steps != 0) ++steps;
  return steps;
}

std::span<const SettingKey> sumo_keys() { return kSumoKeys; }

std::vector<SettingProblem> check_sumo(const SimulatorParameters& parameters,
                                       const SimulatedSite* site) {
  std::vector<SettingProblem> problems;
  const bool has_net = parameters.find("net") != nullptr;
  for (const std::string_view key : {"route", "begin"}) {
    if (!has_net && parameters.find(key) != nullptr) {
      problems.push_back({std::string(key), fmt::format("'{}' is of a map, 'net'", key)});
    }
  }
  if (has_net && words_of(parameters.text("route")).empty()) {
    problems.push_back(
        {"net", "a map needs the AV's route through it", "name its edges: route: first second"});
  }
  if (parameters.step_s < 0.001) {
    problems.push_back({"step", "SUMO's steps are a millisecond at least"});
  }
  if (const SettingValue* const traffic = parameters.find("traffic")) {
    for (const auto& each : traffic->maps) {
      const SumoFlow flow = flow_of(each, problems);
      if (has_net && flow.route.empty()) {
        problems.push_back({"traffic", "on a map a flow needs a route"});
      }
      if (!has_net && !flow.route.empty()) {
        problems.push_back({"traffic", "a flow's route is of a map, 'net'; give its lane"});
      }
    }
  }
  if (problems.empty() && site != nullptr) check_site(sumo_settings(parameters), *site, problems);
  return problems;
}

SumoSettings sumo_settings(const SimulatorParameters& parameters) {
  SumoSettings settings;
  settings.av.name = parameters.text("model", settings.av.name);
  settings.av.accel_mps2 = parameters.number("accel", -1);
  settings.av.decel_mps2 = given(parameters, "decel");
  settings.av.emergency_decel_mps2 = given(parameters, "emergencyDecel");
  settings.av.min_gap_m = parameters.number("minGap", settings.av.min_gap_m);
  settings.av.tau_s = parameters.number("tau", settings.av.tau_s);
  settings.av.sigma = parameters.number("sigma", settings.av.sigma);
  settings.brakes_for_pedestrians = parameters.number("brakes_for_pedestrians", 1) != 0;
  settings.step_s = parameters.step_s;
  settings.net = parameters.text("net");
  settings.route = words_of(parameters.text("route"));
  settings.begin_m = parameters.number("begin", 0);
  std::vector<SettingProblem> none;
  if (const SettingValue* const traffic = parameters.find("traffic")) {
    for (const auto& each : traffic->maps) settings.traffic.push_back(flow_of(each, none));
  }
  return settings;
}

}  // namespace jaywalk

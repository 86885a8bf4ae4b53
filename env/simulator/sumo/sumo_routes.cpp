// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/sumo/sumo_routes.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/support/random.h"

namespace jaywalk {
namespace {

// Number of the traffic's seed among those derived from a test's seed; the test's own count from 0.
constexpr std::uint64_t kTrafficSeed = 0x73756d6f;
// Vehicles come for that long after the begin of a test.
constexpr double kComingS = 60;
// No vehicle begins closer than this before or behind the AV in its lane.
constexpr double kFreeBehindM = 10;
constexpr double kFreeAheadM = 15;
constexpr std::size_t kMostVehicles = 500;
// SUMO inserts the vehicle without checking its surroundings: the world decides where bodies begin.
constexpr std::string_view kUnchecked = " insertionChecks=\"none\"";

/// Where the world's y of a way's place is.
double y_on(const SumoWay& way, double position_m) {
  return way.oncoming ? way.zero_m - position_m : position_m - way.zero_m;
}

bool too_near(const SimulatedTest& test, const SumoWay& way, const SumoWay& own,
              const SumoFlow& flow, double position_m) {
  if (way.edges != own.edges || way.lane != own.lane) return false;
  const double front_m = y_on(way, position_m);
  const double half_m = test.av.length_m / 2;
  return front_m > test.av_start.y_m - half_m - kFreeBehindM &&
         front_m - flow.length_m < test.av_start.y_m + half_m + kFreeAheadM;
}

class Drawing {
 public:
  Drawing(const SimulatedTest& test, const SumoSettings& settings, const SumoMap& map)
      : test_(test), settings_(settings), map_(map) {}

  std::vector<SumoTraffic> draw() {
    for (std::size_t flow = 0; flow < settings_.traffic.size(); ++flow) draw(flow);
    return std::move(drawn_);
  }

 private:
  void draw(std::size_t number) {
    const SumoFlow& flow = settings_.traffic[number];
    const SumoWay& way = map_.flow_way(number);
    SplitMix64 random(mix(mix(mix(test_.seed, test_.test), kTrafficSeed), number));
    // From one to the next half to one and a half of the average.
    const auto gap = [&] { return flow.every_s * (0.5 + random.share()); };
    // Seconds since they entered; the network's begin is as far as its end.
    const double first_s = flow.every_s * random.share();
    for (double since_s = first_s; since_s * flow.speed_mps + flow.length_m < way.length_m;
         since_s += gap()) {
      const double position_m = since_s * flow.speed_mps + flow.length_m;
      if (!too_near(test_, way, map_.av_way(), flow, position_m)) add(number, 0, position_m);
    }
    for (double in_s = gap() - first_s; in_s < kComingS; in_s += gap()) {
      add(number, std::max(in_s, 0.0), flow.length_m);
    }
  }

  void add(std::size_t flow, double depart_s, double position_m) {
    if (drawn_.size() >= kMostVehicles) return;
    drawn_.push_back({fmt::format("traffic{}", drawn_.size() + 1), flow,
                      std::round(depart_s * 1000) / 1000, position_m});
  }

  const SimulatedTest& test_;
  const SumoSettings& settings_;
  const SumoMap& map_;
  std::vector<SumoTraffic> drawn_;
};

std::string vehicle_type(const std::string& id, const SumoModel& model, double length_m,
                         double width_m, double speed_mps) {
  const double emergency =
      model.emergency_decel_mps2.value_or(std::max(9.0, model.decel_mps2.value_or(0)));
  const double decel = model.decel_mps2.value_or(std::min(4.5, emergency));
  // `constant` is done by commands; the model under it is not used.
  const bool constant = model.name == "constant";
  return fmt::format(
      "<vType id=\"{}\" carFollowModel=\"{}\" accel=\"{:.9g}\" decel=\"{:.9g}\" "
      "emergencyDecel=\"{:.9g}\" minGap=\"{:.9g}\" tau=\"{:.9g}\" sigma=\"{:.9g}\" "
      "length=\"{:.9g}\" width=\"{:.9g}\" maxSpeed=\"{:.9g}\" speedFactor=\"1\" "
      "speedDev=\"0\"/>\n",
      id, constant ? "Krauss" : model.name, model.accel_mps2 > 0 ? model.accel_mps2 : 2, decel,
      std::max(emergency, decel), model.min_gap_m, model.tau_s, model.sigma, length_m, width_m,
      speed_mps);
}

/// The AV by its model, with the limits that the scenario gives it elsewhere.
SumoModel av_model(const SimulatedTest& test, SumoModel model) {
  if (model.accel_mps2 <= 0) model.accel_mps2 = test.vehicle.acceleration_mps2;
  if (!model.emergency_decel_mps2) model.emergency_decel_mps2 = test.vehicle.deceleration_mps2;
  if (model.decel_mps2 && !model.emergency_decel_mps2) {
    model.emergency_decel_mps2 = std::max(9.0, *model.decel_mps2);
  }
  return model;
}

std::string vehicle(std::string_view id, std::string_view type, const SumoWay& way, double depart_s,
                    double position_m, double speed_mps, std::string_view more) {
  const WayPlace place = place_on(way, position_m);
  return fmt::format(
      "<vehicle id=\"{}\" type=\"{}\" depart=\"{:.3f}\" departLane=\"{}\" departPos=\"{:.9g}\" "
      "departSpeed=\"{:.9g}\"{}><route edges=\"{}\"/></vehicle>\n",
      id, type, depart_s, way.lane == kBestLane ? "best" : std::to_string(way.lane), place.along_m,
      speed_mps, more, fmt::join(std::span(way.edges).subspan(place.edge), " "));
}

}  // namespace

std::string sumo_body(std::size_t actor) { return fmt::format("b{}", actor); }

bool is_body(const Actor& actor, const SumoSettings& settings) {
  if (actor.kind == ActorKind::signal) return false;
  return actor.kind != ActorKind::pedestrian || settings.brakes_for_pedestrians;
}

std::vector<SumoTraffic> draw_traffic(const SimulatedTest& test, const SumoSettings& settings,
                                      const SumoMap& map) {
  return Drawing(test, settings, map).draw();
}

std::string sumo_routes(const SimulatedTest& test, const SumoSettings& settings, const SumoMap& map,
                        const std::vector<SumoTraffic>& traffic, const std::string& token) {
  std::string text = fmt::format("<routes>\n<vType id=\"{}\"/>\n", token);
  text += vehicle_type(std::string(kSumoAv), av_model(test, settings.av), test.av.length_m,
                       test.av.width_m, test.cruise_mps);
  for (std::size_t i = 0; i < settings.traffic.size(); ++i) {
    const SumoFlow& flow = settings.traffic[i];
    text += vehicle_type(fmt::format("flow{}", i), flow.model, flow.length_m, flow.width_m,
                         flow.speed_mps);
  }
  const SumoWay& way = map.av_way();
  // It keeps its place in the lane; on a given map the lane's middle is that place.
  const double to_left_m = settings.net.empty() ? way.middle_x_m - test.av_start.x_m : 0;
  text +=
      vehicle(kSumoAv, kSumoAv, way, 0, way.zero_m + test.av_start.y_m + test.av.length_m / 2,
              test.cruise_mps, fmt::format("{} departPosLat=\"{:.9g}\"", kUnchecked, to_left_m));
  for (std::size_t i = 0; i < test.actors.size(); ++i) {
    const Actor& actor = test.actors[i];
    if (!is_body(actor, settings)) continue;
    if (actor.kind == ActorKind::pedestrian) {
      text += fmt::format("<person id=\"{}\" depart=\"0\"><walk edges=\"{}\"/></person>\n",
                          sumo_body(i), map.walking_edge());
      continue;
    }
    text += fmt::format("<vType id=\"type{}\" length=\"{:.9g}\" width=\"{:.9g}\"/>\n", i,
                        actor.length_m, actor.width_m);
    text += vehicle(sumo_body(i), fmt::format("type{}", i), way, 0, actor.length_m, 0, kUnchecked);
  }
  // SUMO reads departures in the order of time.
  std::vector<const SumoTraffic*> departures;
  for (const SumoTraffic& each : traffic) departures.push_back(&each);
  std::ranges::stable_sort(departures, {}, &SumoTraffic::depart_s);
  for (const SumoTraffic* each : departures) {
    text += vehicle(each->name, fmt::format("flow{}", each->flow), map.flow_way(each->flow),
                    each->depart_s, each->position_m, settings.traffic[each->flow].speed_mps,
                    each->depart_s == 0 ? kUnchecked : "");
  }
  return text + "</routes>\n";
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// SUMO as a simulator: it moves the AV and the traffic, on a map of its own. Pedestrians are put
// where they are in every step, in a walking stage and wherever they like (keepRoute 6), which is
// what makes SUMO's vehicles brake for them. A vehicle's position is the middle of its front
// bumper, an angle counts clockwise from north. The lights of the network show in each tick what
// the world's signals show.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "env/simulator/simulator.h"
#include "env/simulator/sumo/sumo_map.h"
#include "env/simulator/sumo/sumo_process.h"
#include "env/simulator/sumo/sumo_routes.h"
#include "env/simulator/sumo/sumo_settings.h"
#include "env/vehicle/sight.h"
#include "interpreter/support/random.h"

namespace jaywalk {
namespace {

// moveToXY to any place (2), whatever the lanes there permit (4).
constexpr std::int8_t kAnywhere = 6;
// The lane that moveToXY is to prefer: none.
constexpr int kNoLane = -1;
// Vehicles further away than this are out of the simulation.
constexpr double kFarM = 1e5;
// Where bodies that are hidden from the AV are put in SUMO, beside the road.
constexpr double kOutOfSightM = 1e5;
// How SUMO writes the colours of a light; `G` is green with priority.
constexpr char kGreenLamp = 'G';
constexpr char kAmberLamp = 'y';
constexpr char kRedLamp = 'r';
constexpr std::uint64_t kSumoSeed = 0x53554d4f;
constexpr std::array kOfVehicles{TraciVariable::position, TraciVariable::angle,
                                 TraciVariable::speed, TraciVariable::acceleration};

double degrees(double heading_rad) { return 90 - heading_rad * 180 / std::numbers::pi; }

double heading(double angle_degrees) {
  const double turned = std::numbers::pi / 2 - angle_degrees * std::numbers::pi / 180;
  return turned <= -std::numbers::pi ? turned + 2 * std::numbers::pi : turned;
}

/// Steps of a tenth of a metre a hundred times are ten metres: what addition loses is put right.
double to_micrometres(double metres) {
  constexpr double kMicrometres = 1e6;
  return std::round(metres * kMicrometres) / kMicrometres + 0.0;
}

class SumoSimulator final : public Simulator {
 public:
  explicit SumoSimulator(const SimulatorParameters& parameters)
      : settings_(sumo_settings(parameters)), map_(settings_) {}

  std::string identify(SimulatorIdentity& identity) override;
  std::vector<SettingProblem> survey(const SimulatedSite& site) override;
  std::string begin(const SimulatedTest& test, SimulatedStart& start) override;
  std::string advance(const SimulatedTick& tick, std::vector<SimulatedScene>& scenes) override;

 private:
  [[nodiscard]] std::vector<std::string> options(const SimulatedTest& test) const;
  [[nodiscard]] std::vector<SettingProblem> make_ready(const SimulatedTest& test);
  [[nodiscard]] std::string write_routes(const SimulatedTest& test);
  [[nodiscard]] TraciMessage first_message(const SimulatedTest& test) const;
  [[nodiscard]] bool is_hidden(const ActorState& state) const;
  void move(const SimulatedBody& body, double share, TraciMessage& message) const;
  void show(std::span<const ShownSignal> signals, TraciMessage& message) const;
  [[nodiscard]] TraciMessage step_message(const SimulatedTick& tick, int step) const;
  [[nodiscard]] SimulatedScene scene_of(const TraciAnswer& answer) const;
  [[nodiscard]] SimulatedVehicle vehicle_of(const TraciObject& object, double length_m) const;
  [[nodiscard]] std::string ask(const TraciMessage& message, TraciAnswer& answer);

  SumoSettings settings_;
  SumoMap map_;
  MemoryFile routes_;
  SumoProcess sumo_;
  std::string token_;
  std::vector<SumoTraffic> traffic_;
  std::map<std::string, std::size_t, std::less<>> numbers_;  // of the traffic, by name
  std::vector<Actor> actors_;
  double av_length_m_ = 0;
  std::vector<Rectangle> obstacles_;
  ActorState av_;  // now
  int steps_ = 1;
};

std::string SumoSimulator::ask(const TraciMessage& message, TraciAnswer& answer) {
  answer = sumo_.ask(message);
  return answer.error.empty() ? "" : "SUMO: " + answer.error;
}

std::string SumoSimulator::identify(SimulatorIdentity& identity) {
  identity.name = "SUMO";
  identity.network = settings_.net.empty() ? "made from the bands by netconvert" : settings_.net;
  return sumo_version(identity.version);
}

std::vector<std::string> SumoSimulator::options(const SimulatedTest& test) const {
  const auto seed = mix(mix(mix(test.seed, test.test), kSumoSeed), 0) >> 33U;
  return {"--net-file",
          map_.path(),
          "--route-files",
          routes_.path(),
          "--step-length",
          fmt::format("{:.3f}", test.tick_s / steps_),
          "--seed",
          fmt::format("{}", seed),
          "--no-step-log",
          "true",
          "--no-warnings",
          "true",
          "--collision.action",
          "none",
          "--time-to-teleport",
          "-1"};
}

std::string SumoSimulator::write_routes(const SimulatedTest& test) {
  traffic_ = draw_traffic(test, settings_, map_);
  numbers_.clear();
  for (std::size_t i = 0; i < traffic_.size(); ++i) numbers_[traffic_[i].name] = i;
  const std::string text = sumo_routes(test, settings_, map_, traffic_, token_);
  return routes_.write(text) ? "" : "there is no memory for SUMO's routes";
}

/// Has the network made, SUMO started on it and the AV's way found, unless that was done before.
std::vector<SettingProblem> SumoSimulator::make_ready(const SimulatedTest& test) {
  const std::string net = settings_.net.empty() ? "" : "net";
  bool changed = false;
  std::string problem = map_.prepare(test, changed);
  if (!problem.empty()) return {{net, std::move(problem)}};
  if (changed) sumo_.end();
  if (sumo_.is_running()) return {};
  // The path names our process and this object, so that the token is unique.
  token_ = routes_.path();
  if (!routes_.write(fmt::format("<routes><vType id=\"{}\"/></routes>\n", token_))) {
    return {{net, "there is no memory for SUMO's routes"}};
  }
  problem = sumo_.start(options(test), token_);
  if (!problem.empty()) return {{net, std::move(problem)}};
  return map_.survey(test, sumo_);
}

std::vector<SettingProblem> SumoSimulator::survey(const SimulatedSite& site) {
  // A network that is made from bands is as the scenario wants it.
  if (settings_.net.empty()) return {};
  const SimulatedTest test{.test = 0,
                           .seed = 0,
                           .behaviour = {},
                           .agents = 0,
                           .tick_s = site.tick_s,
                           .road = site.road,
                           .av = site.av,
                           .av_start = site.av_start,
                           .cruise_mps = site.av_start.speed_mps,
                           .vehicle = site.vehicle,
                           .actors = {},
                           .starts = {}};
  return make_ready(test);
}

TraciMessage SumoSimulator::first_message(const SimulatedTest& test) const {
  TraciMessage message;
  message.subscribe(TraciCommand::vehicle_subscribe, kSumoAv, kOfVehicles);
  if (!traffic_.empty()) message.subscribe_around(kSumoAv, kFarM, kOfVehicles);
  if (settings_.av.name == "constant") {
    message.set(TraciCommand::vehicle_set, TraciVariable::speed_mode, kSumoAv, traci_integer(0));
    message.set(TraciCommand::vehicle_set, TraciVariable::speed, kSumoAv,
                traci_real(test.cruise_mps));
  }
  return message;
}

std::string SumoSimulator::begin(const SimulatedTest& test, SimulatedStart& start) {
  steps_ = sumo_steps(test.tick_s, settings_.step_s);
  if (auto problems = make_ready(test); !problems.empty()) return problems.front().message;
  std::string problem = write_routes(test);
  if (!problem.empty()) return problem;
  actors_.assign(test.actors.begin(), test.actors.end());
  obstacles_ = test.road.ground.obstacles;
  av_length_m_ = test.av.length_m;
  TraciMessage load;
  load.load(options(test));
  // The vehicles are let in, and stand where they depart.
  TraciMessage step;
  show({}, step);
  step.step();
  TraciAnswer answer;
  for (const TraciMessage& message : {load, step, first_message(test)}) {
    if (problem = ask(message, answer); !problem.empty()) return problem;
  }
  start.traffic.clear();
  for (const SumoTraffic& each : traffic_) {
    const SumoFlow& flow = settings_.traffic[each.flow];
    start.traffic.push_back({each.name, ActorKind::vehicle, flow.length_m, flow.width_m});
  }
  start.scene = scene_of(answer);
  av_ = start.scene.av.state;
  return start.scene.av.present ? "" : "SUMO has not let the AV in";
}

/// From the middle of the AV's front; SUMO's vehicles look through everything.
bool SumoSimulator::is_hidden(const ActorState& state) const {
  const Point eye{av_.x_m, av_.y_m + av_length_m_ / 2};
  return std::ranges::any_of(obstacles_, [&](const Rectangle& each) {
    return stands_between(each, eye, {state.x_m, state.y_m});
  });
}

void SumoSimulator::move(const SimulatedBody& body, double share, TraciMessage& message) const {
  const Actor& actor = actors_[body.actor];
  if (!is_body(actor, settings_)) return;
  const ActorState state = body_at(body, share);
  RoadFrame::Pose pose = map_.frame().to_map({state.x_m, state.y_m, state.heading_rad});
  if (actor.kind == ActorKind::pedestrian && is_hidden(state)) pose.x_m += kOutOfSightM;
  const std::string name = sumo_body(body.actor);
  if (actor.kind == ActorKind::pedestrian) {
    return message.set(
        TraciCommand::person_set, TraciVariable::move_to_xy, name,
        traci_compound({traci_text({}), traci_real(pose.x_m), traci_real(pose.y_m),
                        traci_real(degrees(pose.heading_rad)), traci_byte(kAnywhere)}));
  }
  pose.x_m += std::cos(pose.heading_rad) * actor.length_m / 2;
  pose.y_m += std::sin(pose.heading_rad) * actor.length_m / 2;
  message.set(TraciCommand::vehicle_set, TraciVariable::move_to_xy, name,
              traci_compound({traci_text({}), traci_integer(kNoLane), traci_real(pose.x_m),
                              traci_real(pose.y_m), traci_real(degrees(pose.heading_rad)),
                              traci_byte(kAnywhere)}));
}

/// Each light shows the most severe of its crosswalks' colours; green if `signals` has none.
void SumoSimulator::show(std::span<const ShownSignal> signals, TraciMessage& message) const {
  for (const SumoLight& light : map_.lights()) {
    char lamp = kGreenLamp;
    for (const ShownSignal& each : signals) {
      if (std::ranges::find(light.crosswalks, each.crosswalk) == light.crosswalks.end()) continue;
      if (each.colour == "red") lamp = kRedLamp;
      if (each.colour == "amber" && lamp != kRedLamp) lamp = kAmberLamp;
    }
    message.set(TraciCommand::traffic_light_set, TraciVariable::lamps, light.name,
                traci_text(std::string(light.lanes, lamp)));
  }
}

TraciMessage SumoSimulator::step_message(const SimulatedTick& tick, int step) const {
  TraciMessage message;
  const double share = static_cast<double>(step) / steps_;
  if (step == 1) show(tick.signals, message);
  for (const SimulatedBody& body : tick.bodies) move(body, share, message);
  message.step();
  return message;
}

std::string SumoSimulator::advance(const SimulatedTick& tick, std::vector<SimulatedScene>& scenes) {
  scenes.clear();
  if (!sumo_.is_running()) return "SUMO is not running";
  // All positions of the tick are known beforehand, so that all steps are sent at once. With
  // obstacles, whether a body is hidden depends on where the AV is at each step.
  const int at_once = obstacles_.empty() ? steps_ : 1;
  for (int step = 0; step < steps_;) {
    std::vector<TraciMessage> messages;
    for (int i = 1; i <= at_once; ++i) messages.push_back(step_message(tick, step + i));
    for (const TraciAnswer& answer : sumo_.ask(messages)) {
      if (!answer.error.empty()) return "SUMO: " + answer.error;
      ++step;
      scenes.push_back(scene_of(answer));
      scenes.back().time_s = tick.begin_s + static_cast<double>(step) / steps_ * tick.length_s;
      av_ = scenes.back().av.state;
    }
  }
  return {};
}

SimulatedVehicle SumoSimulator::vehicle_of(const TraciObject& object, double length_m) const {
  const TraciValue* const place = object.find(TraciVariable::position, TraciType::position_2d);
  const TraciValue* const angle = object.find(TraciVariable::angle, TraciType::real);
  const TraciValue* const speed = object.find(TraciVariable::speed, TraciType::real);
  const TraciValue* const acceleration = object.find(TraciVariable::acceleration, TraciType::real);
  SimulatedVehicle vehicle{.state = {}, .present = false};
  if (place == nullptr || angle == nullptr || speed == nullptr) return vehicle;
  const double way = heading(angle->number);
  // The middle of the body on the map, then in the world.
  const RoadFrame::Pose pose =
      map_.frame().to_world({place->points.front().x_m - std::cos(way) * length_m / 2,
                             place->points.front().y_m - std::sin(way) * length_m / 2, way});
  vehicle.state = {.x_m = to_micrometres(pose.x_m),
                   .y_m = to_micrometres(pose.y_m),
                   .speed_mps = to_micrometres(std::max(speed->number, 0.0)),
                   .heading_rad = pose.heading_rad};
  if (acceleration != nullptr) vehicle.acceleration_mps2 = to_micrometres(acceleration->number);
  // Vehicles that have not come yet, or have left, have meaningless places.
  vehicle.present = std::fabs(pose.x_m) < kFarM * 10 && std::fabs(pose.y_m) < kFarM * 10;
  return vehicle;
}

SimulatedScene SumoSimulator::scene_of(const TraciAnswer& answer) const {
  SimulatedScene scene{.av = {.state = {}, .present = false}, .traffic = {}, .contacts = {}};
  scene.traffic.resize(traffic_.size(), {.state = {}, .present = false});
  for (const TraciObject& object : answer.objects) {
    if (object.id == kSumoAv) {
      if (!scene.av.present) scene.av = vehicle_of(object, av_length_m_);
      continue;
    }
    const auto number = numbers_.find(object.id);
    if (number == numbers_.end()) continue;
    const SumoFlow& flow = settings_.traffic[traffic_[number->second].flow];
    scene.traffic[number->second] = vehicle_of(object, flow.length_m);
  }
  return scene;
}

}  // namespace

std::unique_ptr<Simulator> make_sumo(const SimulatorParameters& parameters) {
  return std::make_unique<SumoSimulator>(parameters);
}

}  // namespace jaywalk

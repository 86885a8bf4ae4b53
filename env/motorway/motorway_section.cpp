// SPDX-License-Identifier: Apache-2.0
// The key `world` of a scenario on the motorway.

#include <fmt/format.h>

#include "env/config/reader.h"
#include "env/motorway/parameters.h"
#include "env/motorway/world.h"
#include "env/vehicle/vehicle_section.h"

namespace jaywalk {
namespace {

constexpr IntegerRange kLanes{1, 20};
constexpr NumberRange kLaneMetres{2, 10};
constexpr NumberRange kRoadMetres{50, 100'000};
constexpr NumberRange kTicks{0.05, 10};
constexpr NumberRange kBodyMetres{1, 30};
constexpr NumberRange kMps{0.1, 100};
constexpr NumberRange kMps2{0.1, 20};
constexpr NumberRange kChange{0.2, 20};
constexpr NumberRange kMetresAround{-10'000, 10'000};
constexpr NumberRange kHeadway{0.1, 10};
constexpr IntegerRange kAftermathTicks{0, 1000};
constexpr NumberRange kPoints{0, 1e9};
constexpr NumberRange kLimit{1, 86'400};

class MotorwayReader : VehicleSection {
 public:
  MotorwayReader(const SectionContext& context, MotorwayParameters& world)
      : VehicleSection(context), world_(world) {}

  void read(const ConfigNode& node, const std::string& path, std::span<const ConfigKey> common) {
    std::vector<ConfigKey> keys(common.begin(), common.end());
    keys.insert(
        keys.end(),
        {{"lanes", integer(world_.lanes, kLanes)},
         {"lane_width", number(world_.lane_m, kLaneMetres)},
         {"length", number(world_.length_m, kRoadMetres)},
         {"tick", number(world_.tick_s, kTicks)},
         {"av", [this](const ConfigNode& value, const std::string& key) { read_av(value, key); }},
         {"drivers",
          [this](const ConfigNode& value, const std::string& key) { read_drivers(value, key); }},
         {"headway", number(world_.headway_s, kHeadway)},
         {"aftermath", integer(world_.aftermath, kAftermathTicks)},
         {"time_limit", number(world_.time_limit_s, kLimit)},
         {"scoring", [this](const ConfigNode& value, const std::string& key) {
            read_keys(value, key,
                      {{"cost", number(world_.cost, kPoints)},
                       {"reward", number(world_.reward, kPoints)}});
          }}});
    read_keys(node, path, keys);
  }

 private:
  void read_av(const ConfigNode& node, const std::string& path) {
    MotorwayParameters::AutomatedVehicle& av = world_.av;
    std::vector<ConfigKey> keys{{"lane", integer(av.lane, kLanes)},
                                {"start", number(av.start_m, kRoadMetres)},
                                {"speed", speed(av.speed_mps, kMps, "speed")},
                                {"length", number(av.length_m, kBodyMetres)},
                                {"width", number(av.width_m, kBodyMetres)}};
    add_keys(av.vehicle, av.twin, keys);
    read_keys(node, path, keys);
  }

  void read_drivers(const ConfigNode& node, const std::string& path) {
    MotorwayParameters::Drivers& drivers = world_.drivers;
    read_keys(node, path,
              {{"greatest_speed", speed(drivers.greatest_speed_mps, kMps, "greatest_speed")},
               {"acceleration", number(drivers.acceleration_mps2, kMps2)},
               {"braking", number(drivers.braking_mps2, kMps2)},
               {"lane_change", number(drivers.change_s, kChange)},
               {"sight", number(drivers.sight_m, {0, 1e6})},
               {"start", [&](const ConfigNode& value, const std::string& key) {
                  note_origin(value, key);
                  if (const auto range = reader_.number_pair(value, kMetresAround)) {
                    drivers.start_from_m = (*range)[0];
                    drivers.start_to_m = (*range)[1];
                  }
                }}});
  }

  MotorwayParameters& world_;
};

class MotorwaySection final : public WorldSection {
 public:
  void read(const ConfigNode& node, const std::string& path, const SectionContext& context,
            std::span<const ConfigKey> common) override {
    MotorwayReader(context, world_).read(node, path, common);
  }

  void check(const std::string& scenario, const SectionContext& context) override {
    warn_of_speed(world_.av.speed_mps, "world.av.speed", "it is in m/s", context);
    for (ParameterProblem& problem : problems(world_)) {
      report(context.diagnostics, origin_of(context.origins, problem.path, scenario),
             std::move(problem.message), fmt::format("the key is {}", problem.path));
    }
    check_vehicle(world_.av.vehicle, world_.av.twin, scenario, context);
  }

  std::vector<std::vector<std::string>*> commands() override {
    std::vector<std::vector<std::string>*> commands{&world_.av.vehicle.command};
    if (world_.av.twin) commands.push_back(&world_.av.twin->command);
    return commands;
  }

  std::vector<std::string> av_models() const override { return av_model_names({}); }

  std::shared_ptr<const WorldSpec> finish() const override {
    return std::make_shared<MotorwaySpec>(world_);
  }

 private:
  MotorwayParameters world_;
};

}  // namespace

std::unique_ptr<WorldSection> motorway_section() { return std::make_unique<MotorwaySection>(); }

std::vector<ParameterProblem> problems(const MotorwayParameters& parameters) {
  std::vector<ParameterProblem> found;
  if (parameters.av.lane > parameters.lanes) {
    found.push_back({"world.av.lane", fmt::format("the AV's lane {} is none of the {}",
                                                  parameters.av.lane, parameters.lanes)});
  }
  if (parameters.av.width_m > parameters.lane_m) {
    found.push_back({"world.av.width", fmt::format("an AV of {} m does not fit a lane of {} m",
                                                   parameters.av.width_m, parameters.lane_m)});
  }
  if (parameters.av.start_m >= parameters.length_m) {
    found.push_back({"world.av.start", fmt::format("the road of {} m ends before the AV's start",
                                                   parameters.length_m)});
  }
  if (parameters.drivers.greatest_speed_mps < parameters.av.speed_mps) {
    found.push_back({"world.drivers.greatest_speed",
                     "drivers begin at the AV's speed, which is greater than their greatest"});
  }
  check_defects(parameters.av.vehicle, parameters.av.twin, found);
  return found;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "search/suts/lane_keeping.h"

#include <array>

#include <fmt/format.h>

#include "search/suts/road_space.h"
#include "search/suts/suts.h"

namespace jaywalk::search {
namespace {

constexpr std::array kMeasures = {
    MeasureKind{"max_oob", "largest share of the car outside of its lane, 0 to 1"},
    MeasureKind{"min_oob_distance_m", "2 m less the largest distance from the lane's middle"},
    MeasureKind{"worst_arc_m", "where along the lane the largest share was outside"},
    MeasureKind{"max_lateral_error_m", "largest distance from the lane's middle"},
    MeasureKind{"max_heading_error_rad", "largest difference from the lane's heading"},
    MeasureKind{"max_lateral_acceleration", "in m/s2"},
    MeasureKind{"max_speed_mps", "in m/s"},
};

class Driver : public Sut {
 public:
  Driver(const RoadSpace& space, const lane::DriveSettings& settings)
      : space_(space), settings_(settings) {}

  Outcome run(const TestInput& input, std::size_t) override {
    const std::optional<lane::Road> road = lane::make_road(space_.road_points(input));
    if (!road) return {.error = "no road goes through these points"};
    const lane::DriveResult result = lane::drive(*road, settings_);
    return {.simulated_s = result.time_s,
            .measures = {result.max_out_of_bounds, result.min_oob_distance_m, result.worst_arc_m,
                         result.max_lateral_error_m, result.max_heading_error_rad,
                         result.max_lateral_acceleration, result.max_speed_mps}};
  }

 private:
  const RoadSpace& space_;
  const lane::DriveSettings& settings_;
};

const lane::ControllerKind* read_controller(const ConfigNode& node, const ConfigReader& reader) {
  std::vector<Choice<const lane::ControllerKind*>> choices;
  for (const lane::ControllerKind& kind : lane::controllers())
    choices.push_back({kind.name, &kind});
  return reader.choice<const lane::ControllerKind*>(node, choices).value_or(nullptr);
}

/// The keys of `vehicle`: each a number of VehicleParameters.
void read_vehicle(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                  lane::VehicleParameters& vehicle) {
  using Field = double lane::VehicleParameters::*;
  const std::array<std::pair<std::string_view, Field>, 16> fields{{
      {"length_m", &lane::VehicleParameters::length_m},
      {"width_m", &lane::VehicleParameters::width_m},
      {"mass_kg", &lane::VehicleParameters::mass_kg},
      {"inertia", &lane::VehicleParameters::inertia},
      {"front_axle_m", &lane::VehicleParameters::front_axle_m},
      {"rear_axle_m", &lane::VehicleParameters::rear_axle_m},
      {"height_m", &lane::VehicleParameters::height_m},
      {"longitudinal_friction", &lane::VehicleParameters::longitudinal_friction},
      {"lateral_friction", &lane::VehicleParameters::lateral_friction},
      {"tyre_shape", &lane::VehicleParameters::tyre_shape},
      {"tyre_stiffness", &lane::VehicleParameters::tyre_stiffness},
      {"tyre_curvature", &lane::VehicleParameters::tyre_curvature},
      {"most_steering_rad", &lane::VehicleParameters::most_steering_rad},
      {"brake_split", &lane::VehicleParameters::brake_split},
      {"most_acceleration", &lane::VehicleParameters::most_acceleration},
      {"switch_speed_mps", &lane::VehicleParameters::switch_speed_mps},
  }};
  std::vector<ConfigKey> keys;
  for (const auto& [name, field] : fields) {
    const bool may_be_negative = name == "tyre_curvature";
    const NumberRange range{may_be_negative ? -10 : 0.01, 1e6};
    keys.push_back({name, number_into(vehicle.*field, reader, range)});
  }
  reader.read_map(node, path, keys);
}

}  // namespace

std::span<const MeasureKind> LaneKeeping::measures() const { return kMeasures; }

std::vector<SutSetting> LaneKeeping::settings() const {
  std::string controller(drive_.controller->name);
  for (std::size_t i = 0; i < drive_.values.size(); ++i) {
    const NumberParameter& parameter = drive_.controller->parameters[i];
    if (drive_.values[i] == parameter.value) continue;
    controller += fmt::format(", {} {}", parameter.name, drive_.values[i]);
  }
  return {{"controller", std::move(controller)},
          {"speed limit", fmt::format("{:.6g} km/h", 3.6 * drive_.speed_limit_mps)},
          {"tolerance", fmt::format("a test ends once {:.6g} % of the car is out of its lane",
                                    100 * drive_.tolerance)},
          {"time limit", fmt::format("{:.6g} s", drive_.most_s)},
          road_setting(space_.settings())};
}

std::unique_ptr<Sut> LaneKeeping::make() const { return std::make_unique<Driver>(space_, drive_); }

namespace sut::lane_keeping {

std::shared_ptr<const SutModel> read(const SutSetup& setup) {
  const ConfigReader& reader = setup.reader;
  RoadSpaceSettings space;
  const lane::ControllerKind* controller = &lane::controllers().front();
  if (const ConfigNode* node = setup.node.find("controller")) {
    controller = read_controller(*node, reader);
    if (controller == nullptr) return nullptr;
  }
  lane::DriveSettings drive = lane::drive_settings(*controller);
  const std::vector<ConfigKey> keys{
      {"kind", [](const ConfigNode&, const std::string&) {}},
      {"name", [](const ConfigNode&, const std::string&) {}},
      {"controller", [](const ConfigNode&, const std::string&) {}},
      {"parameters",
       [&](const ConfigNode& value, const std::string& path) {
         reader.read_map(value, path, parameter_keys(controller->parameters, reader, drive.values));
       }},
      {"vehicle",
       [&](const ConfigNode& value, const std::string& path) {
         read_vehicle(value, path, reader, drive.vehicle);
       }},
      {"speed_limit_kmh", number_into(drive.speed_limit_mps, reader, {1, 1000}, 1 / 3.6)},
      {"tolerance", number_into(drive.tolerance, reader, {0, 1})},
      {"time_limit_s", number_into(drive.most_s, reader, {1, 3600})},
      {"roads", [&](const ConfigNode& value,
                    const std::string& path) { read_road_space(value, path, reader, space); }},
  };
  reader.read_map(setup.node, setup.path, keys);
  return std::make_shared<LaneKeeping>(space, std::move(drive));
}

}  // namespace sut::lane_keeping

}  // namespace jaywalk::search

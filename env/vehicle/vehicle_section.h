// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a scenario describes the automated vehicle (AV) of any world: the keys of `world.av` that say
// how it is driven. Read vehicle.h and env/config/section_reader.h first.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "env/config/reader.h"
#include "env/config/section_reader.h"
#include "env/simulator/parameters.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// Reads the keys; a world's own reader of its AV derives from it and adds keys to them.
class VehicleSection : protected SectionReader {
 public:
  explicit VehicleSection(const SectionContext& context) : SectionReader(context) {}

  /// `model`, `reaction`, …, `defect` and `twin`. The targets must outlive the reading.
  void add_keys(VehicleParameters& vehicle, std::optional<VehicleParameters>& twin,
                std::vector<ConfigKey>& keys);

 private:
  void read_model(const ConfigNode& node, const std::string& path, VehicleParameters& vehicle);
  void read_defects(const ConfigNode& node, const std::string& path, VehicleParameters& vehicle);
  void read_twin(const ConfigNode& node, const std::string& path,
                 std::optional<VehicleParameters>& twin);
  void read_twin_keys(const ConfigNode& node, const std::string& path, VehicleParameters& twin);
  void read_command(const ConfigNode& node, const std::string& path, VehicleParameters& vehicle);
};

/// Reports keys that have no meaning for an external controller, and commands that are missing.
void check_vehicle(const VehicleParameters& vehicle, const std::optional<VehicleParameters>& twin,
                   const std::string& scenario, const SectionContext& context);
/// Warns of an AV that drives at more than 60 m/s, where the key `path` was given; `unit` says what
/// that is in.
void warn_of_speed(double mps, const std::string& path, std::string unit,
                   const SectionContext& context);
/// Adds errors if defects cannot have an effect: a model that never brakes can neither brake
/// wrongly nor be the healthy twin.
void check_defects(const VehicleParameters& vehicle, const std::optional<VehicleParameters>& twin,
                   std::vector<ParameterProblem>& found);

/// The vehicle by which kills are measured: the named twin, else its own without defects. Its
/// sensors and its period are the vehicle's.
[[nodiscard]] VehicleParameters healthy_twin(const VehicleParameters& vehicle,
                                             const std::optional<VehicleParameters>& twin);

/// A defect of the AV, `latency` or `latency=0.6`; nothing after reporting an error.
[[nodiscard]] std::optional<VehicleDefect> read_defect(const ConfigNode& node,
                                                       const ConfigReader& reader);
/// `all`, which is every defect with each of its severities; or a list, or a text with commas.
[[nodiscard]] std::vector<VehicleDefect> read_defect_list(const ConfigNode& node,
                                                          const ConfigReader& reader);

/// Models of the AV, as a list or a text with commas. Whether they exist is known when the layers
/// are: av_model_names().
[[nodiscard]] std::vector<std::string> read_av_list(const ConfigNode& node,
                                                    const ConfigReader& reader);
/// The names of the models of the AV that the simulator has, or the world if there is no simulator;
/// none if the simulator has no such key.
[[nodiscard]] std::vector<std::string> av_model_names(const SimulatorParameters& simulator);

}  // namespace jaywalk

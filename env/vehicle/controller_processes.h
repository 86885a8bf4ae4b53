#pragma once

// Processes of external controllers (external.cpp describes the protocol). The runner of the tests
// keeps a process that drives in many tests, one after another, since starting it takes longer than
// most tests do; it belongs to one thread.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "env/process/numbered_process.h"
#include "env/vehicle/known_drives.h"
#include "env/vehicle/vehicle.h"
#include "env/vehicle/view_text.h"

namespace jaywalk {

/// Errors are texts for people, empty if all is well. After one the process is gone; the next drive
/// starts it anew.
class ControllerProcess {
 public:
  explicit ControllerProcess(const std::vector<std::string>& command);

  /// Begins a drive of a kept process. If it repeats the drive before, nothing is sent until a view
  /// comes that was not seen in that drive; then all earlier views are sent again.
  [[nodiscard]] std::string begin(nlohmann::json reset);
  /// Its answer: an acceleration in m/s^2, not yet limited to what a vehicle can do.
  [[nodiscard]] std::string decide(const VehicleView& view, std::uint64_t test,
                                   double& acceleration_mps2);
  [[nodiscard]] std::string end(nlohmann::json end);
  /// Like the functions of LineProcess.
  void finish() { process_.finish(); }
  [[nodiscard]] std::string take_errors() { return process_.take_errors(); }

 private:
  [[nodiscard]] std::string say_reset();
  [[nodiscard]] std::string catch_up();
  [[nodiscard]] std::string ask(const std::string& view, double& acceleration_mps2);
  [[nodiscard]] std::string read_acceleration(const JsonAnswer& answer, double& acceleration_mps2);
  [[nodiscard]] std::string read_fields(const nlohmann::json& answer);
  /// Resets the state of a process that has ended.
  [[nodiscard]] std::string failed(std::string why);

  NumberedProcess process_;
  nlohmann::json reset_;  // of the drive that it is in; null if it is not kept
  ViewFields fields_;     // those that it reads
  KnownDrives drives_;
  bool follows_ = false;  // all of this drive's views are known, and none has been sent
  std::size_t step_ = 0;
};

class ControllerProcesses {
 public:
  /// The one of that command, which is started when it is first asked.
  [[nodiscard]] ControllerProcess& of(const std::vector<std::string>& command);

 private:
  std::map<std::vector<std::string>, std::unique_ptr<ControllerProcess>> processes_;
};

}  // namespace jaywalk

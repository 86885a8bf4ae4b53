// SPDX-License-Identifier: Apache-2.0
// Controllers outside of Jaywalk, which answer an acceleration for each view: a process that reads
// and writes a line of JSON each (docs/reference/controller_protocol.md describes the fields, which
// are those of VehicleView, and what a kept process must keep to), and a driver of the program that
// embeds Jaywalk.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "env/process/numbered_process.h"
#include "env/vehicle/controller_processes.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {
namespace {

nlohmann::json to_json(const DriveBriefing& briefing) {
  return {{"test", briefing.test},
          {"seed", briefing.seed},
          {"behaviour", briefing.behaviour},
          {"agents", briefing.agents},
          {"road", tidy(briefing.road_m)},
          {"cruise", tidy(briefing.cruise_mps)},
          {"limits", {-kHardestBrakingMps2, kHardestAccelerationMps2}}};
}

nlohmann::json to_json(const DriveEnd& end) {
  nlohmann::json said{{"why", std::string(end.why)}, {"collision", end.impact_mps.has_value()}};
  if (end.impact_mps) said["impact"] = tidy(*end.impact_mps);
  return said;
}

/// The name of a controller in messages: its script rather than the interpreter of the script.
std::string title_of(const std::vector<std::string>& command) {
  std::error_code ignored;
  for (std::size_t i = 1; i < command.size(); ++i) {
    if (std::filesystem::is_regular_file(command[i], ignored)) return command[i];
  }
  return command.empty() ? std::string() : command.front();
}

/// Limits answers to what a vehicle can do, and remembers the first one that was more.
class AnswerLimit {
 public:
  double limited(double wanted_mps2) {
    const double possible = std::clamp(wanted_mps2, -kHardestBrakingMps2, kHardestAccelerationMps2);
    if (possible != wanted_mps2 && excess_mps2_ == 0) excess_mps2_ = wanted_mps2;
    return possible;
  }
  void add_note(const std::string& title, std::vector<std::string>& notes) const {
    if (excess_mps2_ == 0) return;
    notes.push_back(fmt::format(
        "the controller '{}' asked for {:g} m/s2; a vehicle does {:.4g} to {:g}, to which its "
        "answers are limited",
        title, excess_mps2_, -kHardestBrakingMps2, kHardestAccelerationMps2));
  }

 private:
  double excess_mps2_ = 0;
};

class Own final : public VehicleController {
 public:
  explicit Own(const OwnVehicle& vehicle) : name_(vehicle.name), driver_(vehicle.make()) {}

  VehicleDecision decide(const VehicleView& view) override {
    if (!failure_.empty()) return {};
    const double wanted_mps2 = driver_->decide(view);
    std::string why = driver_->failure();
    if (why.empty() && !std::isfinite(wanted_mps2)) {
      why = fmt::format("an acceleration of {} m/s2", wanted_mps2);
    }
    if (!why.empty()) failure_ = fmt::format("the controller '{}': {}", name_, why);
    return {failure_.empty() ? limit_.limited(wanted_mps2) : 0};
  }

  [[nodiscard]] std::string failure() const override { return failure_; }
  [[nodiscard]] std::vector<std::string> take_notes() override {
    std::vector<std::string> notes;
    limit_.add_note(name_, notes);
    return notes;
  }

 private:
  std::string name_;
  std::unique_ptr<VehicleDriver> driver_;
  AnswerLimit limit_;
  std::string failure_;
};

class External final : public VehicleController {
 public:
  explicit External(const VehicleParameters& parameters)
      : command_(parameters.command), keeps_(parameters.keeps_process) {}

  void begin(const DriveBriefing& briefing) override {
    test_ = briefing.test;
    if (!keeps_ || briefing.processes == nullptr) return;
    process_ = &briefing.processes->of(command_);
    fail(process_->begin(to_json(briefing)));
  }

  VehicleDecision decide(const VehicleView& view) override {
    if (!failure_.empty()) return {};
    double wanted_mps2 = 0;
    fail(process().decide(view, test_, wanted_mps2));
    return {failure_.empty() ? limit_.limited(wanted_mps2) : 0};
  }

  void end(const DriveEnd& end) override {
    if (failure_.empty()) fail(process().end(to_json(end)));
  }

  [[nodiscard]] std::string failure() const override { return failure_; }
  [[nodiscard]] std::vector<std::string> take_notes() override {
    std::vector<std::string> notes;
    limit_.add_note(title_of(command_), notes);
    if (own_) own_->finish();
    if (std::string errors = process().take_errors(); !errors.empty()) {
      notes.push_back(fmt::format("the controller '{}' wrote to standard error:\n{}",
                                  title_of(command_), errors));
    }
    return notes;
  }

 private:
  ControllerProcess& process() {
    if (process_ != nullptr) return *process_;
    if (!own_) own_ = std::make_unique<ControllerProcess>(command_);
    return *own_;
  }

  /// Nothing of an empty reason.
  void fail(const std::string& why) {
    if (!why.empty()) failure_ = fmt::format("the controller '{}': {}", title_of(command_), why);
  }

  std::vector<std::string> command_;
  bool keeps_;
  std::unique_ptr<ControllerProcess> own_;
  ControllerProcess* process_ = nullptr;  // a kept one
  std::uint64_t test_ = 0;
  AnswerLimit limit_;
  std::string failure_;
};

}  // namespace

std::unique_ptr<VehicleController> make_own(const OwnVehicle& vehicle) {
  return std::make_unique<Own>(vehicle);
}

std::unique_ptr<VehicleController> make_external(const VehicleParameters& parameters) {
  return std::make_unique<External>(parameters);
}

}  // namespace jaywalk

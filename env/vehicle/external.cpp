// A controller outside of this program. For each decision it reads one line, a view as JSON, and
// answers one line: {"acceleration": -3.5}, in m/s^2. The fields of the view are those of
// VehicleView, lengths in metres, speeds in m/s, angles in rad:
//
//   {"step":4,"test":7,"time":0.4,"period":0.1,"speed":9,"cruise":9,"front":12.6,"length":4.5,
//    "body":[4.5,7.5],"lane":[3,9],"lanes":[{"sides":[3,9],"oncoming":false}],"kerb":[3,9],
//    "range":100,
//    "actors":[{"id":1,"kind":"pedestrian","gap":12.5,"far":13,"sides":[2,2.5],"ahead":0,
//               "right":1.5,"heading":1.5708}],
//    "obstacles":[{"gap":20,"far":26,"sides":[1.5,3]}],"stop_lines":[{"gap":20,"closed":true}]}
//
// `front` counts from the road's begin, `gap` and `far` from the vehicle's front, `sides`, `body`,
// `lane` and `kerb` from the world's left. `step` counts the questions of the test from 0. An
// answer may repeat it, {"step":4,"acceleration":-3.5}; then it is checked, so that a line too many
// cannot shift the answers after it. More than one line for a question ends the test, and so does
// an acceleration beyond 1000 m/s^2; others are limited to what a vehicle can do.
//
// Each test starts a process of its own, so that none remembers another, unless the scenario says
// `process: kept`. Then one process drives in many tests, and each begins and ends with a line:
//
//   {"step":0,"reset":{"test":7,"seed":1,"behaviour":"proximity","agents":1,"road":99,"cruise":9,
//                      "limits":[-9.80665,5]}}
//   {"end":{"why":"collision","collision":true,"impact":3.2}}
//
// `reset` is answered with an object, `end` is not answered; the views begin with step 1. The
// answer to `reset` may name the fields that the controller reads; then the views of the test have
// no others but `step`, which makes them quicker to write and to read:
//
//   {"step":0,"reads":["lane","actors.gap","actors.sides","stop_lines"]}
//
// The answers of a kept process must follow from `reset` and the views since then alone. Tests
// that differ only in the AV's defects (the same `reset`) and begin with the same views share its
// answers. In another such test it is queried only when a new view comes, then with all the views
// before it; if it answers those differently from the first time, that test fails.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "env/process/tidy.h"
#include "env/vehicle/controller_processes.h"
#include "env/vehicle/models.h"

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
    return {failure_.empty() ? limited(wanted_mps2) : 0};
  }

  void end(const DriveEnd& end) override {
    if (failure_.empty()) fail(process().end(to_json(end)));
  }

  [[nodiscard]] std::string failure() const override { return failure_; }
  [[nodiscard]] std::vector<std::string> take_notes() override {
    std::vector<std::string> notes;
    if (excess_mps2_ != 0) {
      notes.push_back(fmt::format(
          "the controller '{}' asked for {:g} m/s2; a vehicle does {:.4g} to {:g}, to which its "
          "answers are limited",
          title_of(command_), excess_mps2_, -kHardestBrakingMps2, kHardestAccelerationMps2));
    }
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

  double limited(double wanted_mps2) {
    const double possible = std::clamp(wanted_mps2, -kHardestBrakingMps2, kHardestAccelerationMps2);
    if (possible != wanted_mps2 && excess_mps2_ == 0) excess_mps2_ = wanted_mps2;
    return possible;
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
  double excess_mps2_ = 0;  // the first answer that was more than a vehicle can do
  std::string failure_;
};

}  // namespace

std::unique_ptr<VehicleController> make_external(const VehicleParameters& parameters) {
  return std::make_unique<External>(parameters);
}

}  // namespace jaywalk

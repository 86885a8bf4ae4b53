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
// `reset` is answered with any object, `end` is not answered; the views begin with step 1.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "env/process/tidy.h"
#include "env/vehicle/controller_processes.h"
#include "env/vehicle/models.h"
#include "env/vehicle/view_text.h"

namespace jaywalk {
namespace {

// A controller that thinks for longer is taken for dead.
constexpr std::chrono::milliseconds kLimit{5000};
// How long one that does not repeat the step is watched for unexpected lines.
constexpr std::chrono::milliseconds kSettling{1};
// Answers beyond a hundred times gravity are refused; what is less absurd is limited.
constexpr double kAbsurdMps2 = 1000;

nlohmann::json to_json(const DriveBriefing& briefing) {
  return {{"test", briefing.test},
          {"seed", briefing.seed},
          {"behaviour", briefing.behaviour},
          {"agents", briefing.agents},
          {"road", tidy(briefing.road_m)},
          {"cruise", tidy(briefing.cruise_mps)},
          {"limits", {-kHardestBrakingMps2, kHardestAccelerationMps2}}};
}

/// What to call a controller: its script rather than what interprets it.
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
    const std::size_t step = steps_++;
    (void)answer_of(process_->ask({{"reset", to_json(briefing)}}, step, kLimit));
  }

  VehicleDecision decide(const VehicleView& view) override {
    if (!failure_.empty()) return {};
    const std::size_t step = steps_++;
    const auto answer = answer_of(process().ask_text(view_text(view, test_, step), step, kLimit));
    if (!answer) return {};
    const auto acceleration = answer->find("acceleration");
    if (acceleration == answer->end() || !acceleration->is_number()) {
      fail(process().refuse("expected {\"acceleration\": <m/s^2>}"));
      return {};
    }
    // A controller that asks for that reckons wrongly, and its other answers mean nothing either.
    if (!(std::fabs(acceleration->get<double>()) <= kAbsurdMps2)) {
      fail(process().refuse(fmt::format("no vehicle reaches {:g} m/s^2, let alone more than {:g}",
                                        acceleration->get<double>(), kAbsurdMps2)));
      return {};
    }
    return {limited(acceleration->get<double>())};
  }

  void end(const DriveEnd& end) override {
    if (!failure_.empty()) return;
    // One that drives on is asked again, which finds what comes later.
    const bool drives_on = process_ != nullptr;
    const std::string more =
        process().said_more(drives_on ? std::chrono::milliseconds(0) : kSettling);
    if (!more.empty()) return fail(more);
    if (!drives_on) return;
    nlohmann::json said{{"why", std::string(end.why)}, {"collision", end.impact_mps.has_value()}};
    if (end.impact_mps) said["impact"] = tidy(*end.impact_mps);
    process_->tell({{"end", std::move(said)}}, kLimit);
  }

  [[nodiscard]] std::string failure() const override { return failure_; }
  [[nodiscard]] std::string note() const override {
    if (excess_mps2_ == 0) return {};
    return fmt::format(
        "the controller '{}' asked for {:g} m/s2; a vehicle does {:.4g} to {:g}, to which its "
        "answers are limited",
        title_of(command_), excess_mps2_, -kHardestBrakingMps2, kHardestAccelerationMps2);
  }

 private:
  NumberedProcess& process() {
    if (process_ != nullptr) return *process_;
    if (!own_) own_ = controller_process(command_);
    return *own_;
  }

  /// Nothing after an error.
  std::optional<nlohmann::json> answer_of(JsonAnswer answer) {
    if (answer.error.empty()) return std::move(answer.json);
    fail(answer.error);
    return std::nullopt;
  }

  double limited(double wanted_mps2) {
    const double possible = std::clamp(wanted_mps2, -kHardestBrakingMps2, kHardestAccelerationMps2);
    if (possible != wanted_mps2 && excess_mps2_ == 0) excess_mps2_ = wanted_mps2;
    return possible;
  }

  void fail(const std::string& why) {
    failure_ = fmt::format("the controller '{}': {}", title_of(command_), why);
  }

  std::vector<std::string> command_;
  bool keeps_;
  std::unique_ptr<NumberedProcess> own_;
  NumberedProcess* process_ = nullptr;  // a kept one
  std::uint64_t test_ = 0;
  std::size_t steps_ = 0;
  double excess_mps2_ = 0;  // the first answer that was more than a vehicle can do
  std::string failure_;
};

}  // namespace

std::unique_ptr<NumberedProcess> controller_process(const std::vector<std::string>& command) {
  return std::make_unique<NumberedProcess>(
      NumberedProcess::Settings{.command = command, .key = "step", .settling = kSettling});
}

NumberedProcess& ControllerProcesses::of(const std::vector<std::string>& command) {
  std::unique_ptr<NumberedProcess>& process = processes_[command];
  if (!process) process = controller_process(command);
  return *process;
}

std::unique_ptr<VehicleController> make_external(const VehicleParameters& parameters) {
  return std::make_unique<External>(parameters);
}

}  // namespace jaywalk

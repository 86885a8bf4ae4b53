// A controller outside of this program. For each decision it reads one line, a view as JSON, and
// answers one line: {"acceleration": -3.5}, in m/s^2. The fields of the view are those of
// VehicleView, lengths in metres, speeds in m/s:
//
//   {"step":4,"time":0.4,"period":0.1,"speed":9,"cruise":9,"body":[4.5,7.5],"lane":[3,9],
//    "actors":[{"id":1,"kind":"pedestrian","gap":12.5,"sides":[2,2.5],"ahead":0,"right":1.5}],
//    "stop_lines":[{"gap":20,"closed":true}]}
//
// `step` counts the decisions of the test from 0. An answer may repeat it,
// {"step":4,"acceleration":-3.5}; then it is checked, so that a line too many cannot shift the
// answers after it. Each test starts a process of its own, so that none remembers another.

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "env/process/numbered_process.h"
#include "env/vehicle/models.h"

namespace jaywalk {
namespace {

// A controller that thinks for longer is taken for dead.
constexpr std::chrono::milliseconds kLimit{5000};
// How long one that does not repeat the step is watched for lines that nobody asked for.
constexpr std::chrono::milliseconds kSettling{1};

nlohmann::json to_json(const VehicleView& view) {
  nlohmann::json actors = nlohmann::json::array();
  for (const SeenActor& actor : view.actors) {
    actors.push_back({{"id", actor.id},
                      {"kind", std::string(name(actor.kind))},
                      {"gap", actor.gap_m},
                      {"sides", {actor.left_m, actor.right_m}},
                      {"ahead", actor.speed_ahead_mps},
                      {"right", actor.speed_right_mps}});
  }
  nlohmann::json lines = nlohmann::json::array();
  for (const StopLine& line : view.stop_lines) {
    lines.push_back({{"gap", line.gap_m}, {"closed", line.closed}});
  }
  return {{"time", view.time_s},
          {"period", view.period_s},
          {"speed", view.speed_mps},
          {"cruise", view.cruise_mps},
          {"body", {view.left_m, view.right_m}},
          {"lane", {view.lane_left_m, view.lane_right_m}},
          {"actors", std::move(actors)},
          {"stop_lines", std::move(lines)}};
}

class External final : public VehicleController {
 public:
  explicit External(const VehicleParameters& parameters)
      : name_(parameters.command.empty() ? "" : parameters.command.front()),
        process_({.command = parameters.command, .key = "step", .settling = kSettling}) {}

  VehicleDecision decide(const VehicleView& view) override {
    if (!failure_.empty()) return {};
    const JsonAnswer answer = process_.ask(to_json(view), steps_++, kLimit);
    if (!answer.error.empty()) return failed(answer.error);
    const auto acceleration = answer.json.find("acceleration");
    if (acceleration == answer.json.end() || !acceleration->is_number() ||
        !std::isfinite(acceleration->get<double>())) {
      return failed(process_.refuse("expected {\"acceleration\": <m/s^2>}"));
    }
    return {acceleration->get<double>()};
  }

  [[nodiscard]] std::string failure() const override { return failure_; }

 private:
  VehicleDecision failed(const std::string& why) {
    failure_ = fmt::format("the controller '{}': {}", name_, why);
    return {};
  }

  std::string name_;
  NumberedProcess process_;
  std::size_t steps_ = 0;
  std::string failure_;
};

}  // namespace

std::unique_ptr<VehicleController> make_external(const VehicleParameters& parameters) {
  return std::make_unique<External>(parameters);
}

}  // namespace jaywalk

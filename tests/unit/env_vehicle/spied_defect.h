// SPDX-License-Identifier: Apache-2.0
#pragma once

// A defect on a controller that records its views and gives fixed answers, so that tests see the
// effect of the defect alone.

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "env/vehicle/defects.h"

namespace jaywalk {

/// The last view of the controller under the defect, and its answer.
struct Spied {
  std::vector<SeenActor> actors;
  std::vector<StopLine> stop_lines;
  double answer_mps2 = 0;
};

class SpiedController final : public VehicleController {
 public:
  explicit SpiedController(std::shared_ptr<Spied> spied) : spied_(std::move(spied)) {}

  VehicleDecision decide(const VehicleView& view) override {
    spied_->actors.assign(view.actors.begin(), view.actors.end());
    spied_->stop_lines.assign(view.stop_lines.begin(), view.stop_lines.end());
    return {spied_->answer_mps2};
  }

 private:
  std::shared_ptr<Spied> spied_;
};

/// The vehicle drives with 10 m/s; its body is 4.5 m to 7.5 m from the left, its lane 3 m to 9 m.
class SpiedDefect {
 public:
  SpiedDefect(std::string_view defect, double severity)
      : controller_(
            find_defect(defect)->make(std::make_unique<SpiedController>(spied_), severity)) {}

  /// Whom the controller sees at that time.
  std::vector<SeenActor> sees(double time_s, std::vector<SeenActor> actors) {
    view.time_s = time_s;
    view.actors = actors;
    (void)controller_->decide(view);
    return spied_->actors;
  }
  std::vector<SeenActor> sees(std::vector<SeenActor> actors) { return sees(0, std::move(actors)); }

  /// The numbers of those whom the controller sees.
  std::vector<unsigned> numbers(double time_s, std::vector<SeenActor> actors) {
    std::vector<unsigned> numbers;
    for (const SeenActor& actor : sees(time_s, std::move(actors))) numbers.push_back(actor.id);
    return numbers;
  }
  std::vector<unsigned> numbers(std::vector<SeenActor> actors) {
    return numbers(0, std::move(actors));
  }

  /// The defect's answer at that time.
  double answers(double time_s, double wanted_mps2) {
    view.time_s = time_s;
    view.actors = {};
    spied_->answer_mps2 = wanted_mps2;
    return controller_->decide(view).acceleration_mps2;
  }

  [[nodiscard]] const std::vector<StopLine>& stop_lines() const { return spied_->stop_lines; }

  VehicleView view{.period_s = 0.1,
                   .speed_mps = 10,
                   .cruise_mps = 10,
                   .left_m = 4.5,
                   .right_m = 7.5,
                   .lane_left_m = 3,
                   .lane_right_m = 9};

 private:
  std::shared_ptr<Spied> spied_ = std::make_shared<Spied>();
  std::unique_ptr<VehicleController> controller_;
};

/// Half a metre wide, from `left_m` on.
inline SeenActor person(unsigned id, double gap_m, double left_m, double right_mps = 0,
                        double ahead_mps = 0) {
  return {.id = id,
          .gap_m = gap_m,
          .left_m = left_m,
          .right_m = left_m + 0.5,
          .speed_ahead_mps = ahead_mps,
          .speed_right_mps = right_mps};
}

}  // namespace jaywalk

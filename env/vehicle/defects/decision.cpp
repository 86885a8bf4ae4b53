// SPDX-License-Identifier: Apache-2.0
// Defects of decision: wrong accelerations for a correct view.

#include <algorithm>
#include <map>

#include "env/vehicle/defects/defective.h"

namespace jaywalk {
namespace {

class Confirmation final : public Defective {
  double act(const VehicleView& view, double wanted_mps2) override {
    if (!brakes(wanted_mps2)) {
      since_s_.reset();
      return wanted_mps2;
    }
    if (!since_s_) since_s_ = view.time_s;
    return view.time_s - *since_s_ + kTimeRoundingS < severity_ ? 0 : wanted_mps2;
  }

  std::optional<double> since_s_;
};

class BrakesOnce final : public Defective {
  void look(const VehicleView& view, Sensed& sensed) override {
    std::erase_if(sensed.actors, [&](const SeenActor& actor) {
      const auto conflict = conflicts_.find(actor.id);
      if (conflict == conflicts_.end()) return false;
      // Once over it never counts again, even if the actor comes back.
      if (!is_risk(actor, lane_of(view))) conflict->second = Conflict::over;
      return conflict->second == Conflict::over;
    });
    in_lane_ = sensed.actors;
    std::erase_if(in_lane_, [&](const SeenActor& a) { return !is_risk(a, lane_of(view)); });
  }

  double act(const VehicleView&, double wanted_mps2) override {
    if (brakes(wanted_mps2)) {
      for (const SeenActor& actor : in_lane_) conflicts_.emplace(actor.id, Conflict::braked_for);
    }
    return wanted_mps2;
  }

  enum class Conflict { braked_for, over };

  std::map<std::uint32_t, Conflict> conflicts_;
  std::vector<SeenActor> in_lane_;
};

class NearestOnly final : public Defective {
  void look(const VehicleView&, Sensed& sensed) override {
    std::erase_if(sensed.actors, [](const SeenActor& actor) { return actor.gap_m < 0; });
    const auto nearest = std::ranges::min_element(sensed.actors, {}, &SeenActor::gap_m);
    if (nearest != sensed.actors.end()) sensed.actors = {SeenActor(*nearest)};
  }
};

class ComfortBraking final : public Defective {
  double act(const VehicleView&, double wanted_mps2) override {
    return std::max(wanted_mps2, -severity_);
  }
};

class OffWhenSlow final : public Defective {
  double act(const VehicleView& view, double wanted_mps2) override {
    return view.speed_mps < severity_ ? std::max(wanted_mps2, 0.0) : wanted_mps2;
  }
};

class OffWhenFast final : public Defective {
  double act(const VehicleView& view, double wanted_mps2) override {
    return view.speed_mps > severity_ ? std::max(wanted_mps2, 0.0) : wanted_mps2;
  }
};

/// Slows no further than to its creeping speed, and comes up to it.
class Creeps final : public Defective {
  double act(const VehicleView& view, double wanted_mps2) override {
    const double to_creeping = (severity_ - view.speed_mps) / view.period_s;
    // Below its creeping speed it pushes on, however hard the inner controller brakes.
    return std::max(wanted_mps2, std::min(to_creeping, kPushMps2));
  }

  static constexpr double kPushMps2 = 1;
};

/// It counts as waiting that it brakes, and that it does not drive on though it is slow.
class GivesUp final : public Defective {
  double act(const VehicleView& view, double wanted_mps2) override {
    const bool is_slow = view.speed_mps < view.cruise_mps - kStandingMps;
    if (!brakes(wanted_mps2) && !(is_slow && wanted_mps2 <= 0)) {
      since_s_.reset();
      return wanted_mps2;
    }
    if (!since_s_) since_s_ = view.time_s;
    const bool waits = view.time_s - *since_s_ + kTimeRoundingS < severity_;
    return waits ? wanted_mps2 : resume(view, kDrivesOnMps2);
  }

  static constexpr double kDrivesOnMps2 = 2;

  std::optional<double> since_s_;
};

class BlindAfterStop final : public Defective {
  void look(const VehicleView& view, Sensed& sensed) override {
    const bool stands = view.speed_mps < kStandingMps;
    if (stood_ && !stands) moved_off_at_s_ = view.time_s;
    stood_ = stands;
    if (!moved_off_at_s_) return;
    if (view.time_s - *moved_off_at_s_ + kTimeRoundingS < severity_) sensed.actors.clear();
  }

  bool stood_ = false;
  std::optional<double> moved_off_at_s_;
};

/// Over the lane, past its middle and on the way out.
bool has_passed_the_middle(const VehicleView& view, const SeenActor& actor, double) {
  const double middle = (view.lane_left_m + view.lane_right_m) / 2;
  return (actor.speed_right_mps > 0 && actor.left_m > middle) ||
         (actor.speed_right_mps < 0 && actor.right_m < middle);
}

bool is_pedestrian(const VehicleView&, const SeenActor& actor, double) {
  return actor.kind == ActorKind::pedestrian;
}

}  // namespace

const DefectMaker make_confirmation = put<Confirmation>;
const DefectMaker make_brakes_once = put<BrakesOnce>;
const DefectMaker make_resumes_early = put<Unseeing<has_passed_the_middle>>;
const DefectMaker make_nearest_only = put<NearestOnly>;
const DefectMaker make_comfort_braking = put<ComfortBraking>;
const DefectMaker make_off_when_slow = put<OffWhenSlow>;
const DefectMaker make_off_when_fast = put<OffWhenFast>;
const DefectMaker make_creeps = put<Creeps>;
const DefectMaker make_gives_up = put<GivesUp>;
const DefectMaker make_zebra_only = put<Unseeing<is_pedestrian>>;
const DefectMaker make_blind_after_stop = put<BlindAfterStop>;

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Defects of actuation: decisions are carried out late, weaker or gradually.

#include <algorithm>
#include <deque>

#include "env/scene.h"
#include "env/vehicle/defects/defective.h"

namespace jaywalk {
namespace {

/// Released at once.
class SlowBrakes final : public Defective {
  double act(const VehicleView& view, double wanted_mps2) override {
    const double grown = braking_mps2_ + kFullBrakingMps2 / severity_ * view.period_s;
    braking_mps2_ = std::clamp(-wanted_mps2, 0.0, grown);
    return std::max(wanted_mps2, -grown);
  }

  static constexpr double kFullBrakingMps2 = 8;

  double braking_mps2_ = 0;
};

class LowFriction final : public Defective {
  double act(const VehicleView&, double wanted_mps2) override {
    const double most = severity_ * kGravityMps2;
    return std::clamp(wanted_mps2, -most, most);
  }
};

class BrakeFade final : public Defective {
  double act(const VehicleView&, double wanted_mps2) override {
    const bool braking = brakes(wanted_mps2);
    if (was_braking_ && !braking) is_hot_ = true;
    was_braking_ = braking;
    return braking && is_hot_ ? wanted_mps2 * severity_ / 100 : wanted_mps2;
  }

  bool was_braking_ = false;
  bool is_hot_ = false;
};

class WeakBrakes final : public Defective {
  double act(const VehicleView&, double wanted_mps2) override {
    return wanted_mps2 < 0 ? wanted_mps2 * severity_ / 100 : wanted_mps2;
  }
};

/// The pedal changes once the other one has been wanted for as long.
class PedalChange final : public Defective {
  double act(const VehicleView& view, double wanted_mps2) override {
    if (brakes(wanted_mps2) == on_brake_) {
      since_s_.reset();
      return wanted_mps2;
    }
    if (!since_s_) since_s_ = view.time_s;
    if (view.time_s - *since_s_ + kTimeRoundingS < severity_) return 0;
    on_brake_ = !on_brake_;
    since_s_.reset();
    return wanted_mps2;
  }

  bool on_brake_ = false;
  std::optional<double> since_s_;
};

/// Before its first decision comes through it does nothing.
class ActuationDelay final : public Defective {
  double act(const VehicleView& view, double wanted_mps2) override {
    decisions_.push_back({view.time_s, wanted_mps2});
    const double done_s = view.time_s - severity_ + kTimeRoundingS;
    while (decisions_.size() > 1 && decisions_[1].time_s <= done_s) decisions_.pop_front();
    return decisions_.front().time_s <= done_s ? decisions_.front().acceleration_mps2 : 0;
  }

  struct Decision {
    double time_s = 0;
    double acceleration_mps2 = 0;
  };
  std::deque<Decision> decisions_;
};

}  // namespace

const DefectMaker make_slow_brakes = put<SlowBrakes>;
const DefectMaker make_low_friction = put<LowFriction>;
const DefectMaker make_brake_fade = put<BrakeFade>;
const DefectMaker make_pedal_change = put<PedalChange>;
const DefectMaker make_actuation_delay = put<ActuationDelay>;
const DefectMaker make_weak_brakes = put<WeakBrakes>;

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Defects of actuation: decisions are carried out late, weaker or gradually.

#include <algorithm>
#include <deque>

#include "env/scene.h"
#include "env/vehicle/defects/defective.h"

namespace jaywalk {
namespace {

using Inner = std::unique_ptr<VehicleController>;

/// Released at once.
class SlowBrakes final : public Defective {
 public:
  using Defective::Defective;

 protected:
  double act(const VehicleView& view, double wanted_mps2) override {
    const double grown = braking_mps2_ + kFullBrakingMps2 / severity_ * view.period_s;
    braking_mps2_ = std::clamp(-wanted_mps2, 0.0, grown);
    return std::max(wanted_mps2, -grown);
  }

 private:
  static constexpr double kFullBrakingMps2 = 8;

  double braking_mps2_ = 0;
};

class LowFriction final : public Defective {
 public:
  using Defective::Defective;

 protected:
  double act(const VehicleView&, double wanted_mps2) override {
    const double most = severity_ * kGravityMps2;
    return std::clamp(wanted_mps2, -most, most);
  }
};

class BrakeFade final : public Defective {
 public:
  using Defective::Defective;

 protected:
  double act(const VehicleView&, double wanted_mps2) override {
    const bool braking = brakes(wanted_mps2);
    if (was_braking_ && !braking) is_hot_ = true;
    was_braking_ = braking;
    return braking && is_hot_ ? wanted_mps2 * severity_ / 100 : wanted_mps2;
  }

 private:
  bool was_braking_ = false;
  bool is_hot_ = false;
};

class WeakBrakes final : public Defective {
 public:
  using Defective::Defective;

 protected:
  double act(const VehicleView&, double wanted_mps2) override {
    return wanted_mps2 < 0 ? wanted_mps2 * severity_ / 100 : wanted_mps2;
  }
};

/// The pedal changes once the other one has been wanted for as long.
class PedalChange final : public Defective {
 public:
  using Defective::Defective;

 protected:
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

 private:
  bool on_brake_ = false;
  std::optional<double> since_s_;
};

/// Before its first decision comes through it does nothing.
class ActuationDelay final : public Defective {
 public:
  using Defective::Defective;

 protected:
  double act(const VehicleView& view, double wanted_mps2) override {
    decisions_.push_back({view.time_s, wanted_mps2});
    const double done_s = view.time_s - severity_ + kTimeRoundingS;
    while (decisions_.size() > 1 && decisions_[1].time_s <= done_s) decisions_.pop_front();
    return decisions_.front().time_s <= done_s ? decisions_.front().acceleration_mps2 : 0;
  }

 private:
  struct Decision {
    double time_s = 0;
    double acceleration_mps2 = 0;
  };
  std::deque<Decision> decisions_;
};

}  // namespace

std::unique_ptr<VehicleController> make_slow_brakes(Inner inner, double severity) {
  return std::make_unique<SlowBrakes>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_low_friction(Inner inner, double severity) {
  return std::make_unique<LowFriction>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_brake_fade(Inner inner, double severity) {
  return std::make_unique<BrakeFade>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_pedal_change(Inner inner, double severity) {
  return std::make_unique<PedalChange>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_actuation_delay(Inner inner, double severity) {
  return std::make_unique<ActuationDelay>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_weak_brakes(Inner inner, double severity) {
  return std::make_unique<WeakBrakes>(std::move(inner), severity);
}

}  // namespace jaywalk

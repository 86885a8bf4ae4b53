// SPDX-License-Identifier: Apache-2.0
// Defects of perception: an actor is not seen, or seen late or elsewhere.

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <numbers>

#include "env/vehicle/defects/defective.h"

namespace jaywalk {
namespace {

using Inner = std::unique_ptr<VehicleController>;

/// Before it has seen anything for so long, it sees the first picture.
class Latency final : public Defective {
 public:
  using Defective::Defective;

 protected:
  void look(const VehicleView& view, Sensed& sensed) override {
    pictures_.push_back({view.time_s, sensed});
    const double shown_s = view.time_s - severity_ + kTimeRoundingS;
    while (pictures_.size() > 1 && pictures_[1].time_s <= shown_s) pictures_.pop_front();
    sensed = pictures_.front().sensed;
  }

 private:
  struct Picture {
    double time_s = 0;
    Sensed sensed;
  };
  std::deque<Picture> pictures_;
};

/// Windows in which it sees and in which it does not take turns, seeing first.
class FrozenFrames final : public Defective {
 public:
  using Defective::Defective;

 protected:
  void look(const VehicleView& view, Sensed& sensed) override {
    const bool sees = std::fmod(view.time_s + kTimeRoundingS, 2 * severity_) < severity_;
    if (sees) {
      last_ = sensed;
    } else {
      sensed = last_;
    }
  }

 private:
  Sensed last_;
};

/// Actors present when the drive begins count as tracked.
class SlowTracking final : public Defective {
 public:
  using Defective::Defective;

 protected:
  void look(const VehicleView& view, Sensed& sensed) override {
    const double begins_s =
        is_first_ ? -std::numeric_limits<double>::infinity() : view.time_s + kTimeRoundingS;
    is_first_ = false;
    std::map<std::uint32_t, double> seen;
    for (const SeenActor& actor : sensed.actors) {
      const auto known = since_s_.find(actor.id);
      seen[actor.id] = known == since_s_.end() ? begins_s : known->second;
    }
    since_s_ = std::move(seen);
    std::erase_if(sensed.actors, [&](const SeenActor& actor) {
      return view.time_s + 2 * kTimeRoundingS - since_s_.at(actor.id) < severity_;
    });
  }

 private:
  bool is_first_ = true;
  std::map<std::uint32_t, double> since_s_;
};

/// A controller remembers an actor by its number.
class ClassChange final : public Defective {
 public:
  using Defective::Defective;

 protected:
  void look(const VehicleView& view, Sensed& sensed) override {
    const double classes = (view.time_s + kTimeRoundingS) / severity_;
    const double whole = std::floor(classes);
    if (whole < 1 || !std::isfinite(whole)) return;
    const auto changes = static_cast<std::uint32_t>(std::fmod(whole, kMostChanges));
    for (SeenActor& actor : sensed.actors) {
      actor.id += changes * kNumbers;
      if (classes - whole < 0.5) actor.speed_ahead_mps = actor.speed_right_mps = 0;
    }
  }

 private:
  // More than there are actors, and as many changes as their numbers leave room for.
  static constexpr std::uint32_t kNumbers = 1'000'000;
  static constexpr double kMostChanges = 4000;
};

class MergedGroup final : public Defective {
 public:
  using Defective::Defective;

 protected:
  void look(const VehicleView&, Sensed& sensed) override {
    std::vector<SeenActor> kept;
    for (const SeenActor& actor : sensed.actors) {
      const bool is_part = std::ranges::any_of(kept, [&](const SeenActor& other) {
        return std::hypot(actor.gap_m - other.gap_m, middle_of(actor) - middle_of(other)) <=
               severity_;
      });
      if (!is_part) kept.push_back(actor);
    }
    sensed.actors = std::move(kept);
  }
};

class LateralBias final : public Defective {
 public:
  using Defective::Defective;

 protected:
  void look(const VehicleView&, Sensed& sensed) override {
    for (SeenActor& actor : sensed.actors) {
      actor.left_m += severity_;
      actor.right_m += severity_;
    }
  }
};

class RangeBias final : public Defective {
 public:
  using Defective::Defective;

 protected:
  void look(const VehicleView&, Sensed& sensed) override {
    for (SeenActor& actor : sensed.actors) actor.gap_m += severity_;
  }
};

double middle_of_body(const VehicleView& view) { return (view.left_m + view.right_m) / 2; }

/// The box reaches into the angle, whose corner is the middle of the front.
bool is_in_angle(const VehicleView& view, const SeenActor& actor, double degrees) {
  const double front = middle_of_body(view);
  const double aside = std::max({actor.left_m - front, front - actor.right_m, 0.0});
  return std::atan2(aside, actor.gap_m) * 180 / std::numbers::pi <= degrees / 2;
}

bool is_near_crosswalk(const VehicleView& view, const SeenActor& actor, double metres) {
  return std::ranges::any_of(view.stop_lines, [&](const StopLine& line) {
    return std::abs(actor.gap_m - line.gap_m) <= metres;
  });
}

bool is_near_obstacle(const VehicleView& view, const SeenActor& actor, double metres) {
  return std::ranges::any_of(view.obstacles, [&](const SeenObstacle& each) {
    const double across = std::max({each.left_m - actor.right_m, actor.left_m - each.right_m, 0.0});
    const double along = std::max({each.gap_m - actor.gap_m, actor.gap_m - each.far_m, 0.0});
    return std::hypot(across, along) <= metres;
  });
}

}  // namespace

std::unique_ptr<VehicleController> make_latency(Inner inner, double severity) {
  return std::make_unique<Latency>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_short_range(Inner inner, double severity) {
  return unseeing(std::move(inner), severity,
                  [](const VehicleView&, const SeenActor& actor, double range_m) {
                    return actor.gap_m > range_m;
                  });
}

std::unique_ptr<VehicleController> make_narrow_view(Inner inner, double severity) {
  return unseeing(std::move(inner), severity,
                  [](const VehicleView& view, const SeenActor& actor, double degrees) {
                    return !is_in_angle(view, actor, degrees);
                  });
}

std::unique_ptr<VehicleController> make_blind_to_standing(Inner inner, double severity) {
  return unseeing(std::move(inner), severity,
                  [](const VehicleView&, const SeenActor& actor, double) {
                    return speed_of(actor) < kStandingMps;
                  });
}

std::unique_ptr<VehicleController> make_own_lane_only(Inner inner, double severity) {
  return unseeing(
      std::move(inner), severity, [](const VehicleView& view, const SeenActor& actor, double) {
        return middle_of(actor) < view.lane_left_m || middle_of(actor) > view.lane_right_m;
      });
}

std::unique_ptr<VehicleController> make_own_path_only(Inner inner, double severity) {
  return unseeing(std::move(inner), severity,
                  [](const VehicleView& view, const SeenActor& actor, double) {
                    return !is_over(actor, {view.left_m, view.right_m});
                  });
}

std::unique_ptr<VehicleController> make_slow_tracking(Inner inner, double severity) {
  return std::make_unique<SlowTracking>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_class_change(Inner inner, double severity) {
  return std::make_unique<ClassChange>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_merged_group(Inner inner, double severity) {
  return std::make_unique<MergedGroup>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_off_crossing(Inner inner, double severity) {
  return unseeing(std::move(inner), severity,
                  [](const VehicleView& view, const SeenActor& actor, double metres) {
                    return actor.kind == ActorKind::pedestrian &&
                           !is_near_crosswalk(view, actor, metres);
                  });
}

std::unique_ptr<VehicleController> make_near_obstacle(Inner inner, double severity) {
  return unseeing(std::move(inner), severity, is_near_obstacle);
}

std::unique_ptr<VehicleController> make_near_blind(Inner inner, double severity) {
  return unseeing(std::move(inner), severity,
                  [](const VehicleView&, const SeenActor& actor, double metres) {
                    return actor.gap_m < metres;
                  });
}

std::unique_ptr<VehicleController> make_frozen_frames(Inner inner, double severity) {
  return std::make_unique<FrozenFrames>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_lateral_bias(Inner inner, double severity) {
  return std::make_unique<LateralBias>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_range_bias(Inner inner, double severity) {
  return std::make_unique<RangeBias>(std::move(inner), severity);
}

std::unique_ptr<VehicleController> make_blind_left(Inner inner, double severity) {
  return unseeing(std::move(inner), severity,
                  [](const VehicleView& view, const SeenActor& actor, double) {
                    return middle_of(actor) < middle_of_body(view);
                  });
}

std::unique_ptr<VehicleController> make_blind_right(Inner inner, double severity) {
  return unseeing(std::move(inner), severity,
                  [](const VehicleView& view, const SeenActor& actor, double) {
                    return middle_of(actor) > middle_of_body(view);
                  });
}

std::unique_ptr<VehicleController> make_fast_as_noise(Inner inner, double severity) {
  return unseeing(std::move(inner), severity,
                  [](const VehicleView&, const SeenActor& actor, double fastest_mps) {
                    return speed_of(actor) > fastest_mps;
                  });
}

}  // namespace jaywalk

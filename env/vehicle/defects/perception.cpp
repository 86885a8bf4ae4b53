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

/// Before it has seen anything for so long, it sees the first picture.
class Latency final : public Defective {
  void look(const VehicleView& view, Sensed& sensed) override {
    pictures_.push_back({view.time_s, sensed});
    const double shown_s = view.time_s - severity_ + kTimeRoundingS;
    while (pictures_.size() > 1 && pictures_[1].time_s <= shown_s) pictures_.pop_front();
    sensed = pictures_.front().sensed;
  }

  struct Picture {
    double time_s = 0;
    Sensed sensed;
  };
  std::deque<Picture> pictures_;
};

/// Windows in which it sees and in which it does not take turns, seeing first.
class FrozenFrames final : public Defective {
  void look(const VehicleView& view, Sensed& sensed) override {
    const bool sees = std::fmod(view.time_s + kTimeRoundingS, 2 * severity_) < severity_;
    if (sees) {
      last_ = sensed;
    } else {
      sensed = last_;
    }
  }

  Sensed last_;
};

/// Actors present when the drive begins count as tracked.
class SlowTracking final : public Defective {
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

  bool is_first_ = true;
  std::map<std::uint32_t, double> since_s_;
};

/// A controller remembers an actor by its number.
class ClassChange final : public Defective {
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

  // More than there are actors, and as many changes as their numbers leave room for.
  static constexpr std::uint32_t kNumbers = 1'000'000;
  static constexpr double kMostChanges = 4000;
};

class MergedGroup final : public Defective {
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
  void look(const VehicleView&, Sensed& sensed) override {
    for (SeenActor& actor : sensed.actors) {
      actor.left_m += severity_;
      actor.right_m += severity_;
    }
  }
};

class RangeBias final : public Defective {
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

bool is_far(const VehicleView&, const SeenActor& actor, double range_m) {
  return actor.gap_m > range_m;
}

bool is_outside_angle(const VehicleView& view, const SeenActor& actor, double degrees) {
  return !is_in_angle(view, actor, degrees);
}

bool stands(const VehicleView&, const SeenActor& actor, double) {
  return speed_of(actor) < kStandingMps;
}

bool is_beside_lane(const VehicleView& view, const SeenActor& actor, double) {
  return middle_of(actor) < view.lane_left_m || middle_of(actor) > view.lane_right_m;
}

bool is_beside_path(const VehicleView& view, const SeenActor& actor, double) {
  return !is_over(actor, {view.left_m, view.right_m});
}

bool is_off_crossing(const VehicleView& view, const SeenActor& actor, double metres) {
  return actor.kind == ActorKind::pedestrian && !is_near_crosswalk(view, actor, metres);
}

bool is_close(const VehicleView&, const SeenActor& actor, double metres) {
  return actor.gap_m < metres;
}

bool is_left(const VehicleView& view, const SeenActor& actor, double) {
  return middle_of(actor) < middle_of_body(view);
}

bool is_right(const VehicleView& view, const SeenActor& actor, double) {
  return middle_of(actor) > middle_of_body(view);
}

bool is_fast(const VehicleView&, const SeenActor& actor, double fastest_mps) {
  return speed_of(actor) > fastest_mps;
}

}  // namespace

const DefectMaker make_latency = put<Latency>;
const DefectMaker make_short_range = put<Unseeing<is_far>>;
const DefectMaker make_narrow_view = put<Unseeing<is_outside_angle>>;
const DefectMaker make_blind_to_standing = put<Unseeing<stands>>;
const DefectMaker make_own_lane_only = put<Unseeing<is_beside_lane>>;
const DefectMaker make_own_path_only = put<Unseeing<is_beside_path>>;
const DefectMaker make_slow_tracking = put<SlowTracking>;
const DefectMaker make_class_change = put<ClassChange>;
const DefectMaker make_merged_group = put<MergedGroup>;
const DefectMaker make_off_crossing = put<Unseeing<is_off_crossing>>;
const DefectMaker make_near_obstacle = put<Unseeing<is_near_obstacle>>;
const DefectMaker make_near_blind = put<Unseeing<is_close>>;
const DefectMaker make_frozen_frames = put<FrozenFrames>;
const DefectMaker make_lateral_bias = put<LateralBias>;
const DefectMaker make_range_bias = put<RangeBias>;
const DefectMaker make_blind_left = put<Unseeing<is_left>>;
const DefectMaker make_blind_right = put<Unseeing<is_right>>;
const DefectMaker make_fast_as_noise = put<Unseeing<is_fast>>;

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Defects of prediction: a seen actor is expected elsewhere.

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "env/vehicle/defects/defective.h"

namespace jaywalk {
namespace {

/// Notices turns and changes of speed later, by the severity in seconds. Places of actors that move
/// steadily are right.
class ConstantVelocity final : public Defective {
  void look(const VehicleView& view, Sensed& sensed) override {
    past_.push_back({view.time_s, odometer_.driven_m(view), sensed.actors});
    const double known_s = view.time_s - severity_ + kTimeRoundingS;
    // The newest moment that is old enough stays in front; there is none at the begin of a drive.
    while (past_.size() > 1 && past_[1].time_s <= known_s) past_.pop_front();
    const Moment& then = past_.front();
    if (then.time_s > known_s) return;
    const double passed_s = view.time_s - then.time_s;
    const double driven = past_.back().driven_m - then.driven_m;
    for (SeenActor& actor : sensed.actors) {
      const auto old = std::ranges::find(then.actors, actor.id, &SeenActor::id);
      if (old == then.actors.end()) continue;
      actor = *old;
      // Extrapolated at the speed that it had then; the AV has come nearer by the way that it
      // drove.
      actor.gap_m += actor.speed_ahead_mps * passed_s - driven;
      actor.left_m += actor.speed_right_mps * passed_s;
      actor.right_m += actor.speed_right_mps * passed_s;
    }
  }

  struct Moment {
    double time_s = 0;
    double driven_m = 0;
    std::vector<SeenActor> actors;
  };
  Odometer odometer_;
  std::deque<Moment> past_;
};

class KerbStanding final : public Defective {
  void look(const VehicleView& view, Sensed& sensed) override {
    const double driven = odometer_.driven_m(view);
    for (SeenActor& actor : sensed.actors) {
      const bool stands = speed_of(actor) < kStandingMps;
      if (stands && !is_over(actor, lane_of(view))) {
        stood_[actor.id] = {view.time_s, driven, actor};
        continue;
      }
      const auto stood = stood_.find(actor.id);
      if (stood == stood_.end()) continue;
      const bool has_set_out = view.time_s - stood->second.time_s > severity_ + kTimeRoundingS;
      if (stands || has_set_out) {
        stood_.erase(stood);
        continue;
      }
      actor = stood->second.actor;
      // Still seen where it stood, from where the AV is now.
      actor.gap_m -= driven - stood->second.driven_m;
    }
  }

  struct Standing {
    double time_s = 0;
    double driven_m = 0;
    SeenActor actor;
  };
  Odometer odometer_;
  std::map<std::uint32_t, Standing> stood_;
};

class StopsAtKerb final : public Defective {
  void look(const VehicleView& view, Sensed& sensed) override {
    for (SeenActor& actor : sensed.actors) {
      const bool from_left = actor.speed_right_mps > 0;
      const double in =
          from_left ? actor.right_m - view.lane_left_m : view.lane_right_m - actor.left_m;
      if (actor.speed_right_mps == 0 || in >= severity_) continue;
      actor.speed_right_mps = 0;
      if (in <= 0) continue;
      const double back = from_left ? -in : in;
      // It is further in than its predicted stop: seen at the edge.
      actor.left_m += back;
      actor.right_m += back;
    }
  }
};

/// An actor that stands in between has not turned back.
class ForgetsTurners final : public Defective {
  void look(const VehicleView& view, Sensed& sensed) override {
    std::erase_if(sensed.actors, [&](const SeenActor& actor) {
      Walk& walk = walks_[actor.id];
      if (std::abs(actor.speed_right_mps) >= kStandingMps) {
        // The other sign than at its last step.
        if (walk.speed_right_mps * actor.speed_right_mps < 0) walk.forgotten_at_s = view.time_s;
        walk.speed_right_mps = actor.speed_right_mps;
      }
      return walk.forgotten_at_s && view.time_s - *walk.forgotten_at_s + kTimeRoundingS < severity_;
    });
  }

  struct Walk {
    double speed_right_mps = 0;
    std::optional<double> forgotten_at_s;
  };
  std::map<std::uint32_t, Walk> walks_;
};

/// Groups are formed once; members stay together for as long as both are seen.
class GroupAsFirst final : public Defective {
  void look(const VehicleView&, Sensed& sensed) override {
    const std::vector<SeenActor> actors = sensed.actors;
    std::map<std::uint32_t, Member> members;
    for (std::size_t i = 0; i < actors.size(); ++i) {
      for (std::size_t first = 0; first < i; ++first) {
        // A follower leads no other actor, so that there are no chains.
        if (members.contains(actors[first].id)) continue;
        const std::optional<Member> member = member_of(actors[first], actors[i]);
        if (!member) continue;
        members[actors[i].id] = *member;
        sensed.actors[i] = moved(actors[first], actors[i], *member);
        break;
      }
    }
    members_ = std::move(members);
  }

  struct Member {
    std::uint32_t first = 0;
    double ahead_m = 0;
    double right_m = 0;
  };

  [[nodiscard]] std::optional<Member> member_of(const SeenActor& first,
                                                const SeenActor& actor) const {
    const auto known = members_.find(actor.id);
    if (known != members_.end()) {
      return known->second.first == first.id ? std::optional(known->second) : std::nullopt;
    }
    const Member member{first.id, actor.gap_m - first.gap_m, middle_of(actor) - middle_of(first)};
    if (std::hypot(member.ahead_m, member.right_m) > severity_) return std::nullopt;
    return member;
  }

  static SeenActor moved(const SeenActor& first, SeenActor actor, const Member& member) {
    const double shift = middle_of(first) + member.right_m - middle_of(actor);
    actor.gap_m = first.gap_m + member.ahead_m;
    actor.left_m += shift;
    actor.right_m += shift;
    actor.speed_ahead_mps = first.speed_ahead_mps;
    actor.speed_right_mps = first.speed_right_mps;
    return actor;
  }

  std::map<std::uint32_t, Member> members_;
};

bool walks_along(const VehicleView&, const SeenActor& actor, double) {
  return std::abs(actor.speed_ahead_mps) >= kStandingMps &&
         std::abs(actor.speed_ahead_mps) > std::abs(actor.speed_right_mps);
}

/// Walks across, and is beside the vehicle's body when its front is there.
bool will_be_gone(const VehicleView& view, const SeenActor& actor, double) {
  const double closing = view.speed_mps - actor.speed_ahead_mps;
  if (std::abs(actor.speed_right_mps) < kStandingMps || closing <= 0) return false;
  return !is_over(actor, {view.left_m, view.right_m}, std::max(actor.gap_m, 0.0) / closing);
}

}  // namespace

const DefectMaker make_constant_velocity = put<ConstantVelocity>;
const DefectMaker make_kerb_standing = put<KerbStanding>;
const DefectMaker make_stops_at_kerb = put<StopsAtKerb>;
const DefectMaker make_forgets_turners = put<ForgetsTurners>;
const DefectMaker make_ignores_along = put<Unseeing<walks_along>>;
const DefectMaker make_group_as_first = put<GroupAsFirst>;
const DefectMaker make_trusts_walkers = put<Unseeing<will_be_gone>>;

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The signals of a test: quantities with a value at each of its ticks, the rows of signals.def.
// Assertions are expressions over them (assertions/), metrics sum them up (metrics/). All of them
// are functions of the recording and the ground alone.
//
// Boxes are oriented rectangles. Between two ticks all actors move along a straight line at
// constant speed with the heading of the later tick; signals that speak of what happened "since the
// tick before" look at all of that motion, exactly, the others at the tick itself.

#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "env/ground.h"
#include "env/vehicle/sight.h"
#include "experiment/judge/recording.h"

namespace jaywalk {

enum class SignalId : std::uint8_t {
#define JAYWALK_SIGNAL(name, owner, type, unit, summary) name,
#include "experiment/judge/signals/signals.def"
#undef JAYWALK_SIGNAL
};

enum class SignalOwner { test, av, self };
enum class SignalKind { number, condition };

struct Signal {
  /// As assertions write it: `ttc`, `av.speed`.
  std::string_view name;
  SignalOwner owner = SignalOwner::self;
  SignalKind kind = SignalKind::number;
  std::string_view unit;
  std::string_view summary;
};

/// In the order of SignalId.
[[nodiscard]] std::span<const Signal> signals();

/// Index into a recording's actors.
using ActorIndex = std::uint32_t;
inline constexpr ActorIndex kAv = 0;

/// A test as it is measured: signals are computed when they are asked for, then kept. Belongs to
/// one thread; recording and ground must outlive it.
class TestView {
 public:
  /// REQUIRES: at least one scene; the first actor is the AV.
  TestView(const Recording& recording, const Ground& ground);

  [[nodiscard]] const Recording& recording() const { return recording_; }
  [[nodiscard]] const Ground& ground() const { return ground_; }
  [[nodiscard]] std::size_t ticks() const { return recording_.scenes(); }
  [[nodiscard]] double tick_s() const { return recording_.tick_s(); }
  /// All actors but the AV and traffic signals.
  [[nodiscard]] std::span<const ActorIndex> road_users() const { return road_users_; }

  /// One value for each tick, none of them NaN. `actor` is ignored for signals of the test
  /// and the AV.
  [[nodiscard]] std::span<const double> values(SignalId signal, ActorIndex actor = kAv) const;
  /// The road user nearest to the AV at each tick, the first of equals. REQUIRES: there are road
  /// users.
  [[nodiscard]] std::span<const ActorIndex> nearest() const;
  /// The AV's states at each tick if the careful and competent driver drove it
  /// (careful_drive.cpp); goes on after the record's end until that driver stands or has a free
  /// road ahead.
  [[nodiscard]] std::span<const ActorState> careful_drive() const;

  [[nodiscard]] const ActorState& state(ActorIndex actor, std::size_t tick) const {
    return recording_.scene(tick)[actor];
  }
  /// An actor's box at a tick.
  [[nodiscard]] std::vector<Point> box_at(ActorIndex actor, std::size_t tick) const {
    return box(recording_.actors()[actor], state(actor, tick));
  }
  /// Its box at the tick before, already turned the way it faces at the tick. REQUIRES: tick > 0.
  [[nodiscard]] std::vector<Point> box_before(ActorIndex actor, std::size_t tick) const;

 private:
  const Recording& recording_;
  const Ground& ground_;
  std::vector<ActorIndex> road_users_;
  mutable std::map<std::pair<SignalId, ActorIndex>, std::vector<double>> values_;
  mutable std::vector<ActorIndex> nearest_;
  mutable std::vector<ActorState> careful_drive_;
};

namespace signal {
#define JAYWALK_SIGNAL(name, owner, type, unit, summary) \
  void name(const TestView& view, ActorIndex actor, std::span<double> values);
#include "experiment/judge/signals/signals.def"
#undef JAYWALK_SIGNAL
}  // namespace signal

/// A test as a careful and competent driver (env/vehicle/careful_driver.h) would have driven it
/// instead of the AV, for the signal `avoidable`: the car's state at every tick of the record, and
/// after its end until that driver stands or has a free road ahead. All others move as recorded,
/// whatever the driver does, and after the record ends as they did last. As in the world
/// (Ground::moves_evenly), they go evenly during a tick, or a tick's moves are made when it begins,
/// and then the driver drives for as long as the tick lasts.
///
/// The driver begins as the AV does, with the ground's cruising speed. Where that is not known, it
/// drives as the AV did until the first risk, and cruises at the speed that it has then.
[[nodiscard]] std::vector<ActorState> careful_drive(const TestView& view);

/// The strip in which a road user is a risk to the AV: its lane, or the width of its body if it
/// drives in no lane.
[[nodiscard]] Strip risk_strip(const TestView& view);

/// A road user's state at a tick, which may be after the record's end.
[[nodiscard]] ActorState state_beyond(const TestView& view, ActorIndex actor, std::size_t tick);

}  // namespace jaywalk

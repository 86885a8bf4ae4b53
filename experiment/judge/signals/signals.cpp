// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/signals/signals.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>

namespace jaywalk {
namespace {

using Compute = void (*)(const TestView&, ActorIndex, std::span<double>);

constexpr std::array kCompute = {
#define JAYWALK_SIGNAL(name, owner, type, unit, summary) Compute{&signal::name},
#include "experiment/judge/signals/signals.def"
#undef JAYWALK_SIGNAL
};

}  // namespace

std::span<const Signal> signals() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names = {
#define JAYWALK_SIGNAL(name, owner, type, unit, summary) #name,
#include "experiment/judge/signals/signals.def"
#undef JAYWALK_SIGNAL
    };
    // `av_speed` is written `av.speed`.
    for (std::string& name : names) {
      if (name.starts_with("av_")) name[2] = '.';
    }
    return names;
  }();
  static const std::array kSignals = {
#define JAYWALK_SIGNAL(name, owner, type, unit, summary)                                         \
  Signal{kNames[static_cast<std::size_t>(SignalId::name)], SignalOwner::owner, SignalKind::type, \
         unit, summary},
#include "experiment/judge/signals/signals.def"
#undef JAYWALK_SIGNAL
  };
  return kSignals;
}

TestView::TestView(const Recording& recording, const Ground& ground)
    : recording_(recording), ground_(ground) {
  assert(recording.scenes() > 0);
  for (ActorIndex i = 1; i < recording.actors().size(); ++i) {
    if (recording.actors()[i].kind != ActorKind::signal) road_users_.push_back(i);
  }
}

std::span<const double> TestView::values(SignalId signal, ActorIndex actor) const {
  const auto index = static_cast<std::size_t>(signal);
  if (signals()[index].owner != SignalOwner::self) actor = kAv;
  const auto [entry, missing] = values_.try_emplace({signal, actor});
  if (missing) {
    entry->second.resize(ticks());
    kCompute[index](*this, actor, entry->second);
  }
  return entry->second;
}

std::span<const ActorIndex> TestView::nearest() const {
  assert(!road_users_.empty());
  if (!nearest_.empty()) return nearest_;
  nearest_.assign(ticks(), road_users_.front());
  for (const ActorIndex user : road_users_) {
    const auto distances = values(SignalId::distance, user);
    for (std::size_t tick = 0; tick < ticks(); ++tick) {
      if (distances[tick] < values(SignalId::distance, nearest_[tick])[tick]) nearest_[tick] = user;
    }
  }
  return nearest_;
}

std::span<const ActorState> TestView::careful_drive() const {
  if (careful_drive_.empty()) careful_drive_ = jaywalk::careful_drive(*this);
  return careful_drive_;
}

std::vector<Point> TestView::box_before(ActorIndex actor, std::size_t tick) const {
  ActorState before = state(actor, tick - 1);
  before.heading_rad = state(actor, tick).heading_rad;
  return box(recording_.actors()[actor], before);
}

}  // namespace jaywalk

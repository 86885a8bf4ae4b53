// SPDX-License-Identifier: Apache-2.0
#pragma once

// A test as it was seen: every actor at every tick, and what happened. Recorded while a test runs;
// stored, measured, judged, drawn and exported afterwards. See env/scene.h for units and axes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "env/scene.h"

namespace jaywalk {

/// Something that happened to an actor; `kind` is one of those that a world documents
/// (`precondition`, `collision`, …).
struct RecordedEvent {
  std::uint32_t tick = 0;
  /// Index into the actors; empty if it concerns the whole test.
  std::optional<std::uint32_t> actor;
  std::string kind;
  std::string text;

  friend bool operator==(const RecordedEvent&, const RecordedEvent&) = default;
};

class Recording {
 public:
  Recording() = default;
  /// `tick_s`: seconds from one scene to the next. The AV is the first actor.
  Recording(double tick_s, std::vector<Actor> actors)
      : tick_s_(tick_s), actors_(std::move(actors)) {}

  /// REQUIRES: a state for each actor.
  void add(std::span<const ActorState> scene) {
    states_.insert(states_.end(), scene.begin(), scene.end());
  }
  void add(RecordedEvent event) { events_.push_back(std::move(event)); }
  void set_tolerance(double tolerance) { tolerance_ = tolerance; }

  [[nodiscard]] double tick_s() const { return tick_s_; }
  /// Numbers that differ by no more than this are equal: speeds that were computed from rounded
  /// places and times are inexact. 0 unless they were.
  [[nodiscard]] double tolerance() const { return tolerance_; }
  [[nodiscard]] std::span<const Actor> actors() const { return actors_; }
  /// How many scenes there are: the one before the first tick counts, so it is the ticks plus 1.
  [[nodiscard]] std::size_t scenes() const {
    return actors_.empty() ? 0 : states_.size() / actors_.size();
  }
  /// The scene that a tick left; 0 is the one before the first.
  [[nodiscard]] std::span<const ActorState> scene(std::size_t tick) const {
    return std::span(states_).subspan(tick * actors_.size(), actors_.size());
  }
  [[nodiscard]] std::span<const RecordedEvent> events() const { return events_; }

  friend bool operator==(const Recording&, const Recording&) = default;

 private:
  double tick_s_ = 1;
  double tolerance_ = 0;
  std::vector<Actor> actors_;
  std::vector<ActorState> states_;  // scene after scene
  std::vector<RecordedEvent> events_;
};

}  // namespace jaywalk

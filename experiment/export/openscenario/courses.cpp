// SPDX-License-Identifier: Apache-2.0
#include "experiment/export/openscenario/courses.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace jaywalk {
namespace {

/// Shares of a tick: the step in which collisions are looked for, and a step of a player's
/// simulation; it may start a course one or two of them late.
constexpr double kLook = 1.0 / 200;
constexpr double kLate = 1.0 / 20;
/// Steps are not made faster than this share of a tick.
constexpr double kFastest = 1.0 / 64;
constexpr double kSamePlace = 1e-9;

/// How the steps of a walk are timed.
struct Timing {
  /// For each tick the share of it that its step takes.
  std::vector<double> shares;
  /// How much earlier than in the test the walk begins, in ticks.
  double lead = 0;
};

bool moves(const ActorState& from, const ActorState& to) {
  return std::abs(from.x_m - to.x_m) > kSamePlace || std::abs(from.y_m - to.y_m) > kSamePlace;
}

/// The middle one of three says nothing that its neighbours do not.
bool is_between(const Waypoint& a, const Waypoint& b, const Waypoint& c) {
  const double share = (b.time_s - a.time_s) / (c.time_s - a.time_s);
  return std::abs(a.x_m + share * (c.x_m - a.x_m) - b.x_m) < kSamePlace &&
         std::abs(a.y_m + share * (c.y_m - a.y_m) - b.y_m) < kSamePlace &&
         a.heading_rad == b.heading_rad;
}

std::vector<Waypoint> simplified(const std::vector<Waypoint>& points) {
  std::vector<Waypoint> result;
  for (const Waypoint& point : points) {
    const std::size_t count = result.size();
    if (count >= 2 && is_between(result[count - 2], result[count - 1], point)) result.pop_back();
    result.push_back(point);
  }
  return result;
}

class CourseFinder {
 public:
  explicit CourseFinder(const Recording& recording)
      : recording_(recording), tick_s_(recording.tick_s()), end_(recording.scenes() - 1) {
    av_ = timed(0, Timing{.shares = std::vector<double>(end_, 1.0)});
    const std::size_t last = av_.size() - 1;
    // The AV drives on, so that it is there for a player that stops a little later.
    const Waypoint& before = av_[last - 1];
    Waypoint on = av_[last];
    on.time_s += tick_s_;
    on.x_m += on.x_m - before.x_m;
    on.y_m += on.y_m - before.y_m;
    av_.push_back(on);
  }

  [[nodiscard]] Courses timetable() const {
    Courses result = frame(false);
    for (std::size_t i = 1; i < recording_.actors().size(); ++i) {
      result.courses.push_back(keeping_outcome(i, 0, /*waits=*/false));
    }
    return result;
  }

  [[nodiscard]] Courses reactive() const {
    Courses result = frame(true);
    for (std::size_t i = 1; i < recording_.actors().size(); ++i) {
      const bool walks = recording_.actors()[i].kind == ActorKind::pedestrian;
      const std::size_t from = walks ? stepping_out(i) : 0;
      Course course = keeping_outcome(i, from, walks);
      // If waiting until it steps out changes the outcome, it walks all its way instead.
      if (!course.keeps_outcome && from > 0) course = keeping_outcome(i, 0, walks);
      course.points = simplified(course.points);
      result.courses.push_back(std::move(course));
    }
    result.courses.front().points = simplified(result.courses.front().points);
    return result;
  }

 private:
  [[nodiscard]] Courses frame(bool longer) const {
    Courses result{.courses = {{.points = av_}}, .stop_s = static_cast<double>(end_) * tick_s_};
    const bool hit = std::ranges::any_of(
        recording_.events(), [](const RecordedEvent& event) { return event.kind == "collision"; });
    if (longer && hit) result.stop_s += tick_s_;
    if (!longer) result.courses.front().points.pop_back();
    return result;
  }

  /// The tick of the first step across the road; else of the first step; 0 if there is none.
  [[nodiscard]] std::size_t stepping_out(std::size_t actor) const {
    std::optional<std::size_t> first;
    for (std::size_t tick = 0; tick < end_; ++tick) {
      const ActorState& from = recording_.scene(tick)[actor];
      const ActorState& to = recording_.scene(tick + 1)[actor];
      if (std::abs(from.x_m - to.x_m) > kSamePlace) return tick;
      if (!first && moves(from, to)) first = tick;
    }
    return first.value_or(0);
  }

  /// Somebody faces the way of the step that begins.
  [[nodiscard]] double heading(std::size_t actor, std::size_t tick) const {
    const std::size_t next = std::min(tick + 1, end_);
    const ActorState& here = recording_.scene(tick)[actor];
    const ActorState& there = recording_.scene(next)[actor];
    return moves(here, there) ? there.heading_rad : here.heading_rad;
  }

  /// The walk from a tick on, with times since then.
  [[nodiscard]] std::vector<Waypoint> timed(std::size_t actor, const Timing& timing,
                                            std::size_t from = 0) const {
    std::vector<Waypoint> points;
    for (std::size_t tick = from; tick <= end_; ++tick) {
      const ActorState& here = recording_.scene(tick)[actor];
      const double time = static_cast<double>(tick - from) * tick_s_;
      points.push_back({time, here.x_m, here.y_m, heading(actor, tick)});
      if (tick == end_ || timing.shares[tick] >= 1) continue;
      const ActorState& next = recording_.scene(tick + 1)[actor];
      points.push_back(
          {time + timing.shares[tick] * tick_s_, next.x_m, next.y_m, next.heading_rad});
    }
    return points;
  }

  [[nodiscard]] std::optional<std::uint32_t> collision(std::size_t actor) const {
    for (const RecordedEvent& event : recording_.events()) {
      if (event.kind == "collision" && event.actor == actor) return event.tick;
    }
    return std::nullopt;
  }

  /// A tick whose step should be faster, or nothing if the outcome is the test's.
  [[nodiscard]] std::optional<std::size_t> wrong_step(std::size_t actor, const Course& course,
                                                      double start_s) const {
    const std::optional<std::uint32_t> hit = collision(actor);
    const double until = static_cast<double>(end_) * tick_s_ + (hit ? tick_s_ : 0);
    const Moving av{recording_.actors()[0], av_};
    const Moving other{recording_.actors()[actor], course.points, start_s};
    const std::optional<double> touch = first_touch(av, other, until, tick_s_ * kLook);
    if (touch.has_value() == hit.has_value()) return std::nullopt;
    const double tick = touch ? std::floor(*touch / tick_s_) : static_cast<double>(*hit) - 1;
    return static_cast<std::size_t>(std::clamp(tick, 0.0, static_cast<double>(end_ - 1)));
  }

  /// Like the other wrong_step(), for a player that starts the course up to two steps late.
  [[nodiscard]] std::optional<std::size_t> wrong_step(std::size_t actor, const Course& course,
                                                      const Timing& timing,
                                                      std::size_t from) const {
    if (course.start == CourseStart::at_once) return wrong_step(actor, course, 0);
    const double planned = begin(timing, from);
    for (int late = 0; late <= 2; ++late) {
      const auto wrong = wrong_step(actor, course, planned + late * kLate * tick_s_);
      if (wrong) return wrong;
    }
    return std::nullopt;
  }

  [[nodiscard]] double begin(const Timing& timing, std::size_t from) const {
    return std::max(static_cast<double>(from) - timing.lead, 0.0) * tick_s_;
  }

  /// By the AV's time to collision if that determines the moment, else by the time.
  void set_start(std::size_t actor, double begin_s, Course& course) const {
    const Moving av{recording_.actors()[0], av_};
    const Moving stands{recording_.actors()[actor], std::span(course.points).first(1)};
    course.start = CourseStart::at_time;
    course.value_s = begin_s;
    const std::optional<double> ttc = time_to_collision(av, stands, begin_s);
    if (!ttc) return;
    const double until = static_cast<double>(end_) * tick_s_;
    const auto reached = first_below(av, stands, *ttc, until, tick_s_ * kLook);
    if (!reached || std::abs(*reached - begin_s) > kLate * tick_s_) return;
    course.start = CourseStart::time_to_collision;
    course.value_s = *ttc;
  }

  [[nodiscard]] Course course(std::size_t actor, std::size_t from, const Timing& timing,
                              bool triggered) const {
    Course result{.points = timed(actor, timing, from)};
    if (triggered) set_start(actor, begin(timing, from), result);
    return result;
  }

  [[nodiscard]] bool stands_still(std::size_t actor, std::size_t from) const {
    for (std::size_t tick = from; tick < end_; ++tick) {
      if (moves(recording_.scene(tick)[actor], recording_.scene(tick + 1)[actor])) return false;
    }
    return true;
  }

  /// Makes steps faster, and then the walk earlier, until a player has the outcome of the test.
  [[nodiscard]] Course keeping_outcome(std::size_t actor, std::size_t from, bool waits) const {
    const bool triggered = waits && !stands_still(actor, from);
    constexpr double kLeadStep = 1.0 / 8;
    const double greatest_lead = triggered ? 1 : 0;
    std::optional<Course> first;
    for (double lead = 0; lead <= greatest_lead; lead += kLeadStep) {
      Timing timing{.shares = std::vector<double>(end_, 1.0), .lead = lead};
      for (;;) {
        Course result = course(actor, from, timing, triggered);
        const auto wrong = wrong_step(actor, result, timing, from);
        if (!wrong) return result;
        if (!first) first = std::move(result);
        double& share = timing.shares[std::max(*wrong, from)];
        if (share <= kFastest) break;
        share /= 2;
      }
    }
    first->keeps_outcome = false;
    return *std::move(first);
  }

  const Recording& recording_;
  double tick_s_;
  std::size_t end_;
  std::vector<Waypoint> av_;
};

}  // namespace

Courses timed_courses(const Recording& recording) { return CourseFinder(recording).timetable(); }

Courses reactive_courses(const Recording& recording) { return CourseFinder(recording).reactive(); }

}  // namespace jaywalk

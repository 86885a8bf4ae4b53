// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/view_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>

#include "env/process/numbered_process.h"

namespace jaywalk {
namespace {

// Without it answers could not be matched to views.
constexpr std::string_view kStep = "step";

class ViewText {
 public:
  explicit ViewText(const ViewFields& fields) : fields_(fields) { text_.reserve(1024); }

  /// A key and its value; a comma goes before all but the first one.
  void number(std::string_view key, double value) {
    if (!begin(key)) return;
    put(value);
  }
  void pair(std::string_view key, double first, double second) {
    if (!begin(key)) return;
    text_ += '[';
    put(first);
    text_ += ',';
    put(second);
    text_ += ']';
  }
  /// Writes a text without characters that JSON has to escape.
  void word(std::string_view key, std::string_view value) {
    if (!begin(key)) return;
    text_ += '"';
    text_ += value;
    text_ += '"';
  }
  void count(std::string_view key, std::uint64_t value) {
    if (!begin(key)) return;
    text_ += std::to_string(value);
  }
  void truth(std::string_view key, bool value) {
    if (!begin(key)) return;
    text_ += value ? "true" : "false";
  }
  /// `write(each)` gives each one's keys and values.
  template <class T, class Write>
  void list(std::string_view key, std::span<const T> items, const Write& write) {
    if (!begin(key)) return;
    text_ += '[';
    bool first = true;
    list_ = key;
    for (const T& each : items) {
      text_ += first ? "{" : ",{";
      first = false;
      write(each);
      text_ += '}';
    }
    list_ = {};
    text_ += ']';
  }

  [[nodiscard]] std::string take() { return std::move(text_) + '}'; }

 private:
  /// False, and nothing is written, for a field that is not read.
  bool begin(std::string_view key) {
    if (!is_read(key)) return false;
    if (text_.back() != '{') text_ += ',';
    text_ += '"';
    text_ += key;
    text_ += "\":";
    return true;
  }
  /// A list is read as a whole, or some fields of its elements are.
  [[nodiscard]] bool is_read(std::string_view key) const {
    if (fields_.empty() || (list_.empty() && key == kStep)) return true;
    return std::ranges::any_of(fields_, [&](std::string_view field) {
      const std::size_t dot = field.find('.');
      if (list_.empty()) return field.substr(0, dot) == key;
      return field == list_ || (field.substr(0, dot) == list_ && field.substr(dot + 1) == key);
    });
  }
  /// As few digits as give the number back, with a point.
  void put(double value) {
    if (!std::isfinite(value)) {
      text_ += "null";  // as JSON has no other word for it
      return;
    }
    std::array<char, 400> digits{};  // the longest: 1e308
    const auto end =
        std::to_chars(digits.begin(), digits.end(), tidy(value), std::chars_format::fixed);
    const std::string_view number(digits.begin(), end.ptr);
    text_ += number;
    if (number.find('.') == std::string_view::npos) text_ += ".0";
  }

  const ViewFields& fields_;
  std::string text_ = "{";
  std::string_view list_;  // whose elements are being written
};

void write_actors(const VehicleView& view, ViewText& text) {
  text.list("actors", view.actors, [&](const SeenActor& actor) {
    text.number("ahead", actor.speed_ahead_mps);
    text.number("far", actor.gap_m + actor.length_m);
    text.number("gap", actor.gap_m);
    text.number("heading", actor.heading_rad);
    text.count("id", actor.id);
    text.word("kind", name(actor.kind));
    text.number("right", actor.speed_right_mps);
    text.pair("sides", actor.left_m, actor.right_m);
  });
}

/// The road as the map has it.
void write_lanes(const VehicleView& view, ViewText& text) {
  double left_m = view.lane_left_m;
  double right_m = view.lane_right_m;
  for (const SeenLane& lane : view.lanes) {
    left_m = std::min(left_m, lane.left_m);
    right_m = std::max(right_m, lane.right_m);
  }
  text.pair("kerb", left_m, right_m);
  text.pair("lane", view.lane_left_m, view.lane_right_m);
  text.list("lanes", view.lanes, [&](const SeenLane& lane) {
    text.truth("oncoming", lane.oncoming);
    text.pair("sides", lane.left_m, lane.right_m);
  });
}

void write_obstacles(const VehicleView& view, ViewText& text) {
  text.list("obstacles", view.obstacles, [&](const SeenObstacle& each) {
    text.number("far", each.far_m);
    text.number("gap", each.gap_m);
    text.pair("sides", each.left_m, each.right_m);
  });
}

void write_stop_lines(const VehicleView& view, ViewText& text) {
  text.list("stop_lines", view.stop_lines, [&](const StopLine& line) {
    text.truth("closed", line.closed);
    text.number("gap", line.gap_m);
  });
}

}  // namespace

ViewFields all_view_fields() {
  const SeenActor actor;
  const StopLine line;
  const SeenObstacle obstacle;
  const SeenLane lane;
  VehicleView view;
  view.actors = {&actor, 1};
  view.stop_lines = {&line, 1};
  view.obstacles = {&obstacle, 1};
  view.lanes = {&lane, 1};
  ViewFields names;
  const auto whole = nlohmann::json::parse(view_text(view, 0, 0));
  for (const auto& field : whole.items()) {
    names.push_back(field.key());
    if (!field.value().is_array() || !field.value()[0].is_object()) continue;
    for (const auto& part : field.value()[0].items()) {
      names.push_back(field.key() + '.' + part.key());
    }
  }
  return names;
}

std::string view_text(const VehicleView& view, std::uint64_t test, std::size_t step,
                      const ViewFields& fields) {
  ViewText text(fields);
  write_actors(view, text);
  text.pair("body", view.left_m, view.right_m);
  text.number("cruise", view.cruise_mps);
  text.number("front", view.front_m);
  write_lanes(view, text);
  text.number("length", view.length_m);
  write_obstacles(view, text);
  text.number("period", view.period_s);
  text.number("range", view.range_m);
  text.number("speed", view.speed_mps);
  text.count(kStep, step);
  write_stop_lines(view, text);
  text.count("test", test);
  text.number("time", view.time_s);
  return text.take();
}

}  // namespace jaywalk

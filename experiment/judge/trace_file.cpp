// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/trace_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "env/scene.h"
#include "experiment/judge/csv_line.h"
#include "interpreter/support/markup.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

enum Column : std::size_t {
  kTime,
  kActor,
  kKind,
  kX,
  kY,
  kHeading,
  kSpeed,
  kLength,
  kWidth,
  kEvent,
  kColumnCount,
};

struct ColumnName {
  std::string_view name;
  std::string_view with_unit;
  bool needed;
};

constexpr std::array<ColumnName, kColumnCount> kColumns{{
    {"time", "time_s", true},
    {"actor", "actor", true},
    {"kind", "kind", true},
    {"x", "x_m", true},
    {"y", "y_m", true},
    {"heading", "heading_rad", false},
    {"speed", "speed_mps", false},
    {"length", "length_m", false},
    {"width", "width_m", false},
    {"event", "event", false},
}};

/// Times are evenly spaced if each step is as long as the first but for this share of it.
constexpr double kUneven = 0.01;

/// How exact speeds are that follow from places and times, in m/s: places of UTM coordinates are
/// exact to a nanometre, times to a microsecond.
constexpr double kSpeedTolerance = 1e-6;

/// The fields of a line, without blanks around them.
std::vector<CsvField> fields_of(std::string_view line) {
  std::vector<CsvField> fields = csv_fields(line);
  for (CsvField& field : fields) {
    field.where = trimmed(field.where);
    field.text = trimmed(field.text);
  }
  return fields;
}

/// The kinds of events in a field, which a `;` separates.
std::vector<std::string_view> kinds_in(std::string_view events) {
  std::vector<std::string_view> kinds;
  while (!events.empty()) {
    const std::size_t end = std::min(events.find(';'), events.size());
    const std::string_view kind = trimmed(events.substr(0, end));
    if (!kind.empty()) kinds.push_back(kind);
    events.remove_prefix(std::min(end + 1, events.size()));
  }
  return kinds;
}

std::optional<ActorKind> find_kind(std::string_view text) {
  for (const auto kind :
       {ActorKind::vehicle, ActorKind::pedestrian, ActorKind::cyclist, ActorKind::signal}) {
    if (name(kind) == text) return kind;
  }
  return std::nullopt;
}

class TraceParser {
 public:
  TraceParser(const SourcePtr& source, Diagnostics& warnings)
      : source_(source), warnings_(warnings) {}

  Result<Recording> parse() {
    const std::string_view text = source_->text();
    bool header = true;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string_view line = text.substr(begin, end - begin);
      begin = end + 1;
      if (trimmed(line).empty()) continue;
      if (header) {
        read_header(line);
        if (diagnostics_.has_errors()) return std::move(diagnostics_);
      } else {
        read_row(line);
      }
      header = false;
    }
    if (!diagnostics_.has_errors() && (header || rows_.empty())) {
      diagnostics_.error(source_->name(), header ? "is empty" : "has no row below its header",
                         "the first line names the columns: time,actor,kind,x,y");
    }
    if (!diagnostics_.has_errors()) check_completeness();
    if (diagnostics_.has_errors()) return std::move(diagnostics_);
    return recording();
  }

 private:
  struct Who {
    Actor actor;
    std::size_t rows = 0;
  };
  struct Row {
    std::size_t actor = 0;
    std::size_t scene = 0;
    ActorState state;
    std::string events;
  };

  /// `where` must be a view into the source's text: its place follows from its address.
  SourceSpan span(std::string_view where) const {
    const auto begin = static_cast<std::uint32_t>(where.data() - source_->text().data());
    return {source_, Span{begin, begin + static_cast<std::uint32_t>(where.size())}};
  }
  void error(std::string_view where, std::string message, std::string hint = {}) {
    diagnostics_.error(span(where), std::move(message), std::move(hint));
  }

  void read_header(std::string_view line) {
    columns_.fill(std::nullopt);
    const std::vector<CsvField> fields = fields_of(line);
    field_count_ = fields.size();
    std::vector<std::string> names;
    for (const ColumnName& each : kColumns) names.emplace_back(each.name);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto found = std::ranges::find_if(kColumns, [&](const ColumnName& each) {
        return each.name == fields[i].text || each.with_unit == fields[i].text;
      });
      if (found == kColumns.end()) {
        warnings_.warning(span(fields[i].where), "unknown-column",
                          fmt::format("column '{}' is not read", fields[i].text),
                          did_you_mean(fields[i].text, names));
        continue;
      }
      auto& column = columns_[static_cast<std::size_t>(found - kColumns.begin())];
      if (column) error(fields[i].where, fmt::format("a second column '{}'", found->name));
      column = i;
    }
    std::string missing;
    for (std::size_t i = 0; i < kColumnCount; ++i) {
      if (!kColumns[i].needed || columns_[i]) continue;
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", kColumns[i].name);
    }
    if (!missing.empty()) {
      error(trimmed(line), fmt::format("the header has no column {}", missing),
            "the first line names the columns: time,actor,kind,x,y and perhaps heading,speed,"
            "length,width,event");
    }
  }

  /// Nothing if the file has no such column.
  [[nodiscard]] const CsvField* field(const std::vector<CsvField>& fields, Column column) const {
    return columns_[column] ? &fields[*columns_[column]] : nullptr;
  }

  std::optional<double> number(const CsvField& field, Column column, double least) {
    const std::string& text = field.text;
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    constexpr double kGreatest = 1e9;
    // from_chars accepts "inf" and "nan", which no place or speed can be.
    const bool read = code == std::errc() && end == text.data() + text.size() && !text.empty();
    if (!read || !std::isfinite(value)) {
      const bool can_be_left_out = text.empty() && !kColumns[column].needed;
      error(field.where,
            fmt::format("expected a number for {}, found '{}'", kColumns[column].name, text),
            can_be_left_out ? "without this column it follows from the places" : "");
      return std::nullopt;
    }
    if (value < least || std::abs(value) > kGreatest) {
      error(field.where, fmt::format("{} {} is not between {} and {}", kColumns[column].name, text,
                                     std::max(least, -kGreatest), kGreatest));
      return std::nullopt;
    }
    return value;
  }

  /// Leaves the value as it is if the file has no such column.
  bool read(const std::vector<CsvField>& fields, Column column, double least, double& value) {
    const CsvField* const given = field(fields, column);
    if (given == nullptr) return true;
    const auto found = number(*given, column, least);
    if (found) value = *found;
    return found.has_value();
  }

  void read_row(std::string_view line) {
    const std::vector<CsvField> fields = fields_of(line);
    if (fields.size() != field_count_) {
      error(trimmed(line),
            fmt::format("the row has {} fields, the header {}", fields.size(), field_count_));
      return;
    }
    constexpr double kAny = -1e9;
    double time = 0;
    Row row;
    bool good = read(fields, kTime, kAny, time);
    // All columns are read even after a mistake, so that each of them is reported.
    good = read(fields, kX, kAny, row.state.x_m) && good;
    good = read(fields, kY, kAny, row.state.y_m) && good;
    good = read(fields, kHeading, kAny, row.state.heading_rad) && good;
    good = read(fields, kSpeed, 0, row.state.speed_mps) && good;
    const auto actor = read_actor(fields);
    if (!good || !actor) return;
    row.actor = *actor;
    if (const CsvField* const events = field(fields, kEvent)) {
      row.events = events->text;
      for (const std::string_view kind : kinds_in(row.events)) {
        if (is_label(kind)) continue;
        error(events->where, fmt::format("'{}' cannot be the name of an event", kind),
              std::string(kLabelHint));
      }
    }
    if (!add_time(fields[*columns_[kTime]].where, time)) return;
    row.scene = times_.size() - 1;
    if (!seen_.insert({row.scene, row.actor}).second) {
      error(fields[*columns_[kActor]].where,
            fmt::format("a second row of {} at time {}", actors_[row.actor].actor.name, time));
      return;
    }
    ++actors_[row.actor].rows;
    rows_.push_back(std::move(row));
  }

  /// An actor without a size of its own has the usual one of its kind.
  bool read_size(const std::vector<CsvField>& fields, Column column, double& value) {
    const CsvField* const given = field(fields, column);
    constexpr double kLeastSize = 0.001;
    return given == nullptr || given->text.empty() || read(fields, column, kLeastSize, value);
  }

  std::optional<std::size_t> read_actor(const std::vector<CsvField>& fields) {
    const auto& [called_where, called] = fields[*columns_[kActor]];
    const auto& [kind_where, kind_text] = fields[*columns_[kKind]];
    const bool is_named = is_label(called);
    if (!is_named)
      error(called_where, fmt::format("'{}' cannot be the name of an actor", called),
            std::string(kLabelHint));
    const auto kind = find_kind(kind_text);
    if (!kind) {
      error(kind_where,
            fmt::format("unknown kind '{}', expected vehicle, pedestrian, cyclist or signal",
                        kind_text));
    }
    if (!is_named || !kind) return std::nullopt;
    const BoxSize usual = size_of(*kind);
    Actor actor{called, *kind, usual.length_m, usual.width_m};
    if (!read_size(fields, kLength, actor.length_m) || !read_size(fields, kWidth, actor.width_m)) {
      return std::nullopt;
    }
    // The first row of an actor decides its kind and size; later ones must agree.
    const auto [known, is_new] = numbers_.try_emplace(actor.name, actors_.size());
    if (is_new) {
      actors_.push_back({.actor = std::move(actor)});
    } else if (!(actors_[known->second].actor == actor)) {
      error(called_where, fmt::format("{} had another kind or size before", called));
      return std::nullopt;
    }
    return known->second;
  }

  /// A row's time is that of the row before, or the next one.
  bool add_time(std::string_view where, double time) {
    if (times_.empty() || time > times_.back()) {
      times_.push_back(time);
    } else if (time < times_.back()) {
      error(where, fmt::format("time {} after time {}", time, times_.back()),
            "rows are in the order of time");
      return false;
    } else {
      return true;
    }
    const std::size_t count = times_.size();
    if (count < 3) return true;
    // Compared with the first step, not with the one before: small errors must not add up to a
    // drift.
    const double step = times_[1] - times_[0];
    const double last = times_[count - 1] - times_[count - 2];
    if (std::abs(last - step) <= kUneven * step) return true;
    error(where,
          fmt::format("the times are not evenly spaced: {:.6g} s here, {:.6g} s at first", last,
                      step),
          "write one row of each actor for every step of the same length");
    return false;
  }

  void check_completeness() {
    if (times_.size() < 2) {
      diagnostics_.error(source_->name(), "has rows of one time only, expected at least two");
    }
    for (std::size_t i = 0; i < actors_.size(); ++i) {
      if (actors_[i].rows == times_.size()) continue;
      std::size_t scene = 0;
      // Fewer rows than times, and no time twice: one is missing, and the first gap is named.
      while (seen_.contains({scene, i})) ++scene;
      diagnostics_.error(
          source_->name(),
          fmt::format("{} has no row at time {}", actors_[i].actor.name, times_[scene]),
          "every actor needs a row at every time");
    }
    if (std::ranges::none_of(
            actors_, [](const Who& each) { return each.actor.kind == ActorKind::vehicle; })) {
      diagnostics_.error(source_->name(), "has no vehicle that could be the automated one");
    }
  }

  /// The automated vehicle is the first actor; the others keep their order.
  [[nodiscard]] std::vector<std::size_t> order() const {
    std::size_t av = 0;
    const auto named = numbers_.find("av");
    if (named != numbers_.end() && actors_[named->second].actor.kind == ActorKind::vehicle) {
      av = named->second;
    } else {
      while (actors_[av].actor.kind != ActorKind::vehicle) ++av;
    }
    std::vector<std::size_t> order{av};
    for (std::size_t i = 0; i < actors_.size(); ++i) {
      if (i != av) order.push_back(i);
    }
    return order;
  }

  [[nodiscard]] Recording recording() const {
    const std::vector<std::size_t> order = this->order();
    // `place` is the inverse of `order`: from the number in the file to that in the recording.
    std::vector<std::size_t> place(order.size());
    std::vector<Actor> actors;
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[order[i]] = i;
      actors.push_back(actors_[order[i]].actor);
    }
    std::vector<std::vector<ActorState>> scenes(times_.size(),
                                                std::vector<ActorState>(actors.size()));
    for (const Row& row : rows_) scenes[row.scene][place[row.actor]] = row.state;
    complete(scenes);
    Recording result(step_s(), std::move(actors));
    if (!columns_[kSpeed]) result.set_tolerance(kSpeedTolerance);
    for (const auto& scene : scenes) result.add(scene);
    for (const Row& row : rows_) add_events(row, place[row.actor], result);
    return result;
  }

  /// Over the whole drive, so that rounded times leave no trace; one that is written as 0.1 is 0.1.
  [[nodiscard]] double step_s() const {
    const double step = (times_.back() - times_.front()) / static_cast<double>(times_.size() - 1);
    constexpr double kDigits = 1e9;
    return std::round(step * kDigits) / kDigits;
  }

  /// Headings and speeds that the file does not have follow from the places.
  void complete(std::vector<std::vector<ActorState>>& scenes) const {
    const double step = step_s();
    const std::size_t count = scenes.front().size();
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t t = 0; t < scenes.size(); ++t) {
        // Derived from the step that led here; in the first scene, from the next step.
        const ActorState& from = scenes[t == 0 ? 0 : t - 1][i];
        const ActorState& to = scenes[t == 0 ? 1 : t][i];
        const double dx = to.x_m - from.x_m;
        const double dy = to.y_m - from.y_m;
        const double way = std::hypot(dx, dy);
        ActorState& state = scenes[t][i];
        if (!columns_[kSpeed]) state.speed_mps = way / step;
        if (columns_[kHeading]) continue;
        state.heading_rad = way > 0 ? std::atan2(dy, dx)
                            // A standing actor keeps its heading; one that never moved faces along
                            // the road (+y).
                            : t > 0 ? scenes[t - 1][i].heading_rad
                                    : std::numbers::pi / 2;
      }
    }
  }

  static void add_events(const Row& row, std::size_t actor, Recording& recording) {
    for (const std::string_view kind : kinds_in(row.events)) {
      recording.add(RecordedEvent{.tick = static_cast<std::uint32_t>(row.scene),
                                  .actor = static_cast<std::uint32_t>(actor),
                                  .kind = std::string(kind),
                                  .text = {}});
    }
  }

  const SourcePtr& source_;
  Diagnostics& warnings_;
  Diagnostics diagnostics_;
  std::array<std::optional<std::size_t>, kColumnCount> columns_;
  std::size_t field_count_ = 0;
  std::vector<Who> actors_;
  std::map<std::string, std::size_t, std::less<>> numbers_;
  std::vector<double> times_;
  std::set<std::pair<std::size_t, std::size_t>> seen_;  // scene and actor
  std::vector<Row> rows_;
};

}  // namespace

Result<Recording> parse_trace(const SourcePtr& source, Diagnostics& warnings) {
  return TraceParser(source, warnings).parse();
}

std::string print_trace(const Recording& recording) {
  std::string text = "time,actor,kind,x,y,heading,speed,length,width,event\n";
  std::map<std::pair<std::size_t, std::size_t>, std::string> events;
  for (const RecordedEvent& event : recording.events()) {
    if (!event.actor) continue;
    std::string& entry = events[{event.tick, *event.actor}];
    entry += entry.empty() ? event.kind : ";" + event.kind;
  }
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    const auto scene = recording.scene(tick);
    for (std::size_t i = 0; i < scene.size(); ++i) {
      const Actor& actor = recording.actors()[i];
      const auto event = events.find({tick, i});
      text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n",
                          static_cast<double>(tick) * recording.tick_s(), csv_quoted(actor.name),
                          name(actor.kind), scene[i].x_m, scene[i].y_m, scene[i].heading_rad,
                          scene[i].speed_mps, actor.length_m, actor.width_m,
                          event == events.end() ? "" : csv_quoted(event->second));
    }
  }
  return text;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/test_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace jaywalk::picture {
namespace {

constexpr int kWidth = 960;
constexpr double kMargin = 16;
constexpr double kTop = 64;
constexpr double kBottom = 40;
constexpr double kLongest_m = 160;
constexpr double kTallest = 1200;

constexpr Colour kPaper{1, 1, 1};
constexpr Colour kInk{0.11, 0.14, 0.16};
constexpr Colour kFaint{0.36, 0.40, 0.45};
constexpr Colour kRoad{0.84, 0.86, 0.88};
constexpr Colour kKerb{0.95, 0.93, 0.88};
constexpr Colour kBlocked{0.55, 0.53, 0.50};
constexpr Colour kMark{1, 1, 1};
constexpr Colour kAv{0.11, 0.14, 0.16};
constexpr Colour kPedestrian{0, 0.447, 0.698};
constexpr Colour kHit{0.784, 0.322, 0};
constexpr Colour kOther{0.43, 0.26, 0.76};

Colour colour_of(Surface surface) {
  switch (surface) {
    case Surface::pavement:
      return kKerb;
    case Surface::lane:
    case Surface::crosswalk:
      return kRoad;
    case Surface::blocked:
      break;
  }
  return kBlocked;
}

Colour faded(Colour colour) {
  colour.alpha = 0.35;
  return colour;
}

}  // namespace

TestPicture::TestPicture(std::string title, GroundPlan plan, const Recording& recording,
                         const Recording* twin)
    : title_(std::move(title)), plan_(std::move(plan)), recording_(recording), twin_(twin) {
  length_m_ = plan_.length_m();
  breadth_m_ = plan_.breadth_m();
  shown_m_ = std::min(length_m_, kLongest_m);
  // A square map is shown smaller rather than as a tower.
  scale_ = std::min((kWidth - 2 * kMargin) / shown_m_, kTallest / breadth_m_);
}

double TestPicture::left_at(std::size_t tick) const {
  const double av_m = recording_.scene(tick)[0].y_m;
  return std::clamp(av_m - shown_m_ / 3, 0.0, length_m_ - shown_m_);
}

Place TestPicture::place(double x_m, double y_m, double left_m) const {
  return {kMargin + (y_m - left_m) * scale_, kTop + x_m * scale_};
}

void TestPicture::draw_ground(Canvas& canvas, double left_m) const {
  const Grid size = plan_.grid;
  const double cell = plan_.cell_m;
  const int first = std::max(0, static_cast<int>(left_m / cell));
  const int last = std::min(size.cells, static_cast<int>(std::ceil((left_m + shown_m_) / cell)));
  for (int row = 0; row < size.rows; ++row) {
    for (int y = first; y < last;) {
      const Surface here = plan_.at({row, y});
      int end = y + 1;
      while (end < last && plan_.at({row, end}) == here) ++end;
      const double from = std::max(y * cell, left_m);
      const double to = std::min(end * cell, left_m + shown_m_);
      const Place corner = place(row * cell, from, left_m);
      // Half a pixel more, so that no line is left between rows.
      canvas.rectangle(corner, (to - from) * scale_, cell * scale_ + 0.5, colour_of(here));
      if (here == Surface::crosswalk) {
        canvas.rectangle({corner.x, corner.y + cell * scale_ * 0.2}, (to - from) * scale_,
                         cell * scale_ * 0.55, kMark);
      }
      y = end;
    }
  }
  int rows = 0;
  for (std::size_t i = 0; i + 1 < plan_.bands.size() && !plan_.is_drawn; ++i) {
    rows += plan_.bands[i].rows;
    if (plan_.bands[i].kind != AreaKind::lane || plan_.bands[i + 1].kind != AreaKind::lane) {
      continue;
    }
    canvas.line(place(rows * cell, left_m, left_m), place(rows * cell, left_m + shown_m_, left_m),
                2, kMark, 10);
  }
}

void TestPicture::draw_actor(Canvas& canvas, std::size_t actor, std::size_t tick,
                             double left_m) const {
  const Actor& who = recording_.actors()[actor];
  const ActorState& state = recording_.scene(tick)[actor];
  const Place at = place(state.x_m, state.y_m, left_m);
  const auto is_inside = [&](Place point) {
    return point.x >= kMargin - 1 && point.x <= kMargin + shown_m_ * scale_ + 1;
  };
  const bool hit = std::ranges::any_of(recording_.events(), [&](const RecordedEvent& event) {
    return event.actor == actor && event.tick <= tick;
  });
  const Colour colour = who.kind == ActorKind::vehicle      ? kAv
                        : hit                               ? kHit
                        : who.kind == ActorKind::pedestrian ? kPedestrian
                                                            : kOther;
  for (std::size_t before = 0; before < tick; ++before) {
    const ActorState& from = recording_.scene(before)[actor];
    const ActorState& to = recording_.scene(before + 1)[actor];
    const Place a = place(from.x_m, from.y_m, left_m);
    const Place b = place(to.x_m, to.y_m, left_m);
    if (is_inside(a) && is_inside(b)) canvas.line(a, b, 1.5, faded(colour));
  }
  if (!is_inside(at)) return;
  if (who.kind == ActorKind::pedestrian) {
    const double radius = std::max(4.5, who.width_m * scale_ / 2);
    canvas.disc(at, radius, colour);
    if (hit) canvas.ring(at, radius + 4, 2, colour);
  } else {
    // Headings are counted counter-clockwise from the right of the AV's way, which points down.
    canvas.box(at, std::max(8.0, who.length_m * scale_), std::max(5.0, who.width_m * scale_),
               std::numbers::pi / 2 - state.heading_rad, colour);
  }
  constexpr std::size_t kMostNames = 25;
  if (actor > 0 && recording_.actors().size() <= kMostNames) {
    canvas.text({at.x + 7, at.y - 7}, who.name, 11, kInk);
  }
}

void TestPicture::draw_twin(Canvas& canvas, std::size_t tick, double left_m) const {
  if (twin_ == nullptr) return;
  const auto own = recording_.scene(tick);
  const auto other = twin_->scene(std::min(tick, twin_->scenes() - 1));
  for (std::size_t actor = 0; actor < own.size(); ++actor) {
    if (own[actor].x_m == other[actor].x_m && own[actor].y_m == other[actor].y_m) continue;
    const Actor& who = recording_.actors()[actor];
    canvas.box(place(other[actor].x_m, other[actor].y_m, left_m),
               std::max(8.0, who.length_m * scale_), std::max(5.0, who.width_m * scale_),
               std::numbers::pi / 2 - other[actor].heading_rad, faded(actor == 0 ? kAv : kOther));
  }
}

void TestPicture::draw_scale(Canvas& canvas, double left_m) const {
  const double bottom = kTop + breadth_m_ * scale_;
  const double step = shown_m_ > 60 ? 20 : shown_m_ > 15 ? 5 : 1;
  for (double mark = std::ceil(left_m / step) * step; mark <= left_m + shown_m_; mark += step) {
    const double x = place(0, mark, left_m).x;
    canvas.line({x, bottom}, {x, bottom + 5}, 1, kFaint);
    canvas.text({x, bottom + 18}, fmt::format("{:g}", mark), 11, kFaint, TextAlign::centre);
  }
  canvas.text({kMargin + shown_m_ * scale_, bottom + 33}, "metres along the AV's way", 11, kFaint,
              TextAlign::right);
}

std::string TestPicture::happened(std::size_t tick) const {
  std::string text;
  for (const RecordedEvent& event : recording_.events()) {
    if (event.tick > tick) continue;
    if (!text.empty()) text += ", ";
    text += event.kind;
    if (event.actor) text += fmt::format(" of {}", recording_.actors()[*event.actor].name);
    text += fmt::format(" at tick {}", event.tick);
  }
  constexpr std::size_t kMost = 120;
  if (text.size() > kMost) text = text.substr(0, kMost) + " ...";
  return text;
}

Canvas TestPicture::draw(std::size_t tick) const {
  const double left_m = left_at(tick);
  Canvas canvas(kWidth, static_cast<int>(std::ceil(kTop + breadth_m_ * scale_ + kBottom)), kPaper);
  draw_ground(canvas, left_m);
  draw_twin(canvas, tick, left_m);
  for (std::size_t actor = recording_.actors().size(); actor > 0; --actor) {
    draw_actor(canvas, actor - 1, tick, left_m);
  }
  // Cover what was drawn beyond the shown part.
  canvas.rectangle({0, 0}, kMargin, kTop + breadth_m_ * scale_, kPaper);
  canvas.rectangle({kMargin + shown_m_ * scale_, 0}, kWidth, kTop + breadth_m_ * scale_, kPaper);
  draw_scale(canvas, left_m);
  canvas.text({kMargin, 26}, title_, 17, kInk);
  canvas.text({kWidth - kMargin, 26},
              fmt::format("tick {} of {}, {:.1f} s", tick, recording_.scenes() - 1,
                          static_cast<double>(tick) * recording_.tick_s()),
              14, kFaint, TextAlign::right);
  const std::string events = happened(tick);
  canvas.text({kMargin, 48}, events, 13, events.empty() ? kFaint : kHit);
  return canvas;
}

}  // namespace jaywalk::picture

// SPDX-License-Identifier: Apache-2.0
#pragma once

// A recorded test as pictures: the road from left to right, all actors on it at one tick, and the
// path of each so far. A long road is shown in part, around the AV.

#include <string>

#include "env/ground.h"
#include "experiment/judge/recording.h"
#include "tools/picture/canvas.h"

namespace jaywalk::picture {

class TestPicture {
 public:
  /// The recordings must outlive it. `title` stands above, `twin`, the same test with the healthy
  /// AV, behind, faintly; null: there is none.
  TestPicture(std::string title, GroundPlan plan, const Recording& recording,
              const Recording* twin = nullptr);

  /// REQUIRES: a tick that the recording has.
  [[nodiscard]] Canvas draw(std::size_t tick) const;

 private:
  void draw_ground(Canvas& canvas, double left_m) const;
  void draw_actor(Canvas& canvas, std::size_t actor, std::size_t tick, double left_m) const;
  /// Draws the actors that are at another place in the twin.
  void draw_twin(Canvas& canvas, std::size_t tick, double left_m) const;
  void draw_scale(Canvas& canvas, double left_m) const;
  [[nodiscard]] std::string happened(std::size_t tick) const;
  /// Where the shown part begins.
  [[nodiscard]] double left_at(std::size_t tick) const;
  [[nodiscard]] Place place(double x_m, double y_m, double left_m) const;

  std::string title_;
  GroundPlan plan_;
  const Recording& recording_;
  const Recording* twin_;
  double length_m_ = 0;
  double breadth_m_ = 0;
  double shown_m_ = 0;
  double scale_ = 1;
};

}  // namespace jaywalk::picture

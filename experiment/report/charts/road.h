#pragma once

// The road as a picture, along it from left to right: what lies on the ground is drawn over it.

#include <string>
#include <vector>

#include "env/ground.h"
#include "env/scene.h"

namespace jaywalk::reporting {

/// Maps places of the ground to places on the picture, in its units.
class RoadPicture {
 public:
  /// A picture of that ground, as wide as the page's pictures.
  explicit RoadPicture(const Ground& ground);

  /// Along the road and to the right of the AV's way.
  [[nodiscard]] double across(double y_m) const { return kMargin + (y_m - begin_m_) * along_; }
  [[nodiscard]] double down(double x_m) const { return 2 + (x_m - left_m_) * sideways_; }
  [[nodiscard]] double length(double metres) const { return metres * along_; }
  [[nodiscard]] double breadth(double metres) const { return metres * sideways_; }

  /// The middle of the line below the marks, whose left half is free.
  [[nodiscard]] double legend_line() const { return height_ + 34; }

  /// Lanes and pavements; `content` on them, metres below.
  [[nodiscard]] std::string draw(std::string_view label, const std::string& content) const;

 private:
  static constexpr double kMargin = 6;
  static constexpr double kWidth = 520;

  const Ground& ground_;
  double begin_m_ = 0;
  double left_m_ = 0;
  double height_ = 0;
  double end_m_ = 1;
  double along_ = 1;
  double sideways_ = 1;
};

}  // namespace jaywalk::reporting

#pragma once

// Roads as small pictures side by side, in their generator's colour, with a scale bar in metres.

#include <string>
#include <string_view>

#include "search/search.h"
#include "search/suts/road_space.h"

namespace jaywalk::search {

class RoadPictures {
 public:
  /// `generator`: its number, which gives the colour. The model must outlive the pictures.
  /// REQUIRES: a SUT that drives on roads.
  RoadPictures(const SutModel& model, std::size_t generator)
      : model_(model), space_(*model.road_space()), generator_(generator) {}

  /// The road, its beginning as a bar across, and a dot beside the place where the car was farthest
  /// out of its lane, if that is known.
  void add(const TestRow& row, std::string_view caption);
  /// There are as many as are looked at.
  [[nodiscard]] bool full() const { return count_ >= kShown; }
  [[nodiscard]] std::string html() const;

  static constexpr std::size_t kShown = 8;

 private:
  const SutModel& model_;
  const RoadSpace& space_;
  std::size_t generator_;
  std::size_t count_ = 0;
  std::string figures_;
};

}  // namespace jaywalk::search

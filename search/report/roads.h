#pragma once

// Roads as small pictures side by side, in their generator's colour.

#include <string>
#include <string_view>

#include "search/search.h"
#include "search/suts/road_space.h"

namespace jaywalk::search {

class RoadPictures {
 public:
  /// `generator`: its number, which gives the colour. The space must outlive the pictures.
  RoadPictures(const RoadSpace& space, std::size_t generator)
      : space_(space), generator_(generator) {}

  void add(const TestRow& row, std::string_view caption);
  /// There are as many as are looked at.
  [[nodiscard]] bool full() const { return count_ >= kShown; }
  [[nodiscard]] std::string html() const;

  static constexpr std::size_t kShown = 8;

 private:
  const RoadSpace& space_;
  std::size_t generator_;
  std::size_t count_ = 0;
  std::string figures_;
};

}  // namespace jaywalk::search

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The built-in lane-keeping assistants as a SUT. Read env/lane/drive.h first.

#include "env/lane/drive.h"
#include "search/sut.h"
#include "search/suts/road_space.h"

namespace jaywalk::search {

class LaneKeeping : public SutModel {
 public:
  LaneKeeping(const RoadSpaceSettings& space, lane::DriveSettings drive)
      : space_(space), drive_(std::move(drive)) {}

  [[nodiscard]] const SearchSpace& space() const override { return space_; }
  [[nodiscard]] std::span<const MeasureKind> measures() const override;
  [[nodiscard]] std::unique_ptr<Sut> make() const override;
  [[nodiscard]] std::vector<SutSetting> settings() const override;
  [[nodiscard]] const RoadSpace* road_space() const override { return &space_; }
  [[nodiscard]] const lane::DriveSettings* drive() const override { return &drive_; }

 private:
  RoadSpace space_;
  lane::DriveSettings drive_;
};

}  // namespace jaywalk::search

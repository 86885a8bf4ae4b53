#pragma once

// The keys `roads` of an experiment, shared by the SUTs that drive.

#include "search/suts/road_space.h"
#include "search/suts/suts.h"

namespace jaywalk::search {

void read_road_space(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                     RoadSpaceSettings& space);

/// The road space in words.
[[nodiscard]] SutSetting road_setting(const RoadSpaceSettings& space);

}  // namespace jaywalk::search

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Crossing worlds whose roads are planned and exported.

#include "env/crossing/parameters.h"

namespace jaywalk {

/// A side road with one lane each way between buildings, over a road with one lane each way. Cells
/// of 2 m.
inline CrossingParameters junction_world() {
  CrossingParameters world;
  world.map = {"###.<>.###",  //
               "....<>....",  //
               ">>>>xx>>>>",  //
               "<<<<xx<<<<",  //
               "....<>....",  //
               "###.<>.###"};
  world.bands = {{BandKind::pavement, 2},
                 {BandKind::lane, 1, Direction::forward},
                 {BandKind::lane, 1, Direction::back},
                 {BandKind::pavement, 2}};
  world.length = 10;
  world.cell_m = 2;
  world.av.rows = {2, 2};
  world.road_end = 9;
  world.spawn.dead_zones = {};
  return world;
}

/// The case study's road with a crosswalk on these cells.
inline CrossingParameters crosswalk_world(CrosswalkKind kind, Interval cells) {
  CrossingParameters world;
  world.crosswalks = {{kind, cells}};
  return world;
}

}  // namespace jaywalk

#pragma once

// Which situations tests can meet at all, and walks that meet them, as `jaywalk reach --csv` writes
// them (search/model_based/reachable_situations.h); or walks alone, as people write them. Read situations.h
// before.

#include <string>
#include <vector>

#include "env/grid/grid.h"
#include "experiment/judge/situations/situations.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// A pedestrian's start and what it does in each tick: a letter of `fblrs` for forward, back, left,
/// right, stay. agents/crossing/scripted.asl repeats it.
struct ScriptedWalk {
  Position start;
  std::string moves;

  friend bool operator==(const ScriptedWalk&, const ScriptedWalk&) = default;
};

inline constexpr std::string_view kWalkLetters = "fblrs";
inline constexpr std::string_view kReachHeader =
    "item,bin,name,reachable,start_row,start_cell,moves";
inline constexpr std::string_view kWalksHeader = "start_row,start_cell,moves";

struct ReachFile {
  /// Empty if the file has walks alone.
  ReachableBins reachable;
  /// Each once, in the order of the lines.
  std::vector<ScriptedWalk> walks;
};

/// All mistakes are reported, with their places.
[[nodiscard]] Result<ReachFile> parse_reach_file(const SourcePtr& source);

}  // namespace jaywalk

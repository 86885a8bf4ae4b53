// SPDX-License-Identifier: Apache-2.0
#pragma once

// Failing roads as files that other programs read: OpenDRIVE with OpenSCENARIO, and the road JSON
// of the SBST/SBFT CPS tool competition. Read env/lane/spline.h and search.h first.

#include <optional>
#include <string>
#include <string_view>

#include "env/lane/drive.h"
#include "env/lane/road.h"
#include "search/search_experiment.h"

namespace jaywalk::search {

/// ASAM OpenDRIVE 1.6: the road's middle line as it was interpolated, each cubic piece of the
/// spline a parametric polynomial of its own; one lane of 4 m to each side. REQUIRES: a spline goes
/// through the points.
[[nodiscard]] std::string to_opendrive(const lane::Polyline& points, std::string_view name);

/// ASAM OpenSCENARIO 1.0, valid in 1.1 to 1.3 too: the car starts in the right lane of that
/// OpenDRIVE file and drives to the road's end, up to the speed limit, which is the parameter
/// SpeedLimit. How it steers and slows down in curves is up to the player's controller.
[[nodiscard]] std::string to_openscenario(const lane::Polyline& points, std::string_view road_file,
                                          const lane::DriveSettings& drive);

/// The competition's test file (test.NNNN.json): road points, interpolated points, validity,
/// outcome.
[[nodiscard]] std::string to_competition_json(const TestRow& row, const lane::Polyline& points,
                                              std::size_t id);

/// Writes the failing roads of every search into a folder, which is made: for each generator and
/// repetition `GENERATOR-REPETITION-NUMBER.xodr`, `.xosc` and `.json`. Why that failed, if it did.
[[nodiscard]] std::optional<std::string> export_failures(const std::string& folder,
                                                         const SearchExperiment& experiment,
                                                         const SearchResults& results);

}  // namespace jaywalk::search

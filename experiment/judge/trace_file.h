// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads a recording from CSV, for drives that were recorded or simulated elsewhere. One row for
// each actor at each time:
//
//   time     s, from the same beginning for all; the times are evenly spaced
//   actor    its name; `av` is the automated vehicle, or else the first vehicle of the file
//   kind     vehicle, pedestrian, cyclist or signal
//   x, y     m, the middle of its box: x to the right of the AV's way, y along it
//   heading  rad, counter-clockwise from +x (the AV's way is 1.5708); without the column that of
//            its motion
//   speed    m/s, at least 0; without the column from one place to the next, and numbers that
//            differ by 1e-6 or less are equal then
//   length, width  m, of its box; without the column, or where it is empty, the usual size of its
//            kind
//   event    what happened to it in the step to this time, as `collision`; several with semicolons
//
// The first five have to be there, the others need not; columns may stand in any order, under names
// with units, too (`time_s`, `x_m`, `y_m`, `heading_rad`, `speed_mps`, `length_m`, `width_m`).

#include <string>

#include "experiment/judge/recording.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// A larger table is refused.
inline constexpr std::size_t kMaxTraceBytes = std::size_t{256} << 20U;

/// Errors point at line and column: a column that is missing or twice there, a value that is no
/// number, a kind that does not exist, times that are not evenly spaced, an actor without a row at
/// some time or with two, no vehicle. Warnings: columns that are not read.
[[nodiscard]] Result<Recording> parse_trace(const SourcePtr& source, Diagnostics& warnings);

/// The inverse, with all columns; reading it gives the same recording but for events that concern
/// no actor and the texts of events.
[[nodiscard]] std::string print_trace(const Recording& recording);

}  // namespace jaywalk

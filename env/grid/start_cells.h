// SPDX-License-Identifier: Apache-2.0
#pragma once

// Start cells as a file, so that the same beginnings can be kept, exchanged and replayed. A CSV
// text with the header `test,agent,row,cell`: tests count from 0, agents from 1.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "env/grid/grid.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// The agents' start cells of each test, by the test's number.
using StartCells = std::map<std::uint64_t, std::vector<Position>>;

/// Parses the text; every cell must lie on the grid, and a test's agents must be numbered from 1
/// without a gap (in any order).
[[nodiscard]] Result<StartCells> parse_start_cells(const SourcePtr& source, const Grid& grid);

[[nodiscard]] std::string print_start_cells(const StartCells& cells);

}  // namespace jaywalk

#pragma once

// The results of searches as a self-contained HTML page: the paper's Table 1 and Figures 1 to 3
// with ours, fitness over time, the last tests of each generator, clusters of failing tests. Read
// tables.h first.

#include <string>

#include "search/report/tables.h"

namespace jaywalk::search {

[[nodiscard]] std::string to_html(const SearchExperiment& experiment,
                                  const std::vector<GeneratorResults>& generators);

}  // namespace jaywalk::search

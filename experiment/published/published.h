#pragma once

// The figures of the paper that the case study repeats, to be shown beside ours. They are data
// (paper_figures.csv, which names their source), built into the program.

#include <cstdint>
#include <optional>
#include <string_view>

#include "experiment/measures/measures.h"

namespace jaywalk {

/// What the paper gives for a measure; nothing if it has no figure for it.
[[nodiscard]] std::optional<Estimate> published_figure(const Measure& measure,
                                                       std::string_view behaviour,
                                                       std::uint32_t agents);

}  // namespace jaywalk

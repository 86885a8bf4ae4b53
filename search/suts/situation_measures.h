#pragma once

// The situations (experiment/judge/situations/situations.h) that a test met, as measures of its
// SUT: `bin_ITEM` for each item, in their order. Read sut.h first.

#include "experiment/judge/situations/situations.h"
#include "search/sut.h"

namespace jaywalk::search {

/// The measures' names.
[[nodiscard]] std::vector<std::string> situation_measures();

/// Appends a test's measures of these: the number of the bin that it met, from 1; 0: none.
void add_situations(const SituationBins& bins, std::vector<double>& measures);

/// Reads add_situations' measures back; nothing if the SUT does not measure situations. A test
/// without a result met none.
[[nodiscard]] std::optional<SituationBins> situation_bins(const Outcome& outcome,
                                                          std::span<const MeasureKind> measures);

}  // namespace jaywalk::search

#pragma once

// The failing tests of a generator in groups of similar ones. Read tables.h first.

#include <string>

#include "search/report/tables.h"

namespace jaywalk::search {

/// The clusters of failures in all repetitions; `number` is the generator's, which gives the
/// colour. Tests on roads are the same if the stretches on which they failed are within a metre of
/// each other (failing_stretch.h), others if their signatures are nearer than half the median
/// distance.
[[nodiscard]] std::string clusters_html(const GeneratorResults& generator, const SutModel& model,
                                        std::size_t number);

}  // namespace jaywalk::search

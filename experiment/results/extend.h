#pragma once

// A store whose experiment gets more tests: ids follow from the plan, so that those of most tests
// change.

#include <optional>

#include "experiment/results/description.h"
#include "experiment/results/store/database.h"

namespace jaywalk {

/// Makes a store of `before` one of an experiment with `tests` tests of each behaviour and number
/// of agents, in one transaction; the new ones are still missing. REQUIRES: opened to be written,
/// and `tests` > before.tests.
void extend_store(Database& database, const ExperimentDescription& before, std::uint64_t tests);

}  // namespace jaywalk

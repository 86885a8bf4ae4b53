// SPDX-License-Identifier: Apache-2.0
#pragma once

// The results of `compare`: its files, and what it prints beside its tables.

#include <string>

#include "experiment/report/facts.h"
#include "experiment/run/run_comparison.h"
#include "tools/jaywalk/comparison/compare_request.h"

namespace jaywalk::command::compare {

/// The files that options ask for; false after reporting what could not be written. `facts` are
/// those of a page of a comparison without a store.
[[nodiscard]] bool write_files(const Arguments& arguments, const Request& request,
                               const ComparisonResults& results, const reporting::FactsTable& facts,
                               Console& console);

/// Which situations the tests covered, as a table.
[[nodiscard]] std::string situations_of(const Request& request, const ComparisonResults& results);

/// The message after an interrupted run: how many tests are done, and how to run the rest.
[[nodiscard]] std::string interruption(const Request& request, const ComparisonResults& results);

}  // namespace jaywalk::command::compare

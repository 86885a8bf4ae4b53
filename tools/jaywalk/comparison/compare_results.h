#pragma once

// The results of `compare`: its tables and files.

#include <optional>
#include <string>

#include "experiment/compare/comparison.h"
#include "tools/jaywalk/comparison/compare_tests.h"

namespace jaywalk::command::compare {

/// The summary of the outcome; with a store, that of the store, which may have had tests before.
/// Nothing after reporting why not.
[[nodiscard]] std::optional<Comparison> comparison_of(const Request& request,
                                                      const Collected& collected,
                                                      ExperimentOutcome& outcome, Console& console);

/// Whether the report is a page, and not a picture.
[[nodiscard]] bool wants_page(const Arguments& arguments);

/// The files that options ask for; false after reporting what could not be written.
[[nodiscard]] bool write_files(const Arguments& arguments, const Request& request,
                               const Collected& collected, const Comparison& comparison,
                               const reporting::FactsTable& facts, Console& console);

/// Which situations the tests covered, as a table.
[[nodiscard]] std::string situations_of(const Request& request, const Comparison& comparison,
                                        const SituationTable& table);

/// The message after an interrupted run: how many tests are done, and how to run the rest.
[[nodiscard]] std::string interruption(const Request& request, const ExperimentOutcome& outcome,
                                       const Comparison& comparison);

}  // namespace jaywalk::command::compare

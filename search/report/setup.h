#pragma once

// The search's setup, its budget and how to get the same results again: the first and the last
// section of the page. Read tables.h first.

#include <string>

#include "search/report/tables.h"

namespace jaywalk::search {

/// System under test, generators, budget, fitness.
[[nodiscard]] std::string setup_html(const SearchExperiment& experiment);

/// The command and the experiment's text.
[[nodiscard]] std::string reproduce_html(const SearchExperiment& experiment);

}  // namespace jaywalk::search

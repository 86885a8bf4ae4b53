#pragma once

// The published results that a search of roads repeats, where it repeats them. Read
// search/search_experiment.h first.

#include <string>

#include "search/search_experiment.h"

namespace jaywalk::search {

/// Whether a search was set up as the published ones were: the published roads, a test fails from
/// 95 % of the car out of its lane on, no speed limit, two hours. Which car drives does not matter:
/// the published one was BeamNG.tech's. An external car's speed limit is not known; it never is.
[[nodiscard]] bool is_as_published(const SearchExperiment& experiment);

/// Table 1 of Peltomäki, Spencer and Porres 2022 as HTML, or a line that says why it is left out;
/// empty if no roads are searched.
[[nodiscard]] std::string published_table(const SearchExperiment& experiment);

}  // namespace jaywalk::search

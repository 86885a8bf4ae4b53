// SPDX-License-Identifier: Apache-2.0
#pragma once

// Searches in a GeoPackage, the file format of all results (experiment/results/): each finished
// test is committed at once, so that a process that is killed loses none of them, and a search goes
// on from there. The failing roads are lines that a GIS can show. docs/reference/store.md
// has the format's reasons. Read search.h first.

#include <memory>
#include <optional>
#include <string>

#include "search/search_experiment.h"

namespace jaywalk::search {

class SearchStore : public TestLog {
 public:
  enum class Mode { create, resume };

  /// Errors: the file exists (create), is no store of searches, holds another experiment or one
  /// whose files have changed since, is in use or damaged. Such a file is left as it is. Resuming
  /// without a file creates one.
  [[nodiscard]] static Result<std::unique_ptr<SearchStore>> open(
      const std::string& path, Mode mode, const SearchExperiment& experiment);

  /// Notes which searches are finished and makes the store one plain file. Why that failed, or why
  /// tests could not be kept, if so.
  [[nodiscard]] virtual std::optional<std::string> finish(const SearchResults& results) = 0;
  /// How many tests it had when it was opened.
  [[nodiscard]] virtual std::size_t had() const = 0;
};

/// A store's experiment and results; `results` has the finished repetitions.
struct StoredSearches {
  SearchExperiment experiment;
  SearchResults results;
};

[[nodiscard]] bool is_search_store(const std::string& path);
/// Nothing is written, and no other file is read: the texts of the experiment, its scenario and all
/// that these name are in the store. Errors: no store of searches, damaged, the experiment cannot
/// be read.
[[nodiscard]] Result<StoredSearches> read_search_store(const std::string& path);

}  // namespace jaywalk::search

#pragma once

// Searches in a GeoPackage, the file format of all results (experiment/results/): each finished
// test is committed at once, so that a process that is killed loses none of them, and a search goes
// on from there. The failing roads are lines that a GIS can show. README.md of experiment/results
// has the format's reasons. Read search.h before.

#include <memory>
#include <string>

#include "search/experiment.h"

namespace jaywalk::search {

class SearchStore : public TestLog {
 public:
  enum class Mode { create, resume };

  /// Errors: the file exists (create), is no store of searches, holds another experiment, is in use
  /// or damaged. Such a file is left as it is. Resuming without a file creates one.
  [[nodiscard]] static Result<std::unique_ptr<SearchStore>> open(
      const std::string& path, Mode mode, const SearchExperiment& experiment);

  /// Notes which searches are finished and makes the store one plain file. Why that failed, if it
  /// did.
  [[nodiscard]] virtual std::string finish(const SearchResults& results) = 0;
  /// How many tests it had when it was opened.
  [[nodiscard]] virtual std::size_t had() const = 0;
};

}  // namespace jaywalk::search

// SPDX-License-Identifier: Apache-2.0
#pragma once

// A search as a YAML file describes it (docs/reference/search.md is the reference of its keys).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/scenario/scenario.h"
#include "search/search.h"

namespace jaywalk::search {

inline constexpr std::int64_t kMostRepetitions = 100'000;

/// Whether an experiment's SUT is executed with its least and greatest values as it is read, so
/// that impossible ranges are reported before the search begins.
enum class SutCheck { done, omitted };

struct SearchOptions {
  /// `dotted.path=value`, in order, as given to `--set`.
  std::vector<std::string> sets;
  /// Defects of the AV as the key `defects` has them; takes the file's place. From `--defects`.
  std::optional<std::string> defects;
  /// Names of the file's generators or of kinds; these and no others, in this order. Empty: all.
  std::vector<std::string> generators;
  /// The source of the agents' programs.
  SourceFiles files;
  IncludeFolders include;
  SutCheck sut_check = SutCheck::done;
};

struct SearchExperiment {
  /// The file's name.
  std::string name;
  std::string sut;
  std::string measure;
  SearchPlan plan;
  /// Each of the generators searches the AV with each of these.
  std::vector<VehicleDefect> defects;
  /// From which it was read.
  std::string text;
  /// The texts of all other files that its tests are made from.
  std::vector<SourcePtr> inputs;
  SearchOptions options;
  /// Text and options as one text, which a store compares before it is continued.
  std::string origin;
};

[[nodiscard]] Result<SearchExperiment> read_search(const std::string& path,
                                                   const SearchOptions& options = {});
/// Like read_search(), for a text in memory; paths in it are relative to the folder in the source's
/// name.
[[nodiscard]] Result<SearchExperiment> parse_search(const SourcePtr& source,
                                                    const SearchOptions& options = {});

/// Whether a file is a search rather than a scenario: it has the key `sut`.
[[nodiscard]] bool is_search(const SourcePtr& source);

}  // namespace jaywalk::search

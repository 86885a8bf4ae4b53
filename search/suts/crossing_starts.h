// SPDX-License-Identifier: Apache-2.0
#pragma once

// The key `starts` of the pedestrians' world as a SUT: where tests begin. Read crossing_space.h
// before.

#include <optional>
#include <string_view>
#include <vector>

#include "env/crossing/world.h"
#include "experiment/judge/situations/situations.h"
#include "search/suts/crossing_space.h"
#include "search/suts/suts.h"

namespace jaywalk::search {

class CrossingStartsReader {
 public:
  /// The setup must outlive it.
  explicit CrossingStartsReader(const SutSetup& setup) : setup_(setup), reader_(setup.reader) {}

  /// A word, `{rows: [1, 10], cells: [28, 44, 55]}`: some cells, or `{walks: FILE}`.
  void read(const ConfigNode& node, const std::string& path);

  /// The possible starts of `agents` pedestrians; nothing after reporting that there are none.
  [[nodiscard]] std::optional<CrossingStarts> space(const CrossingSpec& crossing,
                                                    std::uint32_t agents) const;
  /// The file of walks; null if there is none.
  [[nodiscard]] const SourcePtr& file() const { return file_; }

 private:
  void read_walks(const ConfigNode& value);
  void read_whole_numbers(const ConfigNode& node, std::vector<int>& numbers);
  [[nodiscard]] std::optional<CrossingStarts> starts_of_walks(std::uint32_t agents) const;
  [[nodiscard]] std::optional<CrossingStarts> given_starts(const CrossingSpec& crossing,
                                                           std::uint32_t agents) const;
  bool choose(const std::vector<int>& wanted, std::vector<int>& all,
              std::string_view what_is_wrong) const;

  const SutSetup& setup_;
  const ConfigReader& reader_;
  enum class Starts { searched, spawn, chance, given } starts_ = Starts::searched;
  // The searched rows and cells: all, unless given.
  std::vector<int> rows_;
  std::vector<int> cells_;
  ValueOrigin origin_;
  /// In place of starts, if there are any.
  std::vector<ScriptedWalk> walks_;
  SourcePtr file_;
};

}  // namespace jaywalk::search

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The remarks of many tests for the authors of AVs' controllers (TestRun::notes): each text once,
// with the number of its tests.

#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace jaywalk {

/// Collects notes from several threads; the result depends on the tests alone.
class ControllerNotes {
 public:
  /// `place`: the test's place in the plan; each test once.
  void add(std::uint64_t place, std::span<const std::string> notes);
  /// The texts of the first tests that have some, and how many others there are; empty if there is
  /// nothing to say. REQUIRES: no thread adds at the same time.
  [[nodiscard]] std::vector<std::string> texts() const;

 private:
  /// More different texts than these are only counted.
  static constexpr std::size_t kMostShown = 5;

  struct Entry {
    std::uint64_t tests = 0;
    std::uint64_t first = 0;
    /// Empty unless it is among the first ones.
    std::string text;
  };

  std::mutex mutex_;
  /// By the text's hash: each of millions of tests may have a text of its own.
  std::map<std::size_t, Entry> entries_;
  /// The first ones: place and hash.
  std::set<std::pair<std::uint64_t, std::size_t>> shown_;
};

}  // namespace jaywalk

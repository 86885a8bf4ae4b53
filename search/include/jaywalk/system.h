// SPDX-License-Identifier: Apache-2.0
#pragma once

// A system under test (SUT) of your own for a search: it executes a test input, a vector of numbers
// from -1 to 1, and returns what it measures of it.

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace jaywalk::search {

/// The outcome of one execution.
struct SystemOutcome {
  /// Why there is no result (it crashed, hung); empty if there is one.
  std::string error;
  /// Time that passed in the simulation, which is charged to the search.
  double simulated_s = 0;
  /// In the order of SystemUnderTest::measures.
  std::vector<double> measures;
};

/// Executes the tests of one search, one after another.
class SystemExecutor {
 public:
  virtual ~SystemExecutor() = default;
  /// `test`: the test's number in its search, from 0.
  [[nodiscard]] virtual SystemOutcome run(std::span<const double> input, std::size_t test) = 0;
};

/// Immutable; its functions are called by searches on several threads at once.
struct SystemUnderTest {
  std::string name;
  /// Numbers in an input; at least 1.
  std::size_t dimension = 1;
  /// The names of what it measures of each test; at least one.
  std::vector<std::string> measures;
  /// Why an input cannot be executed; empty if it can. Not set: all can.
  std::function<std::string(std::span<const double> input)> why_invalid;
  std::function<std::unique_ptr<SystemExecutor>()> make_executor;
};

}  // namespace jaywalk::search

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small experiments for stores to hold: the case study's world with few tests, in a folder of their
// own.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "experiment/results/description.h"
#include "experiment/results/test_record.h"

namespace jaywalk {

class StoreTest : public testing::Test {
 protected:
  StoreTest();
  ~StoreTest() override;

  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }

  /// Two behaviours, 1 and 3 agents, 12 tests each.
  [[nodiscard]] ExperimentDescription description(StoreLevel level = StoreLevel::found,
                                                  Shard shard = {}) const;
  /// All tests of the plan, in its order.
  [[nodiscard]] std::vector<TestKey> cases() const;
  /// Runs a test; its times are made up, so that they are the same each time.
  [[nodiscard]] TestRecord run(const TestKey& test) const;
  /// Writes a store with these tests; fails the test that calls it if that fails.
  void write(const std::string& path, const ExperimentDescription& description,
             const std::vector<TestKey>& tests) const;

  std::shared_ptr<const PreparedScenario> prepared_;
  ExperimentPlan plan_;

 private:
  std::filesystem::path folder_;
};

/// The first line of why something failed.
template <class T>
std::string message_of(Result<T> result) {
  return result ? "" : result.diagnostics().items().front().message;
}

}  // namespace jaywalk

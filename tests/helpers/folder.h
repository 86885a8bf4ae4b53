// SPDX-License-Identifier: Apache-2.0
#pragma once

// A folder of a test's own, which goes with it.

#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace jaywalk {

class FolderTest : public testing::Test {
 protected:
  FolderTest();
  ~FolderTest() override;

  /// The folder itself, or what bears the name in it.
  [[nodiscard]] std::string path(const std::string& name = {}) const {
    return (name.empty() ? folder_ : folder_ / name).string();
  }
  /// Writes a file, and makes the folders that it lies in; its path.
  std::string file(const std::string& name, std::string_view text) const;
  /// The text of a file; it fails the test if there is none.
  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] bool exists(const std::string& name) const {
    return std::filesystem::exists(folder_ / name);
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace jaywalk

#pragma once

// A folder of a test's own, in which commands read and write.

#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace jaywalk {

class FolderTest : public testing::Test {
 protected:
  FolderTest();
  ~FolderTest() override;

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  /// Writes a file; its path.
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

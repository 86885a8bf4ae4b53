// SPDX-License-Identifier: Apache-2.0
#include "tests/helpers/folder.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace jaywalk {

FolderTest::FolderTest() {
  std::string pattern = (std::filesystem::path(testing::TempDir()) / "jaywalk_XXXXXX").string();
  folder_ = ::mkdtemp(pattern.data());
}

FolderTest::~FolderTest() { std::filesystem::remove_all(folder_); }

std::string FolderTest::file(const std::string& name, std::string_view text) const {
  std::filesystem::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name, std::ios::binary) << text;
  return path(name);
}

std::string FolderTest::text(const std::string& name) const {
  std::ifstream stream(folder_ / name, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << name;
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace jaywalk

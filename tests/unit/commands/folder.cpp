#include "tests/unit/commands/folder.h"

#include <fstream>
#include <iterator>
#include <unistd.h>

namespace jaywalk {

FolderTest::FolderTest()
    : folder_(std::filesystem::path(testing::TempDir()) /
              ("jaywalk_commands_" + std::to_string(::getpid()))) {
  std::filesystem::create_directories(folder_);
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

// Every internal action and function is used by a program of this folder, outside its comments.

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "interpreter/logic/action.h"

namespace jaywalk::test {
namespace {

std::string all_programs() {
  std::string text;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(JAYWALK_SOURCE_DIR "/tests/conformance")) {
    if (entry.path().extension() != ".asl") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      text += line.substr(0, line.find("//"));
      text += '\n';
    }
  }
  return text;
}

bool is_part_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.';
}

bool uses(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != std::string_view::npos;
       at = text.find(name, at + 1)) {
    const bool begins = at == 0 || !is_part_of_name(text[at - 1]);
    const std::size_t end = at + name.size();
    // A full stop may follow an action without arguments.
    const bool ends = end == text.size() || !is_part_of_name(text[end]) || text[end] == '.';
    if (begins && ends && !(text[end] == '.' && is_part_of_name(text[end + 1]))) return true;
  }
  return false;
}

TEST(ConformancePrograms, UseEveryInternalActionAndFunction) {
  const std::string text = all_programs();
  ASSERT_TRUE(uses(text, ".print"));
  ASSERT_FALSE(uses(text, ".prin")) << "the test could not fail";
  for (const ActionDefinition& action : standard_actions().actions()) {
    EXPECT_TRUE(uses(text, action.name)) << action.name << " has no conformance program";
  }
  for (const FunctionDefinition& function : standard_actions().functions()) {
    EXPECT_TRUE(uses(text, function.name)) << function.name << " has no conformance program";
  }
}

}  // namespace
}  // namespace jaywalk::test

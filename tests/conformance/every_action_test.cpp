// SPDX-License-Identifier: Apache-2.0
// Every internal action and function is used by a program of this folder, outside its comments, and
// actions/cases/ has its ordinary, boundary and failure case.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "interpreter/logic/action.h"

namespace jaywalk::test {
namespace {

/// The programs of a folder and those below it, without comments, by path.
std::map<std::string, std::string> programs_in(const std::string& folder) {
  std::map<std::string, std::string> programs;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           JAYWALK_SOURCE_DIR "/tests/conformance" + folder)) {
    if (entry.path().extension() != ".asl") continue;
    std::ifstream file(entry.path());
    std::string& text = programs[entry.path().string()];
    for (std::string line; std::getline(file, line);) {
      text += line.substr(0, line.find("//"));
      text += '\n';
    }
  }
  return programs;
}

std::string all_programs() {
  std::string text;
  for (const auto& [path, program] : programs_in("")) text += program;
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

/// The plan `+!kind("name")` up to the next one; empty if there is none.
std::string case_of(const std::string& text, const std::string& kind, const std::string& name) {
  const std::size_t at = text.find("+!" + kind + "(\"" + name + "\") <-");
  if (at == std::string::npos) return {};
  const std::size_t body = text.find("<-", at);
  return text.substr(body, text.find("\n+!", body) - body);
}

/// What is missing of the three cases of an action or function, which are named `title` there.
std::string missing_cases(const std::map<std::string, std::string>& programs,
                          const std::string& title, const std::string& name) {
  std::string missing;
  for (const std::string kind : {"ordinary", "boundary", "failure"}) {
    bool found = false;
    for (const auto& [path, text] : programs) {
      const bool asked_for = text.find("\"" + title + "\"") < text.find("+!ordinary(");
      found = found || (asked_for && uses(case_of(text, kind, title), name));
    }
    if (!found) missing += (missing.empty() ? "" : ", ") + kind;
  }
  return missing;
}

TEST(ConformancePrograms, HaveEachActionsOrdinaryBoundaryAndFailureCase) {
  const auto programs = programs_in("/actions/cases");
  EXPECT_EQ(missing_cases(programs, ".none", ".none"), "ordinary, boundary, failure");
  for (const ActionDefinition& action : standard_actions().actions()) {
    EXPECT_EQ(missing_cases(programs, action.name, action.name), "") << action.name;
  }
  for (const FunctionDefinition& function : standard_actions().functions()) {
    // `.length` and `.count` are actions, too; as functions they stand there without the dot.
    const std::string title = function.name.substr(function.name.front() == '.' ? 1 : 0);
    EXPECT_EQ(missing_cases(programs, title, function.name), "") << function.name;
  }
}

}  // namespace
}  // namespace jaywalk::test

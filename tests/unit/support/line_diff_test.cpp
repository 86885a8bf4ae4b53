#include "interpreter/support/line_diff.h"

#include <charconv>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string diff(std::string_view before, std::string_view after) {
  return line_diff(before, after, "old", "new");
}

/// Lines with their breaks.
std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

int number_behind(std::string_view line, char sign) {
  int value = 0;
  const std::size_t at = line.find(sign) + 1;
  std::from_chars(line.data() + at, line.data() + line.size(), value);
  return value;
}

/// Applies a patch to a text, checking the lines that it expects.
std::string patched(std::string_view before, std::string_view unified) {
  const std::vector<std::string> old = lines_of(before);
  const std::vector<std::string> patch = lines_of(unified);
  std::string result;
  std::size_t next = 0;  // of the old lines
  for (std::size_t i = 2; i < patch.size(); ++i) {
    const std::string& line = patch[i];
    if (line.starts_with("@@")) {
      const auto first = static_cast<std::size_t>(number_behind(line, '-'));
      const bool is_empty = line.find(",0 +") != std::string::npos;
      const std::size_t begin = is_empty ? first : first - 1;
      EXPECT_LE(next, begin);
      while (next < begin) result += old[next++];
      continue;
    }
    std::string content = line.substr(1);
    if (i + 1 < patch.size() && patch[i + 1].starts_with('\\')) content.pop_back();
    if (line[0] == '\\') continue;
    if (line[0] != '+') {
      EXPECT_EQ(content, next < old.size() ? old[next] : "nothing");
    }
    if (line[0] != '-') result += content;
    if (line[0] != '+') ++next;
  }
  while (next < old.size()) result += old[next++];
  return result;
}

TEST(LineDiff, OfTheSameTextIsEmpty) {
  EXPECT_EQ(diff("a\nb\n", "a\nb\n"), "");
  EXPECT_EQ(diff("", ""), "");
}

TEST(LineDiff, HasThreeLinesAroundAChange) {
  EXPECT_EQ(diff("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n"),
            "--- old\n+++ new\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
}

TEST(LineDiff, SaysWhereLinesWereAddedToNothing) {
  EXPECT_EQ(diff("", "a\nb\n"), "--- old\n+++ new\n@@ -0,0 +1,2 @@\n+a\n+b\n");
  EXPECT_EQ(diff("a\nb\n", ""), "--- old\n+++ new\n@@ -1,2 +0,0 @@\n-a\n-b\n");
}

TEST(LineDiff, JoinsChangesThatShareTheirSurroundings) {
  const std::string near = diff("1\n2\n3\n4\n5\n6\n7\n", "one\n2\n3\n4\n5\n6\nseven\n");
  EXPECT_EQ(near.find("@@ -", near.find("@@ -") + 1), std::string::npos) << near;
}

TEST(LineDiff, PartsChangesThatAreFarFromEachOther) {
  const std::string far = diff("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "one\n2\n3\n4\n5\n6\n7\n8\nnine\n");
  EXPECT_THAT(far, HasSubstr("@@ -1,4 +1,4 @@\n-1\n+one\n 2\n 3\n 4\n"));
  EXPECT_THAT(far, HasSubstr("@@ -6,4 +6,4 @@\n 6\n 7\n 8\n-9\n+nine\n"));
}

TEST(LineDiff, SaysThatALastLineBreakIsMissing) {
  EXPECT_EQ(diff("a\n", "a"),
            "--- old\n+++ new\n@@ -1,1 +1,1 @@\n-a\n+a\n\\ No newline at end of file\n");
  EXPECT_THAT(diff("x\na", "y\na"), HasSubstr(" a\n\\ No newline at end of file\n"));
}

TEST(LineDiff, KeepsWhatBothTextsHaveInCommon) {
  EXPECT_EQ(diff("a\nb\nc\n", "b\nc\nd\n"), "--- old\n+++ new\n@@ -1,3 +1,3 @@\n-a\n b\n c\n+d\n");
}

TEST(LineDiff, ComparesTextsThatDifferInVeryManyLinesAsAWhole) {
  std::string before;
  std::string after;
  for (int i = 0; i < 4100; ++i) {
    before += "b" + std::to_string(i % 7) + '\n';
    after += "a" + std::to_string(i % 5) + '\n';
  }
  const std::string text = diff("same\n" + before, "same\n" + after);
  EXPECT_THAT(text, HasSubstr("@@ -1,4101 +1,4101 @@\n same\n-b0\n"));
  EXPECT_EQ(patched("same\n" + before, text), "same\n" + after);
}

/// Few lines over few words, so that texts have much in common.
std::string random_text(std::mt19937_64& random) {
  std::string text;
  const auto count = random() % 14;
  for (std::size_t i = 0; i < count; ++i) text += std::string(1, "abc"[random() % 3]) + '\n';
  if (!text.empty() && random() % 4 == 0) text.pop_back();
  return text;
}

TEST(LineDiff, MakesTheOneTextOfTheOther) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 600; ++i) {
    const std::string before = random_text(random);
    const std::string after = random_text(random);
    const std::string text = diff(before, after);
    if (before == after) continue;
    ASSERT_EQ(patched(before, text), after) << text;
  }
}

TEST(LineDiff, TurnedRoundMakesTheTextThatWasThere) {
  std::mt19937_64 random(12);
  for (int i = 0; i < 200; ++i) {
    const std::string before = random_text(random);
    const std::string after = random_text(random);
    if (before != after) {
      ASSERT_EQ(patched(after, diff(after, before)), before);
    }
  }
}

TEST(LineDiff, ChangesNoMoreLinesThanItMust) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 200; ++i) {
    std::vector<std::string> lines = lines_of(random_text(random));
    if (lines.empty()) continue;
    std::string before;
    for (const std::string& line : lines) before += line;
    if (!before.ends_with('\n')) continue;
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(random() % (lines.size() + 1)), "z\n");
    std::string after;
    for (const std::string& line : lines) after += line;
    const std::string text = diff(before, after);
    EXPECT_THAT(text, HasSubstr("\n+z\n"));
    EXPECT_THAT(text.substr(8), Not(HasSubstr("\n-"))) << text;
  }
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/java/java_regex.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace jaywalk::actions {
namespace {

std::string replaced(std::string_view pattern, std::string_view text, std::string_view by) {
  std::string error;
  const std::optional<Regex> regex = Regex::parse(pattern, error);
  if (!regex) return "error";
  return regex->replace_all(text, by, error).value_or("error");
}

TEST(JavaRegex, ReplacesMatches) {
  struct Row {
    std::string pattern, text, by, expected;
  };
  const std::vector<Row> rows{
      {"an", "banana", "AN", "bANANa"},
      {"a*", "baac", "x", "xbxxcx"},
      {"a+?", "aab", "x", "xxb"},
      {"a{2}", "aaaa", "x", "xx"},
      {"a{2,}", "aaaab", "x", "xb"},
      {"a{1,2}", "aaa", "x", "xx"},
      {"a|ab", "abab", "x", "xbxb"},
      {"(?:a|b)+", "abcab", "x", "xcx"},
      {"(a)(b)?", "ab a", "[$1$2]", "[ab] [a]"},
      {"[^a-c]", "abcd-", "x", "abcxx"},
      {"[a\\-z]", "a-bz", "x", "xxbx"},
      {"[]a]", "a]b", "x", "xxb"},
      {"\\d+\\s", "12 3", "x", "x3"},
      {"\\W", "a-b", "x", "axb"},
      {"[\\D]", "1a2", "x", "1x2"},
      {"^a|a$", "aaa", "x", "xax"},
      {"\\ba", "a ba a", "x", "x ba x"},
      {"(?i)AB", "xaBx", "-", "x-x"},
      {"\\Qa.b\\E", "a.b acb", "x", "x acb"},
      {"\\p{Upper}+", "aBCd", "x", "axd"},
      {".", "\u00e4\n", "x", "x\n"},
      {"\u00e4", "a\u00e4", "x", "ax"},
      {"\\.", "a.b", "\\$", "a$b"},
      {"", "ab", "-", "-a-b-"},
      {"(a)(?=b)", "abac", "<$1>", "<a>bac"},
      {"(?<!x)a", "xa a", "-", "xa -"},
      {"(.)\\1", "abba", "-", "a-a"},
      {"(.)(.)(.)(.)(.)(.)(.)(.)(.)(.)\\10", "abcdefghijj", "-", "-"},
      {"(a)\\11", "aa1", "-", "-"},
      {"(a)", "a", "$12", "a2"},
      {"(?<word>\\w+) x", "ab x", "${word}!", "ab!"},
      {"a++a|b", "aaab", "-", "aaa-"},
      {"\\u00e4\\x41", "\u00e4A", "-", "-"},
      {"\\p{Lu}", "a\u00c4B", "-", "a--"},
      {"\\p{IsGreek}|\\P{ASCII}", "a\u03b1\u00e4", "-", "a--"},
      {"[\\p{Punct}x]", "a.x", "-", "a--"},
      {"\\h|\\R", "a \r\nb", "-", "a--b"},
      {"(?s).(?-s).", "\n\n", "-", "\n\n"},
      {"(?m)^", "a\nb", "-", "-a\n-b"},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(replaced(row.pattern, row.text, row.by), row.expected) << row.pattern;
  }
}

TEST(JavaRegex, RefusesWhatIsWrongOrUnsupported) {
  for (const std::string pattern :
       {"(",         ")",      "[",      "a{",        "a{2,1}", "*",
        "\\",        "(a)\\2", "[a[b]]", "[a&&b]",    "a{,2}",  "a{b}",
        "(?x)a",     "(?R)",   "(?|a)",  "(*FAIL)",   "\\C",    "\\K",
        "\\G",       "^*",     "\\g1",   "(?<=a*)b",  "[\\b]",  "\\u12",
        "\\p{Upper", "\xff",   "[b-a]",  "\\p{Nope}", "\\y",    "((a{1000}){1000}){1000}"}) {
    EXPECT_EQ(replaced(pattern, "text", ""), "error") << pattern;
  }
  EXPECT_EQ(replaced(std::string(5000, '('), "text", ""), "error");
  EXPECT_EQ(replaced("a", "a", "$1"), "error");
  EXPECT_EQ(replaced("a", "a", "$"), "error");
  EXPECT_EQ(replaced("a", "a", "${b}"), "error");
  EXPECT_EQ(replaced("a", "a", "\\"), "error");
}

TEST(JavaRegex, NamesThePlaceOfAMistake) {
  for (const auto& [pattern, message] : {
           std::pair{"a[bc", "unclosed character class near index 4"},
           {"ab{x}", "illegal repetition near index 2"},
           {"ab\\y", "illegal escape sequence near index 2"},
           {"(?<a>b", "missing closing parenthesis near index 6"},
       }) {
    std::string error;
    EXPECT_FALSE(Regex::parse(pattern, error));
    EXPECT_EQ(error, message) << pattern;
  }
}

TEST(JavaRegex, EndsWithAnErrorAfterManySteps) {
  const std::string text(20'000, 'a');
  EXPECT_EQ(replaced("(a|b)*", text, "x"), "xx");
  std::string error;
  const std::optional<Regex> regex = Regex::parse("(a*)*[cd]", error);
  EXPECT_FALSE(regex->replace_all(text, "x", error));
  EXPECT_EQ(error, "the search takes too many steps");
  EXPECT_FALSE(regex->matches(text, error));
}

TEST(JavaRegex, RefusesTextsThatAreNotUtf8) {
  std::string error;
  EXPECT_FALSE(Regex::parse("a", error)->replace_all("a\xff", "x", error));
  EXPECT_EQ(error, "the text is not UTF-8");
}

TEST(JavaRegex, RefusesTooLongResults) {
  std::string error;
  const std::string text(20'000, 'a');
  EXPECT_FALSE(Regex::parse("a", error)->replace_all(text, text, error));
  EXPECT_EQ(error, "the text is longer than 64 MB");
}

TEST(JavaRegex, MatchesWholeTexts) {
  std::string error;
  EXPECT_TRUE(Regex::parse(".*[.]asl", error)->matches("bob.asl", error));
  EXPECT_FALSE(Regex::parse("b", error)->matches("bob", error));
  EXPECT_TRUE(Regex::parse("a|ab", error)->matches("ab", error));
}

TEST(JavaRegex, CanBeInterrupted) {
  std::string error;
  std::optional<Regex> regex = Regex::parse("(a*)*(a*)*[bc]", error);
  ASSERT_TRUE(regex) << error;
  struct Enough {};
  int looks = 0;
  regex->watch([&looks] {
    if (++looks == 3) throw Enough{};
  });
  EXPECT_THROW((void)regex->matches(std::string(1'000'000, 'a'), error), Enough);
}

}  // namespace
}  // namespace jaywalk::actions

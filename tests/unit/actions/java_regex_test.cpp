#include "interpreter/actions/java/java_regex.h"

#include <string>
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
  };
  for (const Row& row : rows) {
    EXPECT_EQ(replaced(row.pattern, row.text, row.by), row.expected) << row.pattern;
  }
}

TEST(JavaRegex, RefusesWhatIsWrongOrUnsupported) {
  for (const std::string pattern : {"(", ")", "[", "a{", "a{2,1}", "*", "\\", "(?=a)", "(a)\\1",
                                    "[b-a]", "\\p{Nope}", "\\y", "((a{1000}){1000}){1000}"}) {
    EXPECT_EQ(replaced(pattern, "text", ""), "error") << pattern;
  }
  EXPECT_EQ(replaced(std::string(5000, '('), "text", ""), "error");
  EXPECT_EQ(replaced("a", "a", "$1"), "error");
  EXPECT_EQ(replaced("a", "a", "$"), "error");
}

TEST(JavaRegex, TakesLinearTime) {
  const std::string text(20'000, 'a');
  EXPECT_EQ(replaced("(a*)*c", text.substr(0, 300), "x"), text.substr(0, 300));
  EXPECT_EQ(replaced("(a|b)*", text, "x"), "xx");
}

TEST(JavaRegex, MatchesWholeTexts) {
  std::string error;
  EXPECT_TRUE(Regex::parse(".*[.]asl", error)->matches("bob.asl"));
  EXPECT_FALSE(Regex::parse("b", error)->matches("bob"));
  EXPECT_TRUE(Regex::parse("a|ab", error)->matches("ab"));
}

TEST(JavaRegex, CanBeInterrupted) {
  std::string error;
  std::optional<Regex> regex = Regex::parse("(a*)*(a*)*b", error);
  ASSERT_TRUE(regex) << error;
  struct Enough {};
  int looks = 0;
  regex->watch([&looks] {
    if (++looks == 3) throw Enough{};
  });
  EXPECT_THROW((void)regex->matches(std::string(1'000'000, 'a')), Enough);
}

}  // namespace
}  // namespace jaywalk::actions

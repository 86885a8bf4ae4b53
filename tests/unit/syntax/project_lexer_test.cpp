// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/project/project_lexer.h"

#include <array>
#include <memory>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::HasSubstr;

/// The tokens as `word MAS`, one behind another, and what is wrong with the text.
struct Lexed {
  explicit Lexed(std::string text)
      : source(std::make_shared<const Source>("p.mas2j", std::move(text))) {
    constexpr std::array kKinds{"end", "word", "number", "string", "path", "symbol", "bad"};
    tokens = project_tokens(source, diagnostics);
    for (const ProjectToken& token : tokens) {
      if (token.kind == ProjectTokenKind::end_of_text) continue;
      shown += fmt::format("{}{} {}", shown.empty() ? "" : ", ",
                           kKinds[static_cast<std::size_t>(token.kind)], token.text);
    }
  }

  SourcePtr source;
  Diagnostics diagnostics;
  std::vector<ProjectToken> tokens;
  std::string shown;
};

std::string shown(const std::string& text) {
  const Lexed lexed(text);
  EXPECT_TRUE(lexed.diagnostics.empty()) << lexed.diagnostics.render();
  return lexed.shown;
}

TEST(ProjectTokens, AreWordsSymbolsAndNumbers) {
  EXPECT_EQ(shown("MAS m1 {agents: a #2;"),
            "word MAS, word m1, symbol {, word agents, symbol :, word a, symbol #, number 2, "
            "symbol ;");
}

TEST(ProjectTokens, AreNumbersOfEachKind) {
  EXPECT_EQ(shown("1 2.5 .5 1e3 2.5E-2 7e+1"),
            "number 1, number 2.5, number .5, number 1e3, number 2.5E-2, number 7e+1");
}

TEST(ProjectTokens, DoNotTakeAPointForANumber) {
  EXPECT_EQ(shown("a.b"), "word a, symbol ., word b");
  EXPECT_EQ(shown("1.a"), "number 1, symbol ., word a");
  EXPECT_EQ(shown("2e"), "number 2, word e");
}

TEST(ProjectTokens, AreStringsWithTheirQuotes) {
  EXPECT_EQ(shown(R"("a b" "say \"x\"" "")"), R"(string "a b", string "say \"x\"", string "")");
}

TEST(ProjectTokens, AreFoldersOfPaths) {
  EXPECT_EQ(shown("./src/a.asl"), "path ./src/, word a, symbol ., word asl");
  EXPECT_EQ(shown("/opt/agents/b"), "path /opt/agents/, word b");
  EXPECT_EQ(shown("C:\\agents\\c"), "path C:\\agents\\, word c");
  EXPECT_EQ(shown("c:x"), "word c, symbol :, word x") << "no drive without a slash";
}

TEST(ProjectTokens, PassOverBlanksAndComments) {
  EXPECT_EQ(shown("a // b { }\n/* c\n d */ e"), "word a, word e");
  EXPECT_EQ(shown(""), "");
  EXPECT_EQ(shown("// only this"), "");
}

TEST(ProjectTokens, EndWithTheBraceThatCloses) {
  const Lexed lexed("MAS m { } trailing words");
  EXPECT_EQ(lexed.shown, "word MAS, word m, symbol {, symbol }");
  EXPECT_THAT(lexed.diagnostics.render(), HasSubstr("what stands behind the project is left out"));
  EXPECT_EQ(lexed.diagnostics.warning_count(), 1U);
}

TEST(ProjectTokens, MayBeFollowedByACommentWithoutAWarning) {
  EXPECT_EQ(shown("{}\n// the end\n"), "symbol {, symbol }");
}

TEST(ProjectTokens, StandWhereTheyAreWritten) {
  const Lexed lexed("ab \"cd\"");
  EXPECT_EQ(lexed.tokens[0].span.begin, 0U);
  EXPECT_EQ(lexed.tokens[0].span.end, 2U);
  EXPECT_EQ(lexed.tokens[1].span.begin, 3U);
  EXPECT_EQ(lexed.tokens[1].span.end, 7U);
  EXPECT_EQ(lexed.tokens.back().kind, ProjectTokenKind::end_of_text);
}

TEST(ProjectErrors, NameAStringThatIsNotClosed) {
  const Lexed lexed("a \"open\nb");
  EXPECT_EQ(lexed.diagnostics.error_count(), 1U);
  EXPECT_THAT(lexed.diagnostics.render(),
              HasSubstr("p.mas2j:1:3: error: this string is not closed on its line"));
  EXPECT_THAT(lexed.shown, HasSubstr("word b")) << "the next line is read all the same";
}

TEST(ProjectErrors, NameACommentThatIsNotClosed) {
  const Lexed lexed("a /* b");
  EXPECT_THAT(lexed.diagnostics.render(),
              HasSubstr("p.mas2j:1:3: error: this comment is not closed"));
}

TEST(ProjectErrors, NameACharacterThatIsNone) {
  const Lexed lexed("a é ! b");
  EXPECT_EQ(lexed.diagnostics.error_count(), 2U) << "one for each character, not for each byte";
  EXPECT_EQ(lexed.shown, "word a, bad é, bad !, word b");
}

}  // namespace
}  // namespace jaywalk

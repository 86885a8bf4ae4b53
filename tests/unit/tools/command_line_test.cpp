// SPDX-License-Identifier: Apache-2.0
// Where errors of options are shown.

#include "tools/jaywalk/options/command_line.h"

#include <array>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {
namespace {

using testing::StartsWith;

constexpr std::array kKnownOptions = {OptionSpec{option::kSeed, "N", ""},
                                      OptionSpec{option::kSet, "KEY=VALUE", ""},
                                      OptionSpec{option::kQuiet, "", ""}};

CommandLine line_of(const std::vector<std::string>& words) { return {words, kKnownOptions}; }

/// The line with a caret that an error of this subject is shown with; empty: none.
std::string marked(const std::vector<std::string>& words, const std::string& subject,
                   const std::string& message = "wrong") {
  Diagnostics diagnostics;
  diagnostics.error(subject, message);
  const std::string text = line_of(words).render(diagnostics, Colour::off);
  EXPECT_THAT(text, StartsWith(subject + ": error: " + message + "\n"));
  return text.substr(text.find('\n') + 1);
}

TEST(CommandLine, ShowsTheValueOfAnOption) {
  EXPECT_EQ(marked({"run", "a.asl", "--seed", "-1"}, "--seed"),
            "  jaywalk run a.asl --seed -1\n"
            "                           ^~\n");
  EXPECT_EQ(marked({"run", "--seed=-1", "a.asl"}, "--seed"),
            "  jaywalk run --seed=-1 a.asl\n"
            "                     ^~\n");
}

TEST(CommandLine, ShowsTheOptionWhereItHasNoValue) {
  EXPECT_EQ(marked({"run", "--quiet", "a.asl"}, "--quiet"),
            "  jaywalk run --quiet a.asl\n"
            "              ^~~~~~~\n");
  EXPECT_EQ(marked({"run", "--seed"}, "--seed"),
            "  jaywalk run --seed\n"
            "              ^~~~~~\n");
  EXPECT_EQ(marked({"run", "--sede", "3"}, "--sede"),
            "  jaywalk run --sede 3\n"
            "              ^~~~~~\n");
}

TEST(CommandLine, ShowsTheItemThatTheMessageQuotes) {
  EXPECT_EQ(marked({"run", "--seed", "1..3,x,9"}, "--seed", "expected a number, found 'x'"),
            "  jaywalk run --seed 1..3,x,9\n"
            "                          ^\n");
  EXPECT_EQ(marked({"run", "--seed", "1..3,x"}, "--seed", "not '4'"),
            "  jaywalk run --seed 1..3,x\n"
            "                     ^~~~~~\n");
}

TEST(CommandLine, ShowsTheRightOneOfSeveral) {
  EXPECT_EQ(marked({"run", "--set", "a=1", "--set", "b=2"}, "--set a=1"),
            "  jaywalk run --set a=1 --set b=2\n"
            "                    ^~~\n");
  EXPECT_EQ(marked({"run", "--seed", "x", "--seed", "y"}, "--seed"),
            "  jaywalk run --seed x --seed y\n"
            "                              ^\n");
}

TEST(CommandLine, QuotesWordsAsAShellNeedsThem) {
  EXPECT_EQ(marked({"run", "my file.asl", "--seed", "a b\n"}, "--seed"),
            "  jaywalk run 'my file.asl' --seed 'a b?'\n"
            "                                    ^~~~\n");
  EXPECT_EQ(marked({"run", "--seed", ""}, "--seed"),
            "  jaywalk run --seed ''\n"
            "                      ^\n");
}

TEST(CommandLine, HasNoPlaceOfOthers) {
  EXPECT_EQ(marked({"run", "a.asl"}, "a.asl"), "");
  EXPECT_EQ(marked({"run", "a.asl"}, "--seed"), "");
  EXPECT_EQ(marked({"run", "--", "--seed"}, "--seed"), "") << "an operand";
  Diagnostics diagnostics;
  diagnostics.error("--seed", "wrong", "do it right");
  EXPECT_EQ(CommandLine().render(diagnostics, Colour::off), diagnostics.render());
}

TEST(CommandLine, ShowsEachOfSeveralErrorsAboveItsHint) {
  Diagnostics diagnostics;
  diagnostics.error("--seed", "wrong", "do it right");
  diagnostics.error("a.asl", "no such file");
  diagnostics.error("--set x", "odd");
  EXPECT_EQ(line_of({"run", "--seed", "1", "--set", "x"}).render(diagnostics, Colour::off),
            "--seed: error: wrong\n"
            "  jaywalk run --seed 1 --set x\n"
            "                     ^\n"
            "  hint: do it right\n"
            "a.asl: error: no such file\n"
            "--set x: error: odd\n"
            "  jaywalk run --seed 1 --set x\n"
            "                             ^\n");
}

}  // namespace
}  // namespace jaywalk

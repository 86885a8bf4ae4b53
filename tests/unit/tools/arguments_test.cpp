// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/arguments.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::array kOptions = {OptionSpec{option::kSeed, "N", ""},
                                 OptionSpec{option::kSet, "KEY=VALUE", "repeatable"},
                                 OptionSpec{option::kQuiet, "", ""}};

Result<Arguments> parse(std::vector<std::string> words) { return parse_arguments(words, kOptions); }

TEST(Arguments, TakeOptionsAnywhereAndInBothForms) {
  const auto arguments = parse({"a.yaml", "--seed", "3", "b.yaml", "--set=x=1", "--quiet"});
  ASSERT_TRUE(arguments);
  EXPECT_THAT(arguments.value().operands(), ElementsAre("a.yaml", "b.yaml"));
  EXPECT_EQ(arguments.value().text(option::kSeed), "3");
  EXPECT_EQ(arguments.value().text(option::kSet), "x=1");
  EXPECT_TRUE(arguments.value().has(option::kQuiet));
}

TEST(Arguments, EndOptionsAtTwoDashes) {
  const auto arguments = parse({"--quiet", "--", "--seed", "-x"});
  ASSERT_TRUE(arguments);
  EXPECT_THAT(arguments.value().operands(), ElementsAre("--seed", "-x"));
  EXPECT_FALSE(arguments.value().has(option::kSeed));
}

TEST(Arguments, KeepRepeatedOptionsInOrderAndTheLastAsTheValue) {
  const auto arguments = parse({"--set", "a=1", "--set", "b=2"});
  ASSERT_TRUE(arguments);
  EXPECT_THAT(arguments.value().texts(option::kSet), ElementsAre("a=1", "b=2"));
  EXPECT_EQ(arguments.value().text(option::kSet), "b=2");
}

TEST(Arguments, KeepEmptyValuesAndOperands) {
  const auto arguments = parse({"", "--set", ""});
  ASSERT_TRUE(arguments);
  EXPECT_THAT(arguments.value().operands(), ElementsAre(""));
  EXPECT_EQ(arguments.value().text(option::kSet), "");
}

TEST(Arguments, RefuseWhatIsNoOption) {
  struct Case {
    std::vector<std::string> words;
    const char* message;
  };
  for (const Case& c :
       {Case{{"--sed", "1"}, "did you mean '--seed'?"}, Case{{"--see", "1"}, "unknown option"},
        Case{{"--xyzzy"}, "--help names the options"}, Case{{"-q"}, "unknown option"},
        Case{{"--sed=1"}, "--sed: error: unknown option\n  hint: did you mean '--seed'?"},
        Case{{"--seed"}, "needs a value"}, Case{{"--quiet=1"}, "takes no value"}}) {
    const auto arguments = parse(c.words);
    ASSERT_FALSE(arguments.ok()) << c.words.front();
    EXPECT_THAT(arguments.diagnostics().render(), HasSubstr(c.message)) << c.words.front();
  }
}

TEST(Arguments, ReadWholeNumbersFromALowerBound) {
  Diagnostics diagnostics;
  EXPECT_EQ(parse({"--seed", "18446744073709551615"}).value().number(option::kSeed, 0, diagnostics),
            18446744073709551615U);
  EXPECT_EQ(parse({}).value().number(option::kSeed, 0, diagnostics), std::nullopt);
  EXPECT_TRUE(diagnostics.empty());
  for (const char* text : {"0", "-1", "1.5", "1e3", "", " 1", "18446744073709551616"}) {
    Diagnostics wrong;
    EXPECT_EQ(parse({"--seed", text}).value().number(option::kSeed, 1, wrong), std::nullopt)
        << text;
    EXPECT_EQ(wrong.error_count(), 1U) << text;
  }
}

TEST(Arguments, ReadPositiveNumbers) {
  Diagnostics diagnostics;
  EXPECT_EQ(parse({"--seed", "0.5"}).value().positive(option::kSeed, diagnostics), 0.5);
  for (const char* text : {"0", "-1", "inf", "nan", "x", "1s"}) {
    Diagnostics wrong;
    EXPECT_EQ(parse({"--seed", text}).value().positive(option::kSeed, wrong), std::nullopt) << text;
    EXPECT_EQ(wrong.error_count(), 1U) << text;
  }
}

}  // namespace
}  // namespace jaywalk

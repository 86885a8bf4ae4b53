// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/remarks.h"

#include <string>

#include <gtest/gtest.h>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {
namespace {

SourcePtr source_of(std::string text) {
  return std::make_shared<const Source>("test", std::move(text));
}

TEST(Silenced, IsTheLineOfTheCommentAndTheNext) {
  const auto source = source_of("a. // jaywalk: allow one, two\nb.\nc.");
  EXPECT_TRUE(is_silenced(*source, 0, "one"));
  EXPECT_TRUE(is_silenced(*source, 30, "two"));
  EXPECT_FALSE(is_silenced(*source, 33, "one"));
  EXPECT_FALSE(is_silenced(*source, 0, "three"));
}

TEST(Silenced, IsTheWholeFileIfTheCommentSaysSo) {
  const auto source = source_of("a.\n\n// jaywalk: allow-file one\n");
  EXPECT_TRUE(is_silenced(*source, 0, "one"));
  EXPECT_FALSE(is_silenced(*source, 0, "two"));
}

TEST(Silenced, IsNothingByWordsThatAreNoComment) {
  EXPECT_FALSE(is_silenced(*source_of("p(\"jaywalk: allow one\")."), 0, "one"));
  EXPECT_FALSE(is_silenced(*source_of("// jaywalk: allowed one"), 0, "one"));
  EXPECT_FALSE(is_silenced(*source_of("// jaywalk: allow"), 0, ""));
}

TEST(Remarks, TakeWordsBehindTheLastItemForAReason) {
  const auto source = source_of("// jaywalk: allow one,two since it is told\r\n");
  const auto found = remarks(*source);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].item, "one");
  EXPECT_EQ(found[1].item, "two");
  EXPECT_EQ(found[1].line, 1U);
  EXPECT_TRUE(found[1].allows());
}

TEST(Remarks, KeepAWordThatIsUnknown) {
  const auto source = source_of("// jaywalk: alow one\n// jaywalk: asks\n");
  const auto found = remarks(*source);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(source->text(found[0].word_span), "alow");
  EXPECT_FALSE(found[0].allows());
  EXPECT_EQ(found[1].word, Remark::kAsks);
  EXPECT_EQ(found[1].item, "");
}

TEST(Remarks, AskForBeliefsAndGoals) {
  const auto belief = asked_name("bid/1");
  ASSERT_TRUE(belief);
  EXPECT_EQ(belief->name, "bid");
  EXPECT_EQ(belief->arity, 1);
  EXPECT_FALSE(belief->is_goal);
  const auto goal = asked_name("!cross/2");
  ASSERT_TRUE(goal);
  EXPECT_EQ(goal->name, "cross");
  EXPECT_EQ(goal->arity, 2);
  EXPECT_TRUE(goal->is_goal);
}

TEST(Remarks, TakeNothingForANameWithoutItsNumberOfArguments) {
  for (const char* item :
       {"", "bid", "bid/", "/1", "bid/x", "bid/-1", "!", "bid/1x", "bid/99999999999"}) {
    EXPECT_FALSE(asked_name(item)) << item;
  }
}

TEST(Diagnostics, LeaveOutWarningsThatACommentSilences) {
  Diagnostics diagnostics;
  const auto source = source_of("a. // jaywalk: allow one\n");
  diagnostics.warning({source, {0, 1}}, "one", "silenced");
  EXPECT_TRUE(diagnostics.empty());
  EXPECT_EQ(diagnostics.warning_count(), 0U);
  diagnostics.warning({source, {0, 1}}, "two", "told");
  EXPECT_EQ(diagnostics.warning_count(), 1U);
}

}  // namespace
}  // namespace jaywalk

#include "interpreter/support/silenced.h"

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

TEST(Silenced, TakesWordsBehindTheLastCommaForAReason) {
  const auto source = source_of("// jaywalk: allow one,two since it is told\r\n");
  const auto codes = allowed_codes(*source);
  ASSERT_EQ(codes.size(), 2U);
  EXPECT_EQ(codes[0].code, "one");
  EXPECT_EQ(codes[1].code, "two");
  EXPECT_EQ(codes[1].line, 1U);
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

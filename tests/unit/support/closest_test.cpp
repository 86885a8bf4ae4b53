// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {
namespace {

const std::vector<std::string> kNames = {".print", ".println", ".send", ".broadcast", "go"};

TEST(Closest, FindsTheNameThatWasMeant) {
  struct Row {
    const char* written;
    const char* meant;
  };
  for (const auto& [written, meant] : {Row{".prnit", ".print"}, Row{".brodcast", ".broadcast"},
                                       Row{".sned", ".send"}, Row{".printl", ".print"}}) {
    EXPECT_EQ(closest(written, kNames), meant) << written;
  }
}

TEST(Closest, FindsNothingWhereMoreThanAThirdIsWrong) {
  EXPECT_EQ(closest("no", kNames), std::nullopt);
  EXPECT_EQ(closest("quite_another", kNames), std::nullopt);
  EXPECT_EQ(closest("", kNames), std::nullopt);
}

TEST(Closest, PrefersTheFewestChanges) {
  const std::vector<std::string> names = {"abcdeX", "abcdef"};
  EXPECT_EQ(closest("abcdfe", names), "abcdef") << "a transposition is one change";
}

TEST(Closest, DoesNotSuggestTheNameItself) {
  const std::vector<std::string> names = {"counter"};
  EXPECT_EQ(closest("counter", names), std::nullopt);
}

TEST(DidYouMean, AsksOnlyIfThereIsACandidate) {
  EXPECT_EQ(did_you_mean(".prnit", kNames), "did you mean '.print'?");
  EXPECT_EQ(did_you_mean("xyzzy", kNames), "");
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Which files words of the command line mean, and the file that traces go to.

#include <algorithm>
#include <array>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/folder.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/run/trace_output.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Files : public FolderTest {
 protected:
  /// The files that operands mean, of programs and projects.
  std::vector<std::string> expanded(const std::vector<std::string>& operands) {
    constexpr std::array<std::string_view, 2> kEndings{".asl", ".mas2j"};
    std::vector<std::string> files;
    all_ = expand_folders(operands, kEndings, console_, files);
    return files;
  }

  Console console_{ColourChoice::never};
  bool all_ = true;
};

TEST_F(Files, AreTakenAsTheyAreNamed) {
  EXPECT_THAT(expanded({"nowhere.asl", "-", "any.txt"}),
              ElementsAre("nowhere.asl", "-", "any.txt"));
  EXPECT_TRUE(all_) << "whether they exist is the reader's to say";
}

TEST_F(Files, OfAFolderAreThoseWithTheEndings) {
  const std::string b = file("b.asl", "x");
  const std::string a = file("deep/er/a.asl", "x");
  const std::string project = file("c.mas2j", "x");
  (void)file("readme.txt", "x");
  EXPECT_THAT(expanded({path()}), ElementsAre(b, project, a)) << "by name";
}

TEST_F(Files, OfEachFolderStayTogether) {
  const std::string z = file("one/z.asl", "x");
  const std::string a = file("two/a.asl", "x");
  EXPECT_THAT(expanded({path("one"), path("two")}), ElementsAre(z, a));
}

TEST_F(Files, ThatAreHiddenAreLeftOut) {
  (void)file(".hidden.asl", "x");
  (void)file(".git/a.asl", "x");
  const std::string seen = file("seen.asl", "x");
  EXPECT_THAT(expanded({path()}), ElementsAre(seen));
}

TEST_F(Files, MayBeNoneOfAFolder) {
  (void)file("readme.txt", "x");
  testing::internal::CaptureStderr();
  EXPECT_THAT(expanded({path()}), IsEmpty());
  EXPECT_FALSE(all_);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("no file .asl or .mas2j lies there"));
}

TEST_F(Files, AreNoFoldersWithAnEnding) {
  const std::string inner = file("folder.asl/inner.asl", "x");
  EXPECT_THAT(expanded({path()}), ElementsAre(inner));
}

/// The include path of a command line, and what is wrong with it.
struct Included {
  explicit Included(std::vector<std::string> words) {
    path = parse_include_path(parse_arguments(words, kIncludeOptions).value(), diagnostics);
  }
  Diagnostics diagnostics;
  IncludePath path;
};

TEST_F(Files, ToIncludeAreLookedForInFoldersInTheirOrder) {
  (void)file("b/x.asl", "x.");
  (void)file("a/x.asl", "x.");
  const Included included({"--include", path("b"), "--include=" + path("a")});
  EXPECT_THAT(included.path.folders, ElementsAre(path("b"), path("a")));
  EXPECT_TRUE(included.diagnostics.empty());
}

TEST_F(Files, ToIncludeMayHavePrefixes) {
  const Included included({"--map", "$jasonJar=/opt/jason", "--map", "x=a=b", "--map", "y="});
  EXPECT_TRUE(included.diagnostics.empty());
  EXPECT_THAT(included.path.mapped, ElementsAre(std::pair("$jasonJar", "/opt/jason"),
                                                std::pair("x", "a=b"), std::pair("y", "")));
}

TEST_F(Files, ToIncludeHaveNoPrefixWithoutAName) {
  for (const char* mapping : {"folder", "=folder", ""}) {
    const Included included({"--map", mapping});
    EXPECT_EQ(included.diagnostics.error_count(), 1U) << mapping;
    EXPECT_THAT(included.diagnostics.render(), HasSubstr("expected PREFIX=FOLDER"));
    EXPECT_THAT(included.path.mapped, IsEmpty());
  }
}

TEST_F(Files, OfOtherFoldersAreReadOnlyWhereThereAreSuchFolders) {
  EXPECT_TRUE(Included({"--allow-read", path()}).diagnostics.empty());
  const Included included({"--allow-read", path("nowhere")});
  EXPECT_THAT(included.diagnostics.render(), HasSubstr("there is no folder"));
}

TEST_F(Files, OfTracesHaveTheirPartsInTheOrderOfNumbers) {
  TraceFile trace(path("trace.jsonl"));
  trace.add(2, "c\n");
  trace.add(0, "a\n");
  trace.add(1, "b\n");
  trace.add(3, "");
  EXPECT_EQ(trace.finish(), "");
  EXPECT_EQ(text("trace.jsonl"), "a\nb\nc\n");
}

TEST_F(Files, OfTracesKeepWhatCameAfterAGap) {
  TraceFile trace(path("trace.jsonl"));
  trace.add(0, "a\n");
  trace.add(5, "f\n");
  trace.add(3, "d\n");
  EXPECT_EQ(trace.finish(), "");
  EXPECT_EQ(text("trace.jsonl"), "a\nd\nf\n");
}

TEST_F(Files, OfTracesStandInTheirPlaceWhenTheyAreWhole) {
  const std::string name = file("trace.jsonl", "x");
  {
    TraceFile trace(name);
    trace.add(0, "new\n");
    EXPECT_EQ(text("trace.jsonl"), "x") << "what was there before";
  }
  EXPECT_EQ(text("trace.jsonl"), "x") << "it was given up";
  TraceFile trace(name);
  trace.add(0, "new\n");
  EXPECT_EQ(trace.finish(), "");
  EXPECT_EQ(text("trace.jsonl"), "new\n");
}

TEST_F(Files, OfTracesSayWhyTheyCannotBeWritten) {
  TraceFile trace(path("nowhere/trace.jsonl"));
  EXPECT_NE(trace.failure(), "");
  trace.add(0, "a\n");
  EXPECT_NE(trace.finish(), "");
}

TEST_F(Files, OfTracesAreTheSameFromAnyThreads) {
  TraceFile trace(path("trace.jsonl"));
  std::string expected;
  for (int i = 0; i < 40; ++i) expected += std::to_string(i) + '\n';
  std::vector<std::thread> threads;
  for (std::uint64_t first = 0; first < 4; ++first) {
    threads.emplace_back([&trace, first] {
      for (std::uint64_t i = first; i < 40; i += 4) trace.add(i, std::to_string(i) + '\n');
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(trace.finish(), "");
  EXPECT_EQ(text("trace.jsonl"), expected);
}

}  // namespace
}  // namespace jaywalk

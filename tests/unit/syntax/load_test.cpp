// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/load.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "interpreter/support/diagnostics.h"
#include "tests/helpers/folder.h"
#include "tests/unit/syntax/outline.h"

namespace jaywalk {
namespace {

// A folder of its own for each test, for there are no includes without files.
class Load : public FolderTest {
 protected:
  // The files of the tree by their names relative to the folder.
  [[nodiscard]] std::string files_of(const SourceTree& tree) const {
    std::string names;
    for (const auto& file : tree.files) {
      const auto relative = std::filesystem::path(file->source->name()).lexically_relative(path());
      names += relative.generic_string() + " ";
    }
    return names;
  }

  Diagnostics diagnostics_;
};

TEST_F(Load, ReadsIncludedFilesFromTheFolderOfTheIncludingOne) {
  const std::string start = file("main.asl", "{ include(\"lib/a.asl\") } b.");
  file("lib/a.asl", "{ include(\"b.asl\") } a.");
  file("lib/b.asl", "c.");
  const SourceTree tree = load_agent(start, {}, diagnostics_);
  EXPECT_TRUE(diagnostics_.empty()) << diagnostics_.render();
  EXPECT_EQ(files_of(tree), "main.asl lib/a.asl lib/b.asl ");
  const ast::File* const included = tree.includes.at(&tree.main().components.front());
  EXPECT_EQ(included, tree.files[1].get());
  EXPECT_EQ(outline(*tree.includes.at(&included->components.front())), "belief c\n");
}

TEST_F(Load, FindsIncludesWithinBlocks) {
  file("a.asl", "a.");
  const std::string start =
      file("main.asl", "{ begin namespace(n) } { include(\"a.asl\") } { end }");
  const SourceTree tree = load_agent(start, {}, diagnostics_);
  EXPECT_EQ(files_of(tree), "main.asl a.asl ");
}

TEST_F(Load, LooksInTheGivenFoldersInOrder) {
  file("one/x.asl", "in(one).");
  file("two/x.asl", "in(two).");
  file("two/y.asl", "in(two).");
  const std::string start = file("main.asl", "{ include(\"x.asl\") } { include(\"y.asl\") }");
  const IncludePath folders = {.folders = {path("one"), path("two")}, .mapped = {}};
  EXPECT_EQ(files_of(load_agent(start, folders, diagnostics_)), "main.asl one/x.asl two/y.asl ");
}

TEST_F(Load, MapsPrefixesToFolders) {
  file("jason/asl/meta.asl", "m.");
  const std::string start = file("main.asl", "{ include(\"$jasonJar/asl/meta.asl\") }");
  const IncludePath mapped = {.folders = {}, .mapped = {{"$jasonJar", path("jason")}}};
  EXPECT_EQ(files_of(load_agent(start, mapped, diagnostics_)), "main.asl jason/asl/meta.asl ");
  EXPECT_TRUE(diagnostics_.empty());

  (void)load_agent(start, {}, diagnostics_);
  ASSERT_EQ(diagnostics_.warning_count(), 1U);
  EXPECT_EQ(diagnostics_.items().front().hint, "say where it is with --map '$jasonJar=FOLDER'");
}

TEST_F(Load, FindsInstalledProgramsByTheirNames) {
  file("lib/crossing/shared/a.asl", "{ include(\"b.asl\") } a.");
  file("lib/crossing/shared/b.asl", "b.");
  IncludePath installed;
  installed.files = SourceFiles(path("lib"));
  const std::string start = file("main.asl", "{ include(\"$jaywalk/crossing/shared/a.asl\") }");
  const SourceTree tree = load_agent(start, installed, diagnostics_);
  EXPECT_TRUE(diagnostics_.empty()) << diagnostics_.render();
  ASSERT_EQ(tree.files.size(), 3U);
  EXPECT_EQ(tree.files[2]->source->name(), "$jaywalk/crossing/shared/b.asl");

  const std::string slip = file("slip.asl", "{ include(\"$jaywalk/crossing/shared/c.asl\") }");
  (void)load_agent(slip, installed, diagnostics_);
  ASSERT_EQ(diagnostics_.warning_count(), 1U);
  EXPECT_EQ(diagnostics_.items().front().code, "missing-include");
  EXPECT_NE(diagnostics_.items().front().hint.find("$jaywalk/crossing/shared/a.asl"),
            std::string::npos);
}

TEST_F(Load, TakesInstalledProgramsForThoseThatAreNotBesideACopy) {
  file("lib/crossing/shared/a.asl", "a(installed).");
  IncludePath installed;
  installed.files = SourceFiles(path("lib"));
  const std::string start = file("main.asl", "{ include(\"shared/a.asl\") }");
  const SourceTree tree = load_agent(start, installed, diagnostics_);
  ASSERT_EQ(tree.files.size(), 2U);
  EXPECT_EQ(tree.files[1]->source->name(), "$jaywalk/crossing/shared/a.asl");
  ASSERT_EQ(diagnostics_.items().size(), 1U);
  EXPECT_EQ(diagnostics_.items().front().severity, Severity::note);
  EXPECT_EQ(diagnostics_.warning_count(), 0U);

  file("shared/a.asl", "a(own).");
  EXPECT_EQ(files_of(load_agent(start, installed, diagnostics_)), "main.asl shared/a.asl ");
}

TEST_F(Load, MakesErrorsOfMissingIncludesWhereTheyAreWanted) {
  const std::string start = file("main.asl", "{ include(\"none.asl\") } b.");
  (void)load_agent(start, {}, diagnostics_);
  diagnostics_ = with_errors(diagnostics_, kMissingInclude, kMissingIncludeHint);
  EXPECT_EQ(diagnostics_.error_count(), 1U);
  EXPECT_EQ(diagnostics_.warning_count(), 0U);
  EXPECT_NE(diagnostics_.items().front().hint.find(kMissingIncludeHint), std::string::npos);
}

TEST_F(Load, WarnsOfMissingIncludesAndGoesOn) {
  const std::string start = file("main.asl", "{ include(\"none.asl\") } b.");
  const SourceTree tree = load_agent(start, {}, diagnostics_);
  EXPECT_FALSE(diagnostics_.has_errors());
  ASSERT_EQ(diagnostics_.warning_count(), 1U);
  EXPECT_EQ(diagnostics_.items().front().message, "cannot find 'none.asl', which is included here");
  EXPECT_EQ(diagnostics_.items().front().code, "missing-include");
  EXPECT_TRUE(tree.includes.empty());
  EXPECT_EQ(tree.main().components.size(), 2U);
}

TEST_F(Load, ReadsOtherEncodingsWithAWarning) {
  file("a.asl", "// Jos\xE9\nname(\"Jos\xE9\").");
  const std::string start = file("main.asl", "{ include(\"a.asl\") } p('\xFF').");
  const SourceTree tree = load_agent(start, {}, diagnostics_);
  EXPECT_FALSE(diagnostics_.has_errors());
  ASSERT_EQ(diagnostics_.warning_count(), 2U);
  EXPECT_EQ(diagnostics_.items().front().code, "encoding");
  EXPECT_EQ(diagnostics_.items().front().message,
            "not UTF-8 text: unexpected byte 0xFF at offset 24 (line 1)");
  ASSERT_EQ(tree.files.size(), 2U);
  EXPECT_EQ(tree.files.back()->components.front().literal->args.front()->text, "Jos\uFFFD");
}

TEST_F(Load, RefusesFilesThatIncludeThemselves) {
  const std::string start = file("main.asl", "{ include(\"a.asl\") }");
  file("a.asl", "{ include(\"main.asl\") } { include(\"main.asl\") }");
  const SourceTree tree = load_agent(start, {}, diagnostics_);
  EXPECT_EQ(files_of(tree), "main.asl a.asl ");
  EXPECT_EQ(diagnostics_.error_count(), 2U);
  EXPECT_TRUE(diagnostics_.items().front().message.ends_with("main.asl includes itself"));
}

TEST_F(Load, RefusesTooManyFiles) {
  // Each file includes the next twice.
  for (int i = 0; i < 20; ++i) {
    const std::string next = "{ include(\"f" + std::to_string(i + 1) + ".asl\") } ";
    file("f" + std::to_string(i) + ".asl", next + next);
  }
  const SourceTree tree = load_agent(path("f0.asl"), {}, diagnostics_);
  EXPECT_EQ(tree.files.size(), static_cast<std::size_t>(kMaxIncludedFiles) + 1);
  EXPECT_EQ(diagnostics_.error_count(), 1U);
}

TEST_F(Load, NeedsTheNameOfAFile) {
  (void)load_agent(file("main.asl", "{ include(lib) }"), {}, diagnostics_);
  ASSERT_TRUE(diagnostics_.has_errors());
  EXPECT_EQ(diagnostics_.items().front().message, "include needs the name of a file, a string");
}

TEST_F(Load, GivesAnEmptyProgramIfThereIsNone) {
  const SourceTree tree = load_agent(path("none.asl"), {}, diagnostics_);
  EXPECT_TRUE(diagnostics_.has_errors());
  EXPECT_TRUE(tree.main().components.empty());
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// The files that stores are made of and from: new ones, copies, merged and extended ones.

#include <filesystem>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/export/comparison_files.h"
#include "experiment/results/merge.h"
#include "experiment/results/reader.h"
#include "experiment/results/store/geopackage.h"
#include "experiment/results/store/row_writer.h"
#include "experiment/results/store/schema.h"
#include "experiment/results/store/store_file.h"
#include "experiment/results/writer.h"
#include "tests/unit/experiment_results/experiment_runs.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::unique_ptr<ResultsReader> opened(const std::string& path) {
  auto reader = ResultsReader::open(path);
  EXPECT_TRUE(reader.ok()) << reader.diagnostics().render();
  return std::move(reader).value();
}

std::vector<std::int64_t> ids_of(const std::string& path) {
  std::vector<std::int64_t> ids;
  const std::vector<StoredTest> tests = opened(path)->tests().value();
  for (const StoredTest& test : tests) ids.push_back(test.id);
  return ids;
}

/// Stores of parts of one experiment.
class StoreParts : public StoreTest {
 protected:
  /// The tests from one place of the plan to another.
  std::string part(const std::string& name, std::size_t first, std::size_t last,
                   StoreLevel level = StoreLevel::found) const {
    const std::vector<TestKey> all = cases();
    const auto begin = all.begin();
    write(file(name), description(level),
          {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last)});
    return file(name);
  }
  std::string csv(const std::string& path) const {
    return to_csv(opened(path)->comparison().value());
  }
};

TEST_F(StoreParts, MergedAreTheWholeExperiment) {
  const std::string whole = part("whole.gpkg", 0, 48);
  const auto outcome = merge_stores(
      file("merged.gpkg"), {part("a.gpkg", 0, 20), part("b.gpkg", 20, 40), part("c.gpkg", 40, 48)});
  ASSERT_TRUE(outcome.ok()) << outcome.diagnostics().render();
  EXPECT_EQ(outcome.value().tests, 48U);
  EXPECT_EQ(outcome.value().planned, 48U);
  EXPECT_TRUE(opened(file("merged.gpkg"))->complete());
  EXPECT_EQ(csv(file("merged.gpkg")), csv(whole));
  EXPECT_EQ(opened(file("merged.gpkg"))->recording(30).value(),
            opened(whole)->recording(30).value());
}

TEST_F(StoreParts, MergeAlikeInWhateverOrderTheyAreNamed) {
  const std::string a = part("a.gpkg", 0, 30);
  const std::string b = part("b.gpkg", 30, 48);
  ASSERT_TRUE(merge_stores(file("ab.gpkg"), {a, b}).ok());
  ASSERT_TRUE(merge_stores(file("ba.gpkg"), {b, a}).ok());
  EXPECT_EQ(csv(file("ab.gpkg")), csv(file("ba.gpkg")));
}

TEST_F(StoreParts, MayOverlapWhereTheyAgree) {
  const auto outcome =
      merge_stores(file("merged.gpkg"), {part("a.gpkg", 0, 30), part("b.gpkg", 10, 40)});
  ASSERT_TRUE(outcome.ok()) << outcome.diagnostics().render();
  EXPECT_EQ(outcome.value().tests, 40U) << "each once";
  EXPECT_FALSE(opened(file("merged.gpkg"))->complete());
  EXPECT_EQ(ids_of(file("merged.gpkg")).size(), 40U);
}

TEST_F(StoreParts, DoNotMergeWhereATestCameOutOtherwise) {
  const std::string a = part("a.gpkg", 0, 10);
  {
    auto writer = ResultsWriter::create(file("b.gpkg"), description());
    TestRecord record = run(cases()[5]);
    record.result.score += 1;
    writer.value()->add(std::move(record));
    ASSERT_EQ(writer.value()->finish(), std::nullopt);
  }
  const auto outcome = merge_stores(file("merged.gpkg"), {a, file("b.gpkg")});
  ASSERT_FALSE(outcome.ok());
  EXPECT_THAT(outcome.diagnostics().render(), HasSubstr("test 6 of"));
  EXPECT_THAT(outcome.diagnostics().render(), HasSubstr("came out otherwise in another part"));
  EXPECT_FALSE(std::filesystem::exists(file("merged.gpkg"))) << "whole, or not at all";
}

TEST_F(StoreParts, OfOtherLevelsAreNotMerged) {
  const auto outcome = merge_stores(file("merged.gpkg"),
                                    {part("a.gpkg", 0, 4), part("b.gpkg", 4, 8, StoreLevel::all)});
  EXPECT_THAT(outcome.diagnostics().render(), HasSubstr("the levels are found and all"));
}

TEST_F(StoreParts, MergedTakeThePlaceOfNoFile) {
  const std::string a = part("a.gpkg", 0, 4);
  std::ofstream(file("merged.gpkg")) << "mine";
  EXPECT_THAT(merge_stores(file("merged.gpkg"), {a}).diagnostics().render(),
              HasSubstr("the file exists"));
  EXPECT_EQ(std::filesystem::file_size(file("merged.gpkg")), 4U);
}

TEST_F(StoreParts, OfNothingAreNothing) {
  EXPECT_THAT(merge_stores(file("merged.gpkg"), {}).diagnostics().render(),
              HasSubstr("there is nothing to merge"));
}

TEST_F(StoreParts, SayEachThatCannotBeRead) {
  const auto outcome = merge_stores(file("merged.gpkg"), {file("no.gpkg"), file("none.gpkg")});
  EXPECT_EQ(outcome.diagnostics().error_count(), 2U);
}

TEST_F(StoreParts, CopiedHaveTheTestsOfTheirIdsAlone) {
  const std::string whole = part("whole.gpkg", 0, 48, StoreLevel::all);
  const std::vector<std::int64_t> wanted{3, 40, 7};
  ASSERT_EQ(copy_tests(whole, file("few.gpkg"), wanted), std::nullopt);
  EXPECT_THAT(ids_of(file("few.gpkg")), ElementsAre(3, 7, 40));
  EXPECT_EQ(opened(file("few.gpkg"))->recording(40).value(), opened(whole)->recording(40).value());
  EXPECT_EQ(ids_of(whole).size(), 48U) << "which stays as it is";
}

TEST_F(StoreParts, CopiedOfAKilledProcessHaveWhatIsInItsLog) {
  const std::string whole = part("whole.gpkg", 0, 48);
  {
    auto store = open_to_write(whole, results_store());
    ASSERT_TRUE(store.ok()) << store.diagnostics().render();
    start_log(*store.value());
    store.value()->execute("DELETE FROM tests WHERE id = 7");
    for (const char* end : {"", "-wal"}) {
      std::filesystem::copy_file(whole + end, file("killed.gpkg") + end);
    }
  }
  const std::vector<std::int64_t> wanted{3, 7, 40};
  ASSERT_EQ(copy_tests(file("killed.gpkg"), file("few.gpkg"), wanted), std::nullopt);
  EXPECT_THAT(ids_of(file("few.gpkg")), ElementsAre(3, 40));
}

TEST_F(StoreParts, CopiedDoNotReplaceAFile) {
  const std::string whole = part("whole.gpkg", 0, 4);
  EXPECT_NE(copy_tests(whole, whole, std::vector<std::int64_t>{1}), std::nullopt);
  EXPECT_NE(copy_tests(file("none.gpkg"), file("new.gpkg"), std::vector<std::int64_t>{1}),
            std::nullopt);
  EXPECT_EQ(ids_of(whole).size(), 4U);
}

TEST_F(StoreParts, AreCreatedWholeOrNotAtAll) {
  const auto failure = create_store_file(file("new.db"), [](Database& database) {
    database.execute("CREATE TABLE t (x INTEGER)");
    database.fail("something went wrong");
  });
  ASSERT_TRUE(failure);
  EXPECT_THAT(failure->render(), HasSubstr("something went wrong"));
  EXPECT_TRUE(std::filesystem::is_empty(std::filesystem::path(file("new.db")).parent_path()));
}

TEST_F(StoreParts, AreNotPutWhereAnotherProcessWasFaster) {
  const auto failure = create_store_file(file("new.db"), [&](Database& database) {
    database.execute("CREATE TABLE t (x INTEGER)");
    std::ofstream(file("new.db")) << "mine";
  });
  ASSERT_TRUE(failure);
  EXPECT_THAT(failure->render(), HasSubstr("the file exists"));
  EXPECT_EQ(std::filesystem::file_size(file("new.db")), 4U);
}

TEST_F(StoreParts, AreCreatedByWhatFillsThem) {
  ASSERT_FALSE(create_store_file(file("new.db"), [](Database& database) {
    database.execute("CREATE TABLE t (x INTEGER)");
    database.execute("INSERT INTO t VALUES (7)");
  }));
  Database database(file("new.db"), Database::Mode::read);
  EXPECT_EQ(database.number("SELECT x FROM t"), 7);
}

TEST(AssessmentSpoolTest, GivesBackWhatItWasGivenTestByTest) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const std::vector<AssessmentRow> first{
      {.id = "min_ttc", .value = kInfinite},
      {.id = "away", .tick = 3, .actor = 1, .robustness = -0.5, .verdict = StoredVerdict::fail}};
  const std::vector<AssessmentRow> second{{.id = "away", .verdict = StoredVerdict::vacuous}};
  AssessmentSpool spool;
  spool.add(2, first);
  spool.add(5, {});
  spool.add(7, second);
  std::vector<std::int64_t> ids;
  std::vector<std::vector<AssessmentRow>> rows;
  spool.for_each([&](std::int64_t id, const std::vector<AssessmentRow>& each) {
    ids.push_back(id);
    rows.push_back(each);
  });
  EXPECT_EQ(spool.failure(), std::nullopt);
  EXPECT_THAT(ids, ElementsAre(2, 7)) << "those that have some";
  EXPECT_THAT(rows, ElementsAre(first, second));
}

TEST(AssessmentSpoolTest, OfNothingCallsNobody) {
  AssessmentSpool spool;
  spool.for_each([](std::int64_t, const std::vector<AssessmentRow>&) { FAIL(); });
  EXPECT_EQ(spool.failure(), std::nullopt);
}

TEST(StoredInputs, KeepTextsUnderTheirPaths) {
  Database database({}, Database::Mode::memory);
  database.execute(std::string(kInputsTable));
  const std::vector<StoredInput> inputs{stored_input(Source("b.yaml", "x: 1\n")),
                                        stored_input(Source("a/é.asl", ""))};
  write_inputs(database, inputs);
  const std::vector<StoredInput> found = read_inputs(database);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].path, "b.yaml") << "in the order in which they were read";
  EXPECT_EQ(found[0].text, "x: 1\n");
  EXPECT_EQ(found[1].path, "a/é.asl");
  EXPECT_EQ(found[1].text, "");
  EXPECT_EQ(damage_of(found), std::nullopt);
}

TEST(StoredInputs, AreSeenToBeChanged) {
  std::vector<StoredInput> inputs{stored_input(Source("a.asl", "+!g.")),
                                  stored_input(Source("b.asl", "+!h."))};
  inputs[1].text += ' ';
  ASSERT_TRUE(damage_of(inputs));
  EXPECT_THAT(*damage_of(inputs), HasSubstr("the text of 'b.asl'"));
  EXPECT_EQ(damage_of({}), std::nullopt);
}

TEST(StoredInputs, AreReadInPlaceOfFilesAndNothingElseIs) {
  const std::vector<StoredInput> inputs{stored_input(Source("/no/such/a.asl", "+!g."))};
  const SourceFiles copies = copies_of(inputs);
  EXPECT_TRUE(copies.has("/no/such/a.asl"));
  EXPECT_FALSE(copies.has("/etc/passwd"));
}

}  // namespace
}  // namespace jaywalk

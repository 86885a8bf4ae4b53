// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/results/reader.h"
#include "experiment/results/store/database.h"
#include "search/store/search_store.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

using testing::HasSubstr;

class SearchStoreTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
    std::filesystem::remove(path());
    experiment_.origin = "text";
    experiment_.plan = corner_plan("graft", 30);
    experiment_.plan.repetitions = 2;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path() const { return (folder_ / "search.gpkg").string(); }
  [[nodiscard]] std::string open_error(SearchStore::Mode mode) const {
    auto store = SearchStore::open(path(), mode, experiment_);
    return store.ok() ? "" : store.diagnostics().render();
  }

  std::filesystem::path folder_;
  SearchExperiment experiment_;
};

TEST_F(SearchStoreTest, GivesBackEveryTestAsItWas) {
  SearchResults results;
  {
    auto store = SearchStore::open(path(), SearchStore::Mode::create, experiment_);
    ASSERT_TRUE(store.ok()) << store.diagnostics().render();
    results = run_searches(experiment_.plan, store.value().get());
    EXPECT_EQ(store.value()->finish(results), std::nullopt);
  }
  auto store = SearchStore::open(path(), SearchStore::Mode::resume, experiment_);
  ASSERT_TRUE(store.ok()) << store.diagnostics().render();
  EXPECT_EQ(store.value()->had(), 60U);
  for (std::size_t search = 0; search < 2; ++search) {
    const auto& kept = store.value()->finished(search);
    const auto& ran = results.runs[search].tests;
    ASSERT_EQ(kept.size(), ran.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
      EXPECT_EQ(kept[i].test.input, ran[i].test.input);
      EXPECT_EQ(kept[i].test.outcome, ran[i].test.outcome);
      EXPECT_EQ(kept[i].test.fitness, ran[i].test.fitness);
      EXPECT_EQ(kept[i].test.failed, ran[i].test.failed);
    }
  }
}

/// Refuses inputs in the lower half, and counts those that it executes.
class PickySut : public CornerSut {
 public:
  class Run : public Sut {
   public:
    explicit Run(int& runs) : runs_(runs) {}
    Outcome run(const TestInput& input, std::size_t) override {
      ++runs_;
      Outcome outcome;
      if (input.values[1] < 0) {
        outcome.refused = "too low";
      } else {
        outcome.measures = {input.values[1]};
      }
      return outcome;
    }

   private:
    int& runs_;
  };

  [[nodiscard]] std::unique_ptr<Sut> make() const override { return std::make_unique<Run>(runs); }

  mutable int runs = 0;
};

TEST_F(SearchStoreTest, KeepsRefusedInputsSoThatTheyAreNotRunAgain) {
  const auto picky = std::make_shared<PickySut>();
  experiment_.plan.model = picky;
  experiment_.plan.generators = {generator_spec("prospect")};
  experiment_.plan.repetitions = 1;
  SearchResults results;
  {
    auto store = SearchStore::open(path(), SearchStore::Mode::create, experiment_);
    results = run_searches(experiment_.plan, store.value().get());
    EXPECT_EQ(store.value()->finish(results), std::nullopt);
  }
  const int runs = picky->runs;
  EXPECT_GT(runs, 30) << "thirty were executed, others refused";
  EXPECT_EQ(results.runs[0].tests.size(), static_cast<std::size_t>(runs));
  auto store = SearchStore::open(path(), SearchStore::Mode::resume, experiment_);
  ASSERT_TRUE(store.ok()) << store.diagnostics().render();
  const SearchResults again = run_searches(experiment_.plan, store.value().get());
  EXPECT_EQ(picky->runs, runs) << "none is run again";
  ASSERT_EQ(again.runs[0].tests.size(), static_cast<std::size_t>(runs));
  for (std::size_t i = 0; i < again.runs[0].tests.size(); ++i) {
    EXPECT_EQ(again.runs[0].tests[i].test.outcome, results.runs[0].tests[i].test.outcome);
    EXPECT_EQ(again.runs[0].tests[i].invalid, results.runs[0].tests[i].invalid);
  }
}

TEST_F(SearchStoreTest, DoesNotOverwriteAFile) {
  std::ofstream(path()) << "precious";
  EXPECT_THAT(open_error(SearchStore::Mode::create), HasSubstr("the file exists"));
  EXPECT_NE(open_error(SearchStore::Mode::resume), "");
  std::string text;
  std::ifstream(path()) >> text;
  EXPECT_EQ(text, "precious");
}

TEST_F(SearchStoreTest, IsRefusedToASecondSearch) {
  auto first = SearchStore::open(path(), SearchStore::Mode::create, experiment_);
  ASSERT_TRUE(first.ok());
  EXPECT_THAT(open_error(SearchStore::Mode::resume),
              HasSubstr("another process is writing the store"));
  EXPECT_THAT(read_search_store(path()).diagnostics().render(),
              HasSubstr("another process is writing the store"));
  EXPECT_EQ(first.value()->finish({}), std::nullopt);
  first.value().reset();
  EXPECT_EQ(open_error(SearchStore::Mode::resume), "");
}

/// Copies the store as it is after each test, with its log: what a kill leaves.
class CopyingLog : public TestLog {
 public:
  CopyingLog(SearchStore& store, const std::string& path) : store_(store), path_(path) { copy(); }

  [[nodiscard]] const std::vector<TestRow>& finished(std::size_t search) const override {
    return store_.finished(search);
  }
  Continue add(std::size_t search, std::size_t number, const TestRow& row) override {
    const Continue result = store_.add(search, number, row);
    copy();
    return result;
  }

  [[nodiscard]] static std::string name(const std::string& path, std::size_t number) {
    return fmt::format("{}-{}.gpkg", path, number);
  }

 private:
  void copy() {
    const std::string to = name(path_, copies_++);
    std::filesystem::copy_file(path_, to);
    if (std::filesystem::exists(path_ + "-wal")) {
      std::filesystem::copy_file(path_ + "-wal", to + "-wal");
    }
  }

  SearchStore& store_;
  std::string path_;
  std::size_t copies_ = 0;
};

TEST_F(SearchStoreTest, HasEveryFinishedTestAfterAKill) {
  experiment_.plan.budget.tests = 10;
  experiment_.plan.threads = 1;
  {
    auto store = SearchStore::open(path(), SearchStore::Mode::create, experiment_);
    ASSERT_TRUE(store.ok()) << store.diagnostics().render();
    CopyingLog log(*store.value(), path());
    (void)run_searches(experiment_.plan, &log);
  }
  for (std::size_t tests = 0; tests <= 20; ++tests) {
    const std::string copy = CopyingLog::name(path(), tests);
    auto store = SearchStore::open(copy, SearchStore::Mode::resume, experiment_);
    ASSERT_TRUE(store.ok()) << store.diagnostics().render();
    EXPECT_EQ(store.value()->had(), tests);
    EXPECT_EQ(store.value()->finish({}), std::nullopt);
    EXPECT_FALSE(std::filesystem::exists(copy + "-wal"));
  }
}

TEST_F(SearchStoreTest, RefusesOneOfAnotherVersion) {
  ASSERT_EQ(open_error(SearchStore::Mode::create), "");
  {
    Database database(path(), Database::Mode::write);
    database.execute("UPDATE versions SET version = '99' WHERE subject = 'store'");
  }
  EXPECT_THAT(open_error(SearchStore::Mode::resume), HasSubstr("its tables have version 99"));
  {
    Database database(path(), Database::Mode::write);
    database.execute("DROP TABLE versions");
  }
  EXPECT_THAT(open_error(SearchStore::Mode::resume), HasSubstr("its tables have version unknown"));
}

TEST_F(SearchStoreTest, IsNoResultsStore) {
  ASSERT_EQ(open_error(SearchStore::Mode::create), "");
  EXPECT_TRUE(is_search_store(path()));
  EXPECT_THAT(ResultsReader::open(path()).diagnostics().render(),
              HasSubstr("not a results store: a GeoPackage with other tables"));
}

TEST_F(SearchStoreTest, RefusesAnotherExperiment) {
  ASSERT_EQ(open_error(SearchStore::Mode::create), "");
  experiment_.plan.seed += 1;
  EXPECT_THAT(open_error(SearchStore::Mode::resume), HasSubstr("holds another experiment"));
  experiment_.plan.seed -= 1;
  EXPECT_EQ(open_error(SearchStore::Mode::resume), "");
}

/// A search of pedestrians' tests whose scenario, program and assertions are files beside it.
class SearchOfAScenario : public SearchStoreTest {
 protected:
  void SetUp() override {
    SearchStoreTest::SetUp();
    write("walk.asl", "pause(1). !go. +!go <- move(right); !go.");
    write("world.yaml", "behaviours: [walk.asl]\n");
    write("asserted.yaml",
          "assertions: [{id: kept, source: none, severity: critical, precondition: eventually "
          "in_zone, "
          "requirement: always closest > 0}]\n");
    write("search.yaml", R"(
sut: {kind: crossing, scenario: world.yaml, metrics: none, assertions: asserted.yaml,
      parameters: {behaviours.walk.parameters.pause: [1, 2]}}
budget: {tests: 2, virtual_s: 0}
generators: [random]
)");
  }

  void write(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name) << text;
  }
  [[nodiscard]] SearchExperiment read() const {
    auto experiment = read_search((folder_ / "search.yaml").string());
    EXPECT_TRUE(experiment.ok()) << experiment.diagnostics().render();
    return experiment.ok() ? std::move(experiment).value() : SearchExperiment();
  }
  void change_store(const std::string& statement) const {
    Database database(path(), Database::Mode::write);
    database.execute(statement);
    EXPECT_FALSE(database.failure());
  }
  void search() {
    experiment_ = read();
    auto store = SearchStore::open(path(), SearchStore::Mode::create, experiment_);
    ASSERT_TRUE(store.ok()) << store.diagnostics().render();
    EXPECT_EQ(store.value()->finish(run_searches(experiment_.plan, store.value().get())),
              std::nullopt);
  }
};

TEST_F(SearchOfAScenario, IsReadFromItsStoreAlone) {
  search();
  for (const char* name : {"walk.asl", "world.yaml", "asserted.yaml", "search.yaml"}) {
    std::filesystem::remove(folder_ / name);
  }
  const auto stored = read_search_store(path());
  ASSERT_TRUE(stored.ok()) << stored.diagnostics().render();
  EXPECT_EQ(stored.value().results.runs.at(0).tests.size(), 2U);
}

TEST_F(SearchOfAScenario, OpensNoFileThatItsStoreNames) {
  search();
  change_store("DELETE FROM inputs");
  const auto stored = read_search_store(path());
  ASSERT_FALSE(stored.ok());
  EXPECT_THAT(stored.diagnostics().render(), HasSubstr("cannot read 'world.yaml'"));
}

TEST_F(SearchOfAScenario, RefusesAStoreWhoseFilesAreNotAsTheyWere) {
  search();
  change_store("UPDATE inputs SET text = text || ' ' WHERE path LIKE '%world.yaml'");
  const auto stored = read_search_store(path());
  ASSERT_FALSE(stored.ok());
  EXPECT_THAT(stored.diagnostics().render(), HasSubstr("the store is damaged: the text of"));
  EXPECT_THAT(stored.diagnostics().render(), HasSubstr("world.yaml"));
}

TEST_F(SearchOfAScenario, DoesNotGoOnWithFilesThatHaveChanged) {
  search();
  experiment_ = read();
  EXPECT_EQ(open_error(SearchStore::Mode::resume), "");
  write("walk.asl", "pause(1). !go. +!go <- stay; !go.");
  experiment_ = read();
  EXPECT_THAT(open_error(SearchStore::Mode::resume), HasSubstr("another text of"));
  EXPECT_THAT(open_error(SearchStore::Mode::resume), HasSubstr("walk.asl"));
}

}  // namespace
}  // namespace jaywalk::search

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
    EXPECT_EQ(store.value()->finish(results), "");
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

TEST_F(SearchStoreTest, DoesNotOverwriteAFile) {
  std::ofstream(path()) << "precious";
  EXPECT_THAT(open_error(SearchStore::Mode::create), HasSubstr("the file exists"));
  EXPECT_NE(open_error(SearchStore::Mode::resume), "");
  std::string text;
  std::ifstream(path()) >> text;
  EXPECT_EQ(text, "precious");
}

TEST_F(SearchStoreTest, RefusesAnotherExperiment) {
  ASSERT_EQ(open_error(SearchStore::Mode::create), "");
  experiment_.plan.seed += 1;
  EXPECT_THAT(open_error(SearchStore::Mode::resume), HasSubstr("holds another experiment"));
  experiment_.plan.seed -= 1;
  EXPECT_EQ(open_error(SearchStore::Mode::resume), "");
}

}  // namespace
}  // namespace jaywalk::search

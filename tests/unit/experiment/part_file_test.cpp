// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/scenario/files/temporary.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

/// In both ways in which a part can be made.
class PartFileTest : public testing::TestWithParam<PartFile::Naming> {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const {
    return folder_.path() + "/" + name;
  }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
  }
  [[nodiscard]] std::string content(const std::string& name) const {
    std::ifstream file(path(name));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  static void fill(const PartFile& part, const std::string& text) {
    std::ofstream(part.name()) << text;
  }

 private:
  TemporaryFolder folder_;
};

TEST_P(PartFileTest, TakesItsPlaceWhenItIsWhole) {
  PartFile part(path("a.csv"), GetParam());
  ASSERT_TRUE(part.is_open());
  fill(part, "new");
  EXPECT_FALSE(fs::exists(path("a.csv")));
  EXPECT_TRUE(part.replace());
  EXPECT_EQ(content("a.csv"), "new");
  EXPECT_THAT(files(), ElementsAre("a.csv"));
}

TEST_P(PartFileTest, ReplacesWhatIsThere) {
  std::ofstream(path("a.csv")) << "old and longer";
  {
    PartFile part(path("a.csv"), GetParam());
    fill(part, "new");
    EXPECT_EQ(content("a.csv"), "old and longer");
    EXPECT_TRUE(part.replace());
  }
  EXPECT_EQ(content("a.csv"), "new");
  EXPECT_THAT(files(), ElementsAre("a.csv"));
}

TEST_P(PartFileTest, IsNewWhereItMustBe) {
  std::ofstream(path("a.gpkg")) << "old";
  {
    PartFile part(path("a.gpkg"), GetParam());
    fill(part, "new");
    EXPECT_FALSE(part.put_new());
    EXPECT_EQ(errno, EEXIST);
  }
  EXPECT_EQ(content("a.gpkg"), "old");
  {
    PartFile part(path("b.gpkg"), GetParam());
    fill(part, "new");
    EXPECT_TRUE(part.put_new());
  }
  EXPECT_EQ(content("b.gpkg"), "new");
  EXPECT_THAT(files(), ElementsAre("a.gpkg", "b.gpkg"));
}

TEST_P(PartFileTest, LeavesNothingIfItIsGivenUp) {
  {
    const PartFile part(path("a.csv"), GetParam());
    fill(part, "half");
  }
  EXPECT_THAT(files(), IsEmpty());
}

TEST_P(PartFileTest, HasTheRightsOfAnyNewFile) {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  PartFile part(path("a.csv"), GetParam());
  ASSERT_TRUE(part.replace());
  struct stat seen {};
  ASSERT_EQ(::stat(path("a.csv").c_str(), &seen), 0);
  EXPECT_EQ(seen.st_mode & 0777U, 0666U & ~mask);
}

TEST_P(PartFileTest, SaysWhyItCannotBeMade) {
  const PartFile part(path("no/such/a.csv"), GetParam());
  EXPECT_FALSE(part.is_open());
  EXPECT_EQ(errno, ENOENT);
}

INSTANTIATE_TEST_SUITE_P(Naming, PartFileTest,
                         testing::Values(PartFile::Naming::unnamed_if_possible,
                                         PartFile::Naming::named));

/// Files that a killed process has left are removed, those that another one is writing stay.
TEST_F(PartFileTest, NamedOnesOfKilledProcessesAreRemoved) {
  std::ofstream(path("a.csv.Ab3dE9.part")) << "half";
  std::ofstream(path("a.csv.short.part")) << "somebody's own";
  std::ofstream(path("b.csv.Ab3dE9.part")) << "of another file";
  const PartFile other(path("a.csv"), PartFile::Naming::named);
  EXPECT_FALSE(fs::exists(path("a.csv.Ab3dE9.part")));
  {
    PartFile part(path("a.csv"), PartFile::Naming::named);
    EXPECT_TRUE(fs::exists(other.name()));
    EXPECT_TRUE(part.replace());
  }
  EXPECT_TRUE(fs::exists(other.name()));
  EXPECT_THAT(files(), testing::IsSupersetOf({"a.csv", "a.csv.short.part", "b.csv.Ab3dE9.part"}));
}

}  // namespace
}  // namespace jaywalk

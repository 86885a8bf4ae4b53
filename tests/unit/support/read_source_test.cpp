#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {
namespace {

// A folder of its own for each test, for there is no reading without files.
class ReadSource : public testing::Test {
 protected:
  ReadSource()
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("jaywalk_read_source_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~ReadSource() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& content) {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  static std::string message_for(const std::string& path, std::size_t max_bytes = 1000) {
    const Result<SourcePtr> source = read_source(path, max_bytes);
    return source ? "read" : source.diagnostics().items().front().message;
  }

  std::filesystem::path folder_;
};

TEST_F(ReadSource, GivesTheTextUnderItsPath) {
  const std::string path = write("a.asl", "b(\"ä\").\n");
  const Result<SourcePtr> source = read_source(path);
  ASSERT_TRUE(source);
  EXPECT_EQ(source.value()->name(), path);
  EXPECT_EQ(source.value()->text(), "b(\"ä\").\n");
}

TEST_F(ReadSource, DropsAByteOrderMark) {
  const Result<SourcePtr> source = read_source(write("a.asl", "\xEF\xBB\xBF!go."));
  ASSERT_TRUE(source);
  EXPECT_EQ(source.value()->text(), "!go.");
}

TEST_F(ReadSource, TellsWhyItCannot) {
  EXPECT_EQ(message_for((folder_ / "none.asl").string()), "no such file");
  EXPECT_EQ(message_for(folder_.string()), "this is a folder, a file was expected");
  EXPECT_EQ(message_for(""), "no such file");
}

TEST_F(ReadSource, RefusesFilesLargerThanTheLimit) {
  const std::string path = write("a.asl", std::string(1001, 'a'));
  EXPECT_EQ(message_for(path, 1000), "larger than 1000 bytes");
  EXPECT_EQ(message_for(path, 1001), "read");
}

TEST_F(ReadSource, NamesTheFirstByteThatIsNotUtf8) {
  EXPECT_EQ(message_for(write("a.asl", "ab\ncd\xFF")),
            "not UTF-8 text: unexpected byte 0xFF at offset 5 (line 2)");
}

TEST_F(ReadSource, RefusesWhatOnlyLooksLikeUtf8) {
  for (const std::string bytes :
       {"\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF0\x9F\x98", "\x80"}) {
    EXPECT_TRUE(message_for(write("a.asl", bytes)).starts_with("not UTF-8")) << bytes;
  }
  EXPECT_EQ(message_for(write("a.asl", "\xF0\x9F\x98\x80")), "read");
}

}  // namespace
}  // namespace jaywalk

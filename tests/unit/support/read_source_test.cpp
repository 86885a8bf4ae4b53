// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "interpreter/support/diagnostics.h"
#include "tests/helpers/folder.h"

namespace jaywalk {
namespace {

// A folder of its own for each test, for there is no reading without files.
class ReadSource : public FolderTest {
 protected:
  static std::string message_for(const std::string& path, std::size_t max_bytes = 1000) {
    const Result<SourcePtr> source = read_source(path, max_bytes);
    return source ? "read" : source.diagnostics().items().front().message;
  }
};

TEST_F(ReadSource, GivesTheTextUnderItsPath) {
  const std::string name = file("a.asl", "b(\"ä\").\n");
  const Result<SourcePtr> source = read_source(name);
  ASSERT_TRUE(source);
  EXPECT_EQ(source.value()->name(), name);
  EXPECT_EQ(source.value()->text(), "b(\"ä\").\n");
}

TEST_F(ReadSource, DropsAByteOrderMark) {
  const Result<SourcePtr> source = read_source(file("a.asl", "\xEF\xBB\xBF!go."));
  ASSERT_TRUE(source);
  EXPECT_EQ(source.value()->text(), "!go.");
}

TEST_F(ReadSource, TellsWhyItCannot) {
  EXPECT_EQ(message_for(path("none.asl")), "no such file");
  EXPECT_EQ(message_for(path()), "this is a folder, a file was expected");
  EXPECT_EQ(message_for(""), "no such file");
}

TEST_F(ReadSource, RefusesFilesLargerThanTheLimit) {
  const std::string name = file("a.asl", std::string(1001, 'a'));
  EXPECT_EQ(message_for(name, 1000), "larger than 1000 bytes");
  EXPECT_EQ(message_for(name, 1001), "read");
}

TEST_F(ReadSource, NamesTheFirstByteThatIsNotUtf8) {
  EXPECT_EQ(message_for(file("a.asl", "ab\ncd\xFF")),
            "not UTF-8 text: unexpected byte 0xFF at offset 5 (line 2)");
}

TEST_F(ReadSource, FindsABadByteWhereverItStands) {
  for (std::size_t at = 0; at < 20; ++at) {
    std::string text(20, 'a');
    text[at] = '\x80';
    EXPECT_EQ(message_for(file("a.asl", text)),
              "not UTF-8 text: unexpected byte 0x80 at offset " + std::to_string(at) + " (line 1)");
    EXPECT_EQ(message_for(file("a.asl", std::string(at, 'a') + "\xC3\xA4" + "aaaaaaaa")), "read");
  }
}

TEST_F(ReadSource, RefusesWhatOnlyLooksLikeUtf8) {
  for (const std::string bytes :
       {"\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF0\x9F\x98", "\x80"}) {
    EXPECT_TRUE(message_for(file("a.asl", bytes)).starts_with("not UTF-8")) << bytes;
  }
  EXPECT_EQ(message_for(file("a.asl", "\xF0\x9F\x98\x80")), "read");
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/jaywalk/lsp/lsp_protocol.h"

namespace jaywalk::lsp {
namespace {

TEST(LspJson, HasEmptyPartsWhereThereAreNone) {
  const Json message = Json::parse(R"({"a": {"b": "text"}, "n": 3})");
  EXPECT_EQ(text_of(part(part(message, "a"), "b")), "text");
  EXPECT_TRUE(part(message, "z").is_null());
  EXPECT_TRUE(part(part(message, "z"), "y").is_null());
  EXPECT_TRUE(part(message["n"], "a").is_null()) << "a number has no parts";
}

TEST(LspJson, HasAnEmptyTextForWhatIsNone) {
  for (const char* other : {"3", "null", "[]", "{}", "true"}) {
    EXPECT_EQ(text_of(Json::parse(other)), "") << other;
  }
}

TEST(LspJson, ReadsPositions) {
  const Position position = position_of(Json::parse(R"({"line": 12, "character": 7})"));
  EXPECT_EQ(position.line, 12U);
  EXPECT_EQ(position.unit, 7U);
}

TEST(LspJson, TakesAnyOtherNumberForTheBeginning) {
  for (const char* line : {"-1", "\"2\"", "null", "1e300", "4000000000", "-1e300"}) {
    const Json message = Json::parse(std::string(R"({"character": 1, "line": )") + line + "}");
    EXPECT_EQ(position_of(message).line, 0U) << line;
    EXPECT_EQ(position_of(message).unit, 1U);
  }
  EXPECT_EQ(position_of(Json::parse(R"({"line": 2.9})")).line, 2U);
  EXPECT_EQ(position_of(Json::parse("[]")).line, 0U);
}

TEST(LspJson, FindsTheDocumentOfAMessage) {
  EXPECT_EQ(document_uri(Json::parse(R"({"textDocument": {"uri": "file:///a.asl"}})")),
            "file:///a.asl");
  EXPECT_EQ(document_uri(Json::parse(R"({"textDocument": "file:///a.asl"})")), "");
  EXPECT_EQ(document_uri(Json()), "");
}

TEST(LspJson, WritesPositionsAndRangesAsItReadsThem) {
  const Position begin{3, 4};
  EXPECT_EQ(position_of(to_json(begin)).line, 3U);
  EXPECT_EQ(position_of(to_json(begin)).unit, 4U);
  const Json range = to_json(Range{begin, {5, 0}});
  EXPECT_EQ(range, Json::parse(R"({"start": {"line": 3, "character": 4},
                                   "end": {"line": 5, "character": 0}})"));
}

}  // namespace
}  // namespace jaywalk::lsp

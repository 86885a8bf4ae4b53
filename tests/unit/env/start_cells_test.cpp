// SPDX-License-Identifier: Apache-2.0
#include "env/grid/start_cells.h"

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

Result<StartCells> parse(const std::string& text) {
  return parse_start_cells(std::make_shared<const Source>("starts.csv", text), Grid{12, 66});
}

std::string first_error(const std::string& text) {
  const Result<StartCells> result = parse(text);
  return result.ok() ? "" : result.diagnostics().items()[0].message;
}

TEST(StartCells, AreReadInTheOrderOfTheAgents) {
  const Result<StartCells> cells = parse(
      "test,agent,row,cell\r\n"
      "0,2,10,40\r\n"
      "0,1,0,18\r\n"
      "\n"
      "3,1,11,65");
  ASSERT_TRUE(cells.ok());
  EXPECT_EQ(cells.value(), (StartCells{{0, {{0, 18}, {10, 40}}}, {3, {{11, 65}}}}));
}

TEST(StartCells, AreReadAsTheyWereWritten) {
  const StartCells cells{{0, {{0, 18}, {10, 40}}}, {1, {{1, 12}}}};
  EXPECT_EQ(print_start_cells(cells), "test,agent,row,cell\n0,1,0,18\n0,2,10,40\n1,1,1,12\n");
  const Result<StartCells> read = parse(print_start_cells(cells));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read.value(), cells);
}

TEST(StartCells, AreRefusedWithAReason) {
  const std::string header = "test,agent,row,cell\n";
  EXPECT_EQ(first_error(""), "expected the header 'test,agent,row,cell'");
  EXPECT_EQ(first_error("0,1,2,3\n"), "expected the header 'test,agent,row,cell'");
  EXPECT_EQ(first_error(header + "0,1,2\n"), "expected four numbers: test,agent,row,cell");
  EXPECT_EQ(first_error(header + "0,1,2,3,4\n"), "expected four numbers: test,agent,row,cell");
  EXPECT_EQ(first_error(header + "0,1,two,3\n"),
            "expected a whole number from 0 to 18446744073709551615, found 'two'");
  EXPECT_EQ(first_error(header + "99999999999999999999,1,2,3\n"),
            "expected a whole number from 0 to 18446744073709551615, found "
            "'99999999999999999999'");
  EXPECT_EQ(first_error(header + "0,1,12,3\n"),
            "row 12, cell 3 does not lie on the grid of 12 rows and 66 cells");
  EXPECT_EQ(first_error(header + "0,0,1,3\n"), "agents are numbered from 1");
  EXPECT_EQ(first_error(header + "0,1,1,3\n0,1,1,4\n"),
            "agent 1 of test 0 has a start cell already");
  EXPECT_EQ(first_error(header + "0,1,1,3\n0,3,1,4\n"), "test 0 has agent 3 but no agent 2");
}

TEST(StartCells, PointAtTheFieldThatIsWrong) {
  const Result<StartCells> cells = parse("test,agent,row,cell\n0,1,x,3\n");
  ASSERT_FALSE(cells.ok());
  const Diagnostic& diagnostic = cells.diagnostics().items()[0];
  const Source::Position at = diagnostic.where.source->position(diagnostic.where.span.begin);
  EXPECT_EQ(at.line, 2U);
  EXPECT_EQ(at.column, 5U);
}

}  // namespace
}  // namespace jaywalk

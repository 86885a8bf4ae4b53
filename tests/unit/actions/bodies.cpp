// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/actions/bodies.h"

#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"

namespace jaywalk::test {

void expect_lines(const std::vector<BodyRow>& rows, const std::string& beliefs) {
  for (const BodyRow& row : rows) {
    const std::string program = beliefs + "\n!test. +!test <- " + row.body +
                                ". -!test[error(E)] <- .print(\"failed: \", E).";
    EXPECT_EQ(printed_by(program), row.lines) << row.body;
  }
}

}  // namespace jaywalk::test

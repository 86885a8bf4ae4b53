// SPDX-License-Identifier: Apache-2.0
#pragma once

// Tables of plan bodies and what they print.

#include <string>
#include <vector>

namespace jaywalk::test {

struct BodyRow {
  /// The body of a plan, without a final stop.
  std::string body;
  /// The printed lines. If the body fails, the last line is `failed: ` and the error.
  std::vector<std::string> lines;
};

/// Runs each body in an agent of its own, behind the beliefs, and compares.
void expect_lines(const std::vector<BodyRow>& rows, const std::string& beliefs = "");

}  // namespace jaywalk::test

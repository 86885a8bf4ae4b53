// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

struct NumberTextRow {
  double number;
  std::string text;
};

// The expectations follow the documentation of Java's Double.toString and Math.round.
TEST(NumberText, IsJavas) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<NumberTextRow> rows{
      {0, "0"},
      {-0.0, "0"},
      {3, "3"},
      {-3, "-3"},
      {1e6, "1000000"},
      {1e7, "10000000"},
      {123456789012.0, "123456789012"},
      {9007199254740993.0, "9007199254740992"},
      {1e18, "1000000000000000000"},
      {9223372036854775807.0, "9223372036854775807"},
      {-9223372036854775808.0, "-9223372036854775808"},
      {1e19, "1.0E19"},
      {-1e19, "-1.0E19"},
      {1e20, "1.0E20"},
      {5e-324, "4.9E-324"},
      {1e-323, "9.9E-324"},
      {-5e-324, "-4.9E-324"},
      {2e-308, "2.0E-308"},
      {1.5e300, "1.5E300"},
      {std::numeric_limits<double>::max(), "1.7976931348623157E308"},
      {0.1, "0.1"},
      {-0.1, "-0.1"},
      {0.30000000000000004, "0.30000000000000004"},
      {1.0 / 3, "0.3333333333333333"},
      {2.0 / 3, "0.6666666666666666"},
      {3.14159, "3.14159"},
      {100.5, "100.5"},
      {1234567.5, "1234567.5"},
      {9999999.5, "9999999.5"},
      {12345678.5, "1.23456785E7"},
      {123456789.125, "1.23456789125E8"},
      {0.001, "0.001"},
      {0.00123, "0.00123"},
      {0.000999, "9.99E-4"},
      {0.0001, "1.0E-4"},
      {1e-10, "1.0E-10"},
      {1.25e-7, "1.25E-7"},
      {infinity, "Infinity"},
      {-infinity, "-Infinity"},
      {std::nan(""), "NaN"},
  };
  for (const NumberTextRow& row : rows) EXPECT_EQ(number_text(row.number), row.text);
}

TEST(NumberText, GivesTheNumberBack) {
  double number = 1.1;
  for (int i = 0; i < 500; ++i) {
    number = number * 1.37 + (i % 7) * 1e-5;
    EXPECT_EQ(std::stod(number_text(number)), number);
    EXPECT_EQ(std::stod(number_text(1 / number)), 1 / number);
  }
}

}  // namespace
}  // namespace jaywalk

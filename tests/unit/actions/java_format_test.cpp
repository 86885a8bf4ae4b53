// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/java/java_format.h"

#include <vector>

#include <gtest/gtest.h>

namespace jaywalk::actions {
namespace {

FormatArgument number(double value) { return {FormatArgument::Kind::number, value, "number"}; }
FormatArgument text(std::string value) { return {FormatArgument::Kind::text, 0, std::move(value)}; }

std::string formatted(std::string_view format, const std::vector<FormatArgument>& args) {
  std::string out;
  std::string error;
  return format_as_java(format, args, out, error) ? out : "error: " + error;
}

TEST(JavaFormat, WritesNumbers) {
  struct Row {
    std::string format;
    double value;
    std::string expected;
  };
  const std::vector<Row> rows{
      {"%f", 1.5, "1.500000"},
      {"%.2f", 0.125, "0.13"},  // half up, unlike C
      {"%.2f", 2.675, "2.68"},
      {"%.1f", 0.25, "0.3"},
      {"%.0f", 0.5, "1"},
      {"%.0f", 0.4, "0"},
      {"%.3f", 0.0004, "0.000"},
      {"%.2f", 9.999, "10.00"},
      {"%.2f", 1e21, "1000000000000000000000.00"},
      {"%8.2f|", -3.14159, "   -3.14|"},
      {"%-8.2f|", 3.14159, "3.14    |"},
      {"%08.2f", -3.14159, "-0003.14"},
      {"%+.1f", 2, "+2.0"},
      {"% .1f", 2, " 2.0"},
      {"%(.1f", -2, "(2.0)"},
      {"%,.2f", 1234567.895, "1,234,567.90"},
      {"%e", 12345.678, "1.234568e+04"},
      {"%.0e", 15, "2e+01"},
      {"%.2E", 0.00012, "1.20E-04"},
      {"%e", 0, "0.000000e+00"},
      {"%g", 0.0001, "0.000100000"},
      {"%g", 123456, "123456"},
      {"%g", 1234567, "1.23457e+06"},
      {"%g", 0, "0.00000"},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(formatted(row.format, {number(row.value)}), row.expected) << row.format;
  }
}

TEST(JavaFormat, WritesTexts) {
  EXPECT_EQ(formatted("%s-%5s-%-5s|%.2s", {text("a"), text("b"), text("c"), text("long")}),
            "a-    b-c    |lo");
  EXPECT_EQ(formatted("%2$s %1$s %<s %s", {text("a"), text("b")}), "b a a a");
  EXPECT_EQ(formatted("%S %% %n", {text("up")}), "UP % \n");
  EXPECT_EQ(formatted("%b", {text("anything")}), "true");
}

TEST(JavaFormat, RefusesWhatDoesNotFit) {
  for (const std::string format :
       {"%d", "%x", "%c", "%q", "%", "%5", "%-s", "%-05.1f", "%s %s", "%.f", "%999999999f"}) {
    EXPECT_EQ(formatted(format, {number(1)}).substr(0, 5), "error") << format;
  }
  EXPECT_EQ(formatted("%f", {text("a")}).substr(0, 5), "error");
}

}  // namespace
}  // namespace jaywalk::actions

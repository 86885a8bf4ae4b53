// SPDX-License-Identifier: Apache-2.0
// The arithmetic functions.

#include <gtest/gtest.h>

#include "tests/unit/actions/bodies.h"

namespace jaywalk::test {
namespace {

TEST(Functions, CalculateAsJava) {
  const auto value = [](const std::string& expression, const std::string& expected) {
    return BodyRow{"X = " + expression + "; .print(X)", {expected}};
  };
  expect_lines({
      value("math.abs(-3)", "3"),
      value("math.ceil(1.2) + math.floor(1.8)", "3"),
      value("math.round(2.5)", "3"),
      value("math.round(-2.5)", "-2"),
      value("math.round(0.49999999999999994)", "0"),
      value("math.sqrt(9) + math.log(math.e)", "4"),
      value("math.sin(0) + math.cos(0) + math.tan(0)", "1"),
      value("math.asin(0) + math.acos(1) + math.atan(0)", "0"),
      value("math.floor(math.pi * 100)", "314"),
      value("math.max(2,5) + math.min(2,5)", "7"),
      value("math.max([1,7,a,3])", "7"),
      value("math.max([-3,-2])", "-2"),  // where Jason says 4.9E-324
      value("math.min([4,b,3])", "3"),
      value("math.sum([1,2,a,3])", "6"),
      value("math.average([1,2,a])", "1.5"),
      value("math.average([])", "NaN"),
      value("math.mean([1,2])", "1.5"),
      value("math.mean([1,a,3])", "2"),
      value("math.median([3,1,2])", "2"),
      value("math.median([4,1,2,3])", "2.5"),
      value("math.std_dev([2,4,4,4,5,5,7,9])", "2.138089935299395"),
      value("math.std_dev([1,a,1])", "0"),
      value("math.std_dev([])", "0"),
      value(".length([a,b]) + .length(\"abc\")", "5"),
      value("f(math.mean([]))", "f(math.mean([]))"),
      value("f(math.abs(Y))", "f(math.abs(Y))"),
  });
}

TEST(Functions, WaitForTheirArguments) {
  expect_lines({{"Z = math.abs(Y); Y = -4; .print(Z + 1)", {"5"}}});
}

}  // namespace
}  // namespace jaywalk::test

// SPDX-License-Identifier: Apache-2.0
#include "search/generators/acceptance.h"

namespace jaywalk::search {

void Examples::add(const ExecutedTest& test) {
  tests.push_back(test.input.values);
  fitness.push_back(test.fitness);
}

learn::Matrix Examples::inputs() const {
  const std::size_t rows = tests.empty() ? 0 : tests.front().size();
  learn::Matrix matrix(rows, tests.size());
  for (std::size_t column = 0; column < tests.size(); ++column) {
    for (std::size_t row = 0; row < rows; ++row) {
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          static_cast<float>(tests[column][row]);
    }
  }
  return matrix;
}

learn::Matrix Examples::outputs() const {
  learn::Matrix matrix(1, fitness.size());
  for (std::size_t i = 0; i < fitness.size(); ++i) {
    matrix(0, static_cast<Eigen::Index>(i)) = static_cast<float>(fitness[i]);
  }
  return matrix;
}

}  // namespace jaywalk::search

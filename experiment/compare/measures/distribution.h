// SPDX-License-Identifier: Apache-2.0
#pragma once

// The distribution of values, as a box plot shows it, in bounded memory for any number of values.

#include <cstdint>
#include <memory>
#include <vector>

namespace jaywalk {

/// How the values of a metric are spread over tests; those that do not exist are not counted.
struct Distribution {
  std::uint64_t count = 0;
  double mean = 0;
  double least = 0;
  double lower_quartile = 0;
  double median = 0;
  double upper_quartile = 0;
  double greatest = 0;
};

/// Quantiles are interpolated between neighbours, as by R's default (Hyndman and Fan's type 7).
[[nodiscard]] Distribution distribution(std::vector<double> values);

/// The values of several columns. No more than `most` of them are in memory: then they are sorted
/// and go to a file without a name in the folder for temporary files. Where that cannot be
/// written, they stay in memory. One thread at a time.
class ValueColumns {
 public:
  static constexpr std::size_t kMost = std::size_t{1} << 17U;

  /// REQUIRES: `most` is at least 1.
  explicit ValueColumns(std::size_t columns, std::size_t most = kMost);
  ~ValueColumns();
  ValueColumns(const ValueColumns&) = delete;
  ValueColumns& operator=(const ValueColumns&) = delete;

  /// REQUIRES: a column, from 0.
  void add(std::size_t column, double value);
  /// The distribution of all values of a column; their order does not matter. Throws
  /// std::system_error if the file cannot be read.
  [[nodiscard]] Distribution distribution(std::size_t column) const;

 private:
  class File;
  /// Ascending values in the file.
  struct Run {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
  };
  struct Column {
    std::vector<double> in_memory;
    std::vector<Run> runs;
  };
  void spill();

  std::vector<Column> columns_;
  std::size_t most_;
  std::size_t in_memory_ = 0;
  /// Null as long as there is none.
  std::unique_ptr<File> file_;
};

}  // namespace jaywalk

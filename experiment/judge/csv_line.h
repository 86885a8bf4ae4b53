#pragma once

// Lines of the CSV files that are read.

#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

struct CsvField {
  /// As it stands in the line.
  std::string_view where;
  /// Without quotes.
  std::string text;
};

/// What is between commas; quotes hold them together, two within are one. At least one field.
[[nodiscard]] std::vector<CsvField> csv_fields(std::string_view line);

}  // namespace jaywalk

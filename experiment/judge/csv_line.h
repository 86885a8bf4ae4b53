// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lines of CSV files.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

struct CsvField {
  /// The field as it stands in the line.
  std::string_view where;
  /// Without quotes.
  std::string text;
};

/// The fields between commas. A field in quotes may contain commas, and two quotes for one. Returns
/// at least one field.
[[nodiscard]] std::vector<CsvField> csv_fields(std::string_view line);
/// A text as a field: in quotes if it holds a separator or quotes.
[[nodiscard]] std::string csv_quoted(std::string_view text);
/// Adds a comma and the number with at most six decimals; nothing after the comma if there is none.
void add_csv_field(std::string& line, std::optional<double> value);

}  // namespace jaywalk

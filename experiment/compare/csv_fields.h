#pragma once

// Fields of CSV as all of our tables write them.

#include <optional>
#include <string>
#include <string_view>

namespace jaywalk {

/// Adds a comma and the number with at most six decimals; nothing after the comma if there is none.
void add_csv_field(std::string& line, std::optional<double> value);
/// A name as a field: in quotes if it holds a separator.
[[nodiscard]] std::string csv_quoted(std::string_view text);

}  // namespace jaywalk

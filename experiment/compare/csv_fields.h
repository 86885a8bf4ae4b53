#pragma once

// Numbers of CSV as all of our tables write them; texts: judge/csv_line.h.

#include <optional>
#include <string>

namespace jaywalk {

/// Adds a comma and the number with at most six decimals; nothing after the comma if there is none.
void add_csv_field(std::string& line, std::optional<double> value);

}  // namespace jaywalk

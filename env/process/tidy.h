#pragma once

// Numbers as they are written for other programs.

#include <nlohmann/json.hpp>

namespace jaywalk {

/// Rounded to nine digits after the point, as the rest is noise of the arithmetic; -0 becomes 0.
[[nodiscard]] double tidy(double value);

/// A list of both.
[[nodiscard]] nlohmann::json tidy_pair(double first, double second);

}  // namespace jaywalk

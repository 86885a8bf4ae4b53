#pragma once

// How one text differs from another, for people and `patch`.

#include <string>
#include <string_view>

namespace jaywalk {

/// A unified diff with three lines around each change; empty if the texts are the same.
[[nodiscard]] std::string line_diff(std::string_view before, std::string_view after,
                                    std::string_view before_name, std::string_view after_name);

}  // namespace jaywalk

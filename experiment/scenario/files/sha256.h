#pragma once

#include <string>
#include <string_view>

namespace jaywalk {

/// 64 hexadecimal digits (FIPS 180-4).
[[nodiscard]] std::string sha256(std::string_view text);

}  // namespace jaywalk

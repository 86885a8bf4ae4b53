#pragma once

// Numbers as people list them: `1..10,15,20`.

#include <cstdint>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// At most as many numbers as this; a slip (`1..1000000000`) is reported, not carried out.
inline constexpr std::size_t kMaxListedNumbers = 10'000;

/// Numbers from 1 and ranges of them, in the order given, each once. `subject` is what the list
/// belongs to, for messages ("--agents").
[[nodiscard]] Result<std::vector<std::uint32_t>> parse_number_list(std::string_view text,
                                                                   std::string_view subject);

}  // namespace jaywalk

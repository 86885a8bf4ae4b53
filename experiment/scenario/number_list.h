// SPDX-License-Identifier: Apache-2.0
#pragma once

// Numbers as people list them: `1..10,15,20`.

#include <cstdint>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// More agents in a test than this are a slip.
inline constexpr std::uint32_t kMaxAgents = 10'000;
/// And more threads.
inline constexpr unsigned kMaxThreads = 1024;

/// Numbers of agents and ranges of them, in the order given, each once. `subject` names the list in
/// messages ("--agents").
[[nodiscard]] Result<std::vector<std::uint32_t>> parse_number_list(std::string_view text,
                                                                   std::string_view subject);

}  // namespace jaywalk

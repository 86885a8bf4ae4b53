// SPDX-License-Identifier: Apache-2.0
#pragma once

// How wide programs and terms may be.

#include <cstddef>

namespace jaywalk {

/// Arguments of a literal, formulas of a body and variables of a clause: their numbers have 16
/// bits.
inline constexpr std::size_t kMostParts = 65'535;

}  // namespace jaywalk

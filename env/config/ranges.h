// Ranges of numbers that several keys of a scenario share: generous, but small enough that products
// of them do not overflow.
#pragma once

#include "env/config/reader.h"

namespace jaywalk {

inline constexpr IntegerRange kCells{1, 100'000};
inline constexpr IntegerRange kCellsFromAnywhere{-100'000, 100'000};
inline constexpr IntegerRange kRows{0, 999};
/// In the unit of its key, cells or metres a second.
inline constexpr NumberRange kSpeed{0.01, 10'000};
/// In seconds.
inline constexpr NumberRange kWindow{0, 3600};

}  // namespace jaywalk

#pragma once

// The acceleration of free fall, one value for everything that drives, brakes and is measured.

namespace jaywalk {

/// Standard gravity in m/s^2 (ISO 80000-3).
inline constexpr double kGravityMps2 = 9.80665;

}  // namespace jaywalk

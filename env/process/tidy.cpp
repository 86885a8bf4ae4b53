#include "env/process/tidy.h"

#include <cmath>

namespace jaywalk {

double tidy(double value) {
  constexpr double kDigits = 1e9;
  return std::round(value * kDigits) / kDigits + 0.0;
}

nlohmann::json tidy_pair(double first, double second) { return {tidy(first), tidy(second)}; }

}  // namespace jaywalk

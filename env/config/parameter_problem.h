#pragma once

// What does not fit together in a section of a scenario.

#include <string>

namespace jaywalk {

struct ParameterProblem {
  /// The parameter as scenarios spell it, `world.av.rows`.
  std::string path;
  std::string message;
};

}  // namespace jaywalk

#pragma once

// An error in a section of a scenario: values that do not fit together.

#include <string>

namespace jaywalk {

struct ParameterProblem {
  /// The parameter as scenarios spell it, `world.av.rows`.
  std::string path;
  std::string message;
};

}  // namespace jaywalk

#pragma once

// The names of the rows of learners.def, for readers of scenarios.

#include <array>
#include <string_view>

namespace jaywalk {

[[nodiscard]] inline auto learner_names() {
  return std::to_array<std::string_view>({
#define JAYWALK_LEARNER(function, name, summary) name,
#include "experiment/policy/learners.def"
#undef JAYWALK_LEARNER
  });
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// A number by which an experiment may change a controller, a generator or the like; their tables
// list them.

#include <string_view>

namespace jaywalk {

struct NumberParameter {
  std::string_view name;
  /// The default, and the least and greatest value.
  double value = 0;
  double least = 0;
  double most = 0;
  std::string_view meaning;
};

}  // namespace jaywalk

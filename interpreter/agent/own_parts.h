// SPDX-License-Identifier: Apache-2.0
#pragma once

// An agent's additions to its program: plans made or changed at run time, the programs that it has
// included, and their functions. Most agents have none.

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "interpreter/program/program.h"

namespace jaywalk {

struct OwnParts {
  std::unique_ptr<PlanLibrary> library;      // once the program's has been changed
  std::vector<std::shared_ptr<Plan>> plans;  // made at run time, perhaps removed again
  std::vector<std::shared_ptr<const Program>> included;
  std::vector<RuleFunction> functions;  // if programs are included: those of all
  std::map<const Plan*, Value> labels;  // of plans whose sources have changed
  std::uint32_t next_label = 0;
};

}  // namespace jaywalk

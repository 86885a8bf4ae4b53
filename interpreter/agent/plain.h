#pragma once

// Plans and means that need no more than a frame: what strides are for (stride.cpp, plain.cpp).

#include "interpreter/agent/intention.h"
#include "interpreter/program/plan.h"

namespace jaywalk {

// Of such a plan the means needs no more than a frame.
[[nodiscard]] inline bool is_plain(const Plan& plan) {
  return !plan.atomic && !plan.has_goal_condition && plan.subplans == nullptr;
}

[[nodiscard]] inline bool is_plain(const IntendedMeans& means) {
  return means.loops.empty() && means.outer.empty() && means.scope == nullptr &&
         means.cursor.code == nullptr;
}

}  // namespace jaywalk

#pragma once

// Terms that contain themselves: X = f(X) binds X to a term in which X stands.

#include <cstdint>
#include <unordered_map>

#include "interpreter/term/value.h"

namespace jaywalk {

/// The lists and structures below a term that contain themselves, by Value::bits(), each with a
/// variable whose value it is. Every way down that does not end comes to one of them.
using Circles = std::unordered_map<std::uint64_t, const Variable*>;

/// REQUIRES: `slots` are those of the term's template, or it has none.
[[nodiscard]] Circles circles_of(Value term, const Value* slots = nullptr);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Assumptions of the engine about Values (<jaywalk/value.h>), and a comparison without a look at
// cells.

#include "interpreter/term/symbol.h"
#include <jaywalk/value.h>

namespace jaywalk {

/// Two values that cannot be unified: a number and another one, an atom and another one, a number
/// and an atom. REQUIRES: dereferenced. Of others it is not known.
[[nodiscard]] constexpr bool evidently_differ(Value a, Value b) {
  if (a.same_as(b)) return false;
  if (a.is_number() && b.is_number()) return a.as_number() != b.as_number();
  return (a.is_number() || a.is_atom()) && (b.is_number() || b.is_atom());
}

static_assert(sizeof(Value) == 8);
static_assert((static_cast<unsigned>(Value::Kind::atom) | 2U) == 3U &&
              static_cast<unsigned>(Value::Kind::structure) == 3U);  // is_name

}  // namespace jaywalk

#pragma once

// `Term =.. List`: a literal as namespace, functor, arguments and annotations; a plan as label,
// trigger, context and body.

#include "interpreter/logic/unifier/unifier.h"

namespace jaywalk {

/// REQUIRES: both sides applied.
[[nodiscard]] bool unify_univ(Unifier& unifier, Value term, Value list);

}  // namespace jaywalk

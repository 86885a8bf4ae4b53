// SPDX-License-Identifier: Apache-2.0
#pragma once

// `Term =.. List`: a literal as namespace, functor, arguments and annotations; a plan as label,
// trigger, context and body.

#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/term/texts_read.h"

namespace jaywalk {

/// A text that becomes a functor is counted among `texts`. REQUIRES: both sides applied.
[[nodiscard]] bool unify_univ(Unifier& unifier, TextsRead& texts, Value term, Value list);

}  // namespace jaywalk

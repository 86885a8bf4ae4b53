#pragma once

// Texts that become terms while an agent runs: `.term2string`, `.puts`.

#include <optional>
#include <string_view>

#include "interpreter/logic/action.h"

namespace jaywalk {

/// The term that the text is, or nothing. A variable that the caller's plan or rule has, too, is
/// that one; others are new.
[[nodiscard]] std::optional<Value> read_term(std::string_view text, ActionCall& call);

}  // namespace jaywalk

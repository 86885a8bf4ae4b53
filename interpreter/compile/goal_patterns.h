// SPDX-License-Identifier: Apache-2.0
#pragma once

// The directives `{begin bdg(g)} ... {end}` and their kin: patterns of commitment to goals, which
// rewrite the plans between them (Huebner, Bordini, Wooldridge 2006; Jason's directives).

#include <span>
#include <string>
#include <string_view>

#include "interpreter/syntax/ast.h"
#include <jaywalk/diagnostics.h>

namespace jaywalk {

[[nodiscard]] bool is_goal_pattern(std::string_view directive);

/// All directives known, for suggestions.
[[nodiscard]] std::span<const std::string> directive_names();

/// The program text that a pattern stands for. `problem` receives why there is none.
[[nodiscard]] std::string expand_goal_pattern(const ast::Component& component, const Source& source,
                                              std::string& problem);

}  // namespace jaywalk

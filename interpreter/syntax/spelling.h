#pragma once

// How operators and triggers are written.

#include <string_view>

#include "interpreter/syntax/ast.h"

namespace jaywalk {

[[nodiscard]] std::string_view spelling_of(ast::Operator op);
/// Empty for a formula without one.
[[nodiscard]] std::string_view spelling_of(ast::BodyOperator op);
/// The operator and kind, `+!`; `^` stands for changes of goals' states.
[[nodiscard]] std::string_view spelling_of(const ast::Trigger& trigger);

}  // namespace jaywalk

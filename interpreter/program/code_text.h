// SPDX-License-Identifier: Apache-2.0
#pragma once

// Compiled plans and rules as text, beside their source: `jaywalk check --dump-code`.

#include <string>

#include "interpreter/program/program.h"

namespace jaywalk {

/// The code of each rule and plan of a program, in source order; the standard plans for messages
/// are left out. docs/internals/engine.md explains it. Names of variables with the numbers of their
/// slots are added to `symbols`.
[[nodiscard]] std::string code_text(const Program& program, SymbolTable& symbols);

}  // namespace jaywalk

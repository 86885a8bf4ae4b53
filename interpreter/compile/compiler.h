#pragma once

// Syntax trees to programs. The only module that sees both.

#include <memory>

#include "interpreter/program/program.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/load.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

/// Compiles a program into `symbols`. Null after adding errors to `diagnostics`.
[[nodiscard]] std::shared_ptr<const Program> compile(const SourceTree& tree, SymbolTable& symbols,
                                                     Diagnostics& diagnostics);

/// The predicates of the program's initial beliefs that are facts, as `name/arity` texts in source
/// order: what may be set from outside as a parameter.
[[nodiscard]] std::vector<std::string> parameter_names(const Program& program,
                                                       const SymbolTable& symbols);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Syntax trees to programs. The only module that sees both.

#include <memory>
#include <string>
#include <vector>

#include "interpreter/program/program.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/load.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

struct CompileOptions {
  /// The namespace that the program's own literals are in; empty: the default one.
  std::string ns;
  /// For code that an agent includes while it runs: plans without a label, local namespaces and
  /// those of variables get names that no program of the table has.
  bool fresh_names = false;
  /// The internal actions and functions that it may use; null: the standard ones. They must outlive
  /// the program and must not change any more.
  const ActionRegistry* actions = nullptr;
};

/// Compiles a program into `symbols`. Null after adding errors to `diagnostics`, or if it has some
/// already but for those of includes that are left out.
[[nodiscard]] std::shared_ptr<const Program> compile(const SourceTree& tree, SymbolTable& symbols,
                                                     Diagnostics& diagnostics,
                                                     const CompileOptions& options = {});

/// The predicates of the program's initial beliefs that are facts, as `name/arity` texts in source
/// order: what may be set from outside as a parameter.
[[nodiscard]] std::vector<std::string> parameter_names(const Program& program,
                                                       const SymbolTable& symbols);

}  // namespace jaywalk

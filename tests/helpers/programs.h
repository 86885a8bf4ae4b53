// SPDX-License-Identifier: Apache-2.0
#pragma once

// Programs compiled from text, for the tests of compilers and of what a compiled program is.

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/compile/compiler.h"

namespace jaywalk::test {

/// A text compiled as `agent.asl`. What is asked of it REQUIRES that it has no errors, but for
/// errors().
struct CompiledProgram {
  /// Files that the text may include, by name.
  using Files = std::vector<std::pair<std::string, std::string>>;

  explicit CompiledProgram(std::string_view text, const CompileOptions& options = {},
                           Files files = {});

  /// The program's own plans, in order, without those that every agent has.
  [[nodiscard]] std::vector<std::shared_ptr<const Plan>> plans() const;
  /// The only plan. REQUIRES: there is one.
  [[nodiscard]] const Plan& plan() const;
  /// Its beliefs as text, in order; rules have their slots as variables: `a(_0) :- b(_0)`.
  [[nodiscard]] std::vector<std::string> beliefs() const;
  [[nodiscard]] std::string text(Value term) const;
  /// `line:column: message` of each error, with its hint in brackets; lines end with `\n`.
  [[nodiscard]] std::string errors() const;

  SymbolTable symbols;
  Diagnostics diagnostics;
  /// Null if it has errors.
  std::shared_ptr<const Program> program;
};

}  // namespace jaywalk::test

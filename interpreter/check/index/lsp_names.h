// SPDX-License-Identifier: Apache-2.0
#pragma once

// The uses of names in a program with their roles, for editors: definitions, references, renaming
// and completion.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/syntax/load.h"

namespace jaywalk::lsp {

struct Use {
  enum class What : std::uint8_t {
    goal,    // !g, +!g
    belief,  // b, +b, ?b
    action,  // of the environment
    internal_action,
  };

  What what = What::belief;
  std::string_view name;
  int arity = 0;
  /// A plan for the goal, a belief or rule of the program.
  bool defines = false;
  /// The content of a message.
  bool in_message = false;
  const ast::File* file = nullptr;
  /// The name alone.
  Span span;
  /// The plan, if it defines a goal or reacts to a belief.
  const ast::Plan* plan = nullptr;

  [[nodiscard]] bool is_same_name(const Use& other) const {
    return what == other.what && arity == other.arity && name == other.name;
  }
};

/// All uses in all files of a program, in the order of the texts. Terms that are mere data, not
/// known to be a goal or belief, are left out.
[[nodiscard]] std::vector<Use> uses_of_names(const SourceTree& program);

/// The use whose name covers an offset of a file; null if there is none.
[[nodiscard]] const Use* use_at(const std::vector<Use>& uses, const ast::File& file,
                                std::uint32_t offset);

}  // namespace jaywalk::lsp

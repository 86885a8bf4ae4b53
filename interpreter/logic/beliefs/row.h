// SPDX-License-Identifier: Apache-2.0
#pragma once

// A row of a relation: a fact or a rule, and the data that queries look at first.

#include <bit>
#include <cstdint>
#include <memory>

#include "interpreter/logic/beliefs/row_index.h"
#include "interpreter/logic/code/code.h"
#include "interpreter/support/containers/hash_index.h"
#include "interpreter/support/containers/ring.h"
#include "interpreter/term/heap.h"

namespace jaywalk {

/// A number that equal bound arguments share; 0 for arguments that can only be unified.
[[nodiscard]] inline std::uint32_t argument_key(Value argument);

/// Keys are odd, or 0; 3 and 5 are those of lists.
[[nodiscard]] constexpr std::uint32_t mix_key(std::uint64_t word) {
  word = (word ^ word >> 31U) * 0x9E3779B97F4A7C15U;
  return static_cast<std::uint32_t>(word >> 32U) | 1U;
}
[[nodiscard]] std::uint32_t argument_key_of_cell(Value argument);  // a text, structure or object

std::uint32_t argument_key(Value argument) {
  argument = deref(argument);
  if (argument.is_pair()) return 3;
  if (argument.is_number()) {
    return mix_key(std::bit_cast<std::uint64_t>(argument.as_number() + 0.0));
  }
  if (argument.is_atom()) return mix_key(static_cast<std::uint64_t>(argument.atom_id()) << 3U | 2U);
  if (argument.is_variable() || argument.is_unset()) return 0;
  if (argument.is_empty_list()) return 5;
  return argument_key_of_cell(argument);
}

struct Row {
  /// A literal with annotations; unset in rows of rules and holes.
  Value fact;
  const RuleCode* rule = nullptr;
  /// argument_key of the first argument.
  std::uint32_t key = 0;
  /// The belief update that last saw this percept.
  std::uint32_t percept_generation = 0;

  [[nodiscard]] bool is_hole() const { return fact.is_unset() && rule == nullptr; }
  /// The literal to unify a query with. REQUIRES: no hole.
  [[nodiscard]] Value literal() const { return rule != nullptr ? rule->head : fact; }
};

/// Indexes of rows, the first of which has this number: by an argument, which they have; of the
/// facts by all arguments.
[[nodiscard]] std::unique_ptr<RowIndex> make_row_index(const Ring<Row>& rows, std::int64_t first,
                                                       std::size_t argument);
[[nodiscard]] std::unique_ptr<HashIndex> make_fact_index(const Ring<Row>& rows, std::int64_t first);

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The percepts that every agent has in every look, all agents the same (Environment::constants):
// how large the road is, how long a tick takes. Agents share their rows (shared_rows.h), in this
// run and in the next ones, as long as the environment says the same.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "interpreter/logic/beliefs/shared_rows.h"
#include "interpreter/support/containers/flat_index.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

class ConstantPercepts {
 public:
  struct Percept {
    Predicate predicate{};
    std::span<const Value> args;
  };
  /// In the order of perception. Predicates and atoms from the number `names` on may mean something
  /// else in the next run. A predicate one of whose percepts bears such a name, or is said twice,
  /// is left out.
  ConstantPercepts(std::span<const Percept> said, std::uint32_t names, SymbolTable& symbols);

  /// The rows of a predicate, in the order of perception; null: there are none.
  [[nodiscard]] const SharedRows* find(Predicate predicate) const {
    const std::uint32_t place = by_predicate_.find(static_cast<std::uint32_t>(predicate));
    return place == FlatIndex<std::uint32_t>::kNone ? nullptr : rows_[place].get();
  }
  [[nodiscard]] bool is_empty() const { return rows_.empty(); }

 private:
  Heap heap_{Heap::Owner::program};
  std::vector<std::unique_ptr<const SharedRows>> rows_;
  FlatIndex<std::uint32_t> by_predicate_;  // into rows_
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// Replaces queries in contexts by rules. Asked as near(A), `near(X) :- at(Y) & X - Y < 3`
// becomes `at(Y) & A - Y < 3` over the asking frame, which gets a slot for Y: then neither
// arguments nor a frame have to be made for the rule. A goal that is unfolded so
// (Goal::Kind::unfolded) names the table of rules for which that is right; an agent with other
// rules asks the query itself.

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/logic/beliefs/rule_table.h"
#include "interpreter/logic/code/code.h"

namespace jaywalk {

class RuleUnfolder {
 public:
  using Tables = std::span<const std::pair<Predicate, RuleTable>>;

  /// `slot_names` are those of the asking frame; they grow by the rules' own variables. `heap` owns
  /// the templates that are made.
  RuleUnfolder(Tables tables, Heap& heap, const SymbolTable& symbols,
               std::vector<Symbol>& slot_names)
      : tables_(tables), heap_(heap), symbols_(symbols), slot_names_(slot_names) {}

  struct Unfolded {
    Value body;
    const RuleTable* table = nullptr;
  };
  /// The replacement of a query until leave(); none if its predicate has another number of rules
  /// than one, the query is within that rule already, the rule is large, or it has more than
  /// queries, comparisons and unifications of the usual kinds.
  [[nodiscard]] std::optional<Unfolded> enter(Predicate predicate, std::span<const Value> args);
  void leave() { entered_.pop_back(); }
  [[nodiscard]] bool has_unfolded() const { return has_unfolded_; }

 private:
  using Slots = std::vector<Value>;  // of a rule: what stands for each; unset: nothing yet

  [[nodiscard]] const RuleTable* table_of(Predicate predicate) const;
  [[nodiscard]] bool is_usual(Value formula) const;
  [[nodiscard]] Value replaced(Value term, std::span<const Symbol> names, Slots& slots);

  Tables tables_;
  Heap& heap_;
  const SymbolTable& symbols_;
  std::vector<Symbol>& slot_names_;
  std::vector<Predicate> entered_;
  bool has_unfolded_ = false;
};

}  // namespace jaywalk

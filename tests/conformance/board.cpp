// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/board.h"

#include <algorithm>

namespace jaywalk::test {

Board::Board(SymbolTable& symbols)
    : show_(symbols.predicate("show", 1)),
      hide_(symbols.predicate("hide", 1)),
      move_(symbols.predicate("move", 1)),
      refuse_(symbols.predicate("refuse", 1)),
      at_(symbols.predicate("at", 1)) {}

void Board::perceive(AgentId, Percepts& percepts) const {
  percepts.add(at_, {Value::number(position_)});
  for (const Predicate predicate : shown_) percepts.add(predicate, {});
}

void Board::execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) {
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const ActionRequest& action = actions[i];
    if (action.predicate == show_ && action.args[0].is_atom()) {
      shown_.push_back(action.args[0].atom_id());
    } else if (action.predicate == hide_ && action.args[0].is_atom()) {
      std::erase(shown_, action.args[0].atom_id());
    } else if (action.predicate == move_ && action.args[0].is_number()) {
      position_ = action.args[0].as_number();
    } else if (action.predicate == refuse_) {
      results[i] = {.succeeded = false, .reason = "refused"};
    }
  }
}

}  // namespace jaywalk::test

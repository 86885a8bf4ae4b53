// SPDX-License-Identifier: Apache-2.0
#pragma once

// The smallest environment in which percepts and actions can be observed: see README.md.

#include <vector>

#include "interpreter/environment/percepts.h"
#include "interpreter/term/symbol.h"
#include <jaywalk/environment.h>

namespace jaywalk::test {

class Board : public Environment {
 public:
  /// Adds the names that it knows to `symbols`, which all programs share.
  explicit Board(SymbolTable& symbols);

  void perceive(AgentId agent, Percepts& percepts) const override;
  void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) override;
  void advance() override {}
  [[nodiscard]] bool finished() const override { return false; }
  [[nodiscard]] double tick_ms() const override { return 10; }

 private:
  Predicate show_;
  Predicate hide_;
  Predicate move_;
  Predicate refuse_;
  Predicate at_;
  std::vector<Predicate> shown_;
  double position_ = 0;
};

}  // namespace jaywalk::test

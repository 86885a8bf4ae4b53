// SPDX-License-Identifier: Apache-2.0
#pragma once

// The tools and outputs of an agent during its turn. Agents that have their turns one after another
// share one; where several threads reason, each has its own for the agents of its block
// (mas/parallel.cpp).

#include "interpreter/term/texts_read.h"

namespace jaywalk {

class WorkspacePool;

struct AgentTurn {
  explicit AgentTurn(WorkspacePool& pool) : workspaces(&pool) {}

  /// The pool from which the agent borrows its workspace.
  WorkspacePool* workspaces;
  /// The agent has asked for something that concerns others: a message, a new agent, the end of the
  /// run. So it stops at the end of its cycle.
  bool has_business = false;
  /// Texts that it has made names of.
  TextsRead texts;
};

}  // namespace jaywalk

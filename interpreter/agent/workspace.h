#pragma once

// What an agent needs only while it reasons: the machine that answers its queries, and memory for
// things in passing. Agents of one system share a few of them, since of a million agents few reason
// at the same time: an agent borrows one when it first needs it and gives it back at the end of its
// cycle.

#include <memory>
#include <utility>
#include <vector>

#include "interpreter/agent/intention.h"
#include "interpreter/logic/machine.h"

namespace jaywalk {

struct Workspace {
  explicit Workspace(SymbolTable& symbols) : machine(symbols) {}

  Machine machine;
  std::vector<Value> frame;                      // of the plan being tried
  std::vector<std::pair<Value, Value>> renamed;  // variables of a call, with their copies
  struct PerceptChanges {
    std::vector<BeliefBase::PerceptChange> gone;
    std::vector<BeliefBase::PerceptChange> news;
  } percept_changes;
  std::vector<std::unique_ptr<Intention>> spare_intentions;
};

class WorkspacePool {
 public:
  explicit WorkspacePool(SymbolTable& symbols) : symbols_(symbols) {}

  [[nodiscard]] std::unique_ptr<Workspace> lend() {
    if (idle_.empty()) return std::make_unique<Workspace>(symbols_);
    std::unique_ptr<Workspace> lent = std::move(idle_.back());
    idle_.pop_back();
    return lent;
  }
  void take_back(std::unique_ptr<Workspace> workspace) { idle_.push_back(std::move(workspace)); }

 private:
  SymbolTable& symbols_;
  std::vector<std::unique_ptr<Workspace>> idle_;
};

}  // namespace jaywalk

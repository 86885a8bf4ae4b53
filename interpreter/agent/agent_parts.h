// SPDX-License-Identifier: Apache-2.0
#pragma once

// The data of an agent, for agent.h.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "interpreter/agent/circumstance/circumstance.h"
#include "interpreter/agent/drops.h"
#include "interpreter/agent/surroundings/customisation.h"
#include "interpreter/agent/surroundings/host.h"
#include "interpreter/agent/surroundings/settings.h"
#include "interpreter/agent/surroundings/turn.h"
#include "interpreter/agent/workspace.h"
#include "interpreter/logic/machine.h"
#include "interpreter/program/program.h"
#include "interpreter/support/containers/lazy.h"
#include "interpreter/support/random.h"

namespace jaywalk {

class Percepts;
struct OwnParts;

struct AgentLimits {
  std::uint64_t bytes = std::uint64_t{1} << 30U;
  std::uint64_t inferences = 1'000'000'000;
};

class AgentParts {
 protected:
  AgentParts(std::string name, std::shared_ptr<const Program> program, SymbolTable& symbols,
             AgentHost& host, std::uint64_t seed, const AgentLimits& limits);
  ~AgentParts();
  AgentParts(const AgentParts&) = delete;
  AgentParts& operator=(const AgentParts&) = delete;

  std::string name_;
  ReasoningSettings settings_;
  std::uint32_t cycles_since_look_ = 0;
  std::unique_ptr<Percepts> unseen_;  // of the next cycle that looks, or null
  std::uint64_t seen_looks_ = 0;      // what Percepts::looks was in the last belief update
  std::uint32_t seen_mail_ = 0;       // messages of the mailbox that may be handled
  std::shared_ptr<const Program> program_;
  SymbolTable& symbols_;
  AgentHost& host_;
  AgentTurn* turn_;
  ReasoningObserver* const observer_;
  Heap heap_;
  BeliefBase beliefs_;
  std::unique_ptr<Workspace> workspace_;  // null while it is at rest
  std::uint64_t max_inferences_;
  JavaRandom random_;
  Circumstance circumstance_;
  std::shared_ptr<const Customisation> customisation_;
  const PlanLibrary* library_;     // the program's, or its own
  std::unique_ptr<OwnParts> own_;  // null: nothing
  LazyContainer<std::vector<DropCause>> drops_;
  std::uint64_t next_token_ = 1;
  std::uint32_t next_intention_ = 1;
  std::uint32_t number_ = 0;
  std::uint32_t last_message_ = 0;
  std::uint64_t cycles_ = 0;
  std::uint64_t last_cycle_ = 0;  // for now
  std::uint32_t finished_ = 0;    // intentions that are finished but not forgotten
  std::uint32_t memory_failures_ = 0;
  Intention* held_ = nullptr;  // the intention that runs: neither in I nor in an event of E
  Intention* executing_ = nullptr;
  const Event* selected_event_ = nullptr;  // for which a plan is being looked for
  bool goes_on_ = false;                   // the intention that is held is ready
  bool released_ = false;                  // it has its place in I after all
  bool starts_later_ = false;
  bool changed_ = false;  // since waiting formulas were last looked at
  /// There may be something that a cycle has to look at before it goes on with the same intention
  /// (Agent::has_unusual_business). Set by the code that causes it.
  bool attention_ = true;
  /// Flags for features that take the agent off the fast path; tested as one word. Kept by
  /// Agent::note_unusual, but for kSelectsByRules and kSubplans, which stay once they are set.
  enum Unusual : std::uint32_t {
    kObserved = 1,
    kCustomised = 2,
    kSelectsByRules = 4,  // rules select options, or did
    kSubplans = 8,        // some means has had sub-plans
    kLearned = 16,        // there are plans that are options of policies
    kGoalStates = 32,     // there are plans for goal states
    kSeldomLooks = 64,    // it does not look at the world in every cycle
    kKeepsCallers = 128,  // last calls do not take the caller's place
    kShowsEvents = 256,   // its observer reads the literals of its events
  };
  std::uint32_t unusual_ = 0;
  std::uint32_t goal_conditions_ = 0;  // means with a goal condition
  std::uint32_t formula_waits_ = 0;
};

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "interpreter/agent/agent.h"
#include "interpreter/term/transfer.h"

namespace jaywalk {

/// Gives a clone the original's goals: those that are still events, and intentions that are
/// running, with their loops, forks and sub-plans. What waits for time, an answer or an action does
/// not wait a second time, nor do the other branches of its fork; neither is a body copied that was
/// made at run time.
class Agent::GoalCopier {
 public:
  /// `plans`: maps the original's plans to the clone's.
  GoalCopier(const Agent& original, Agent& clone, Transfer& transfer, const PlanMap& plans)
      : original_(original), clone_(clone), transfer_(transfer), plans_(plans) {}

  void copy();

 private:
  void choose();
  [[nodiscard]] bool is_copied(const Intention& intention) const;
  [[nodiscard]] bool has_copied_code(const IntendedMeans& means) const;
  [[nodiscard]] bool waits_in_fork(const Intention& intention) const;

  void copy_intention(Intention& intention);
  void copy_terms(Intention& intention, Intention& copy);
  void copy_code(IntendedMeans& means);
  void copy_events();
  [[nodiscard]] std::shared_ptr<Fork> copy_of(const std::shared_ptr<Fork>& fork);
  [[nodiscard]] ScopePtr copy_of(const ScopePtr& scope);
  [[nodiscard]] const Plan* copy_of(const Plan& plan) const;
  [[nodiscard]] std::uint32_t id_of_copy(std::uint32_t id) const;

  const Agent& original_;
  Agent& clone_;
  Transfer& transfer_;
  const PlanMap& plans_;
  /// The intentions to copy, by their numbers.
  std::map<std::uint32_t, Intention*> chosen_;
  std::map<std::uint32_t, Intention*> copies_;
  std::map<const Fork*, std::shared_ptr<Fork>> forks_;
  std::map<const Scope*, ScopePtr> scopes_;
};

}  // namespace jaywalk

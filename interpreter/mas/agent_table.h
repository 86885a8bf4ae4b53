// SPDX-License-Identifier: Apache-2.0
#pragma once

// The agents of a system by number and name, and which of them have something to do. Agents may
// come and go while others reason: a newcomer first reasons in the next round, one that has left is
// destroyed only when no agent is reasoning. Idle agents cost nothing.

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "interpreter/agent/agent.h"
#include "interpreter/support/containers/flat_index.h"

namespace jaywalk {

struct AgentRecord {
  [[nodiscard]] bool has_body() const { return percepts != nullptr; }

  std::unique_ptr<Agent> agent;  // null once it has left
  /// Kept as long as the run, since terms that were sent refer to its constants.
  std::shared_ptr<const Program> program;
  /// Its name as an atom and as a text that outlives it; made when first needed.
  std::optional<Predicate> name;
  std::string_view name_text;
  std::uint32_t number = 0;
  /// Its percepts of the environment; null: it has no body there.
  std::unique_ptr<Percepts> percepts;
  bool looks = false;      // in this tick; its percepts may be unchanged
  bool is_listed = false;  // as awake, or to be from the next round on
  bool is_asleep = false;  // it was informed (jag_sleeping)
  bool has_mail = false;
  bool is_full = false;           // has no memory for more messages, until it is looked at again
  std::uint32_t look_after = 0;   // deliveries to wait, doubled each time that it still has none
  std::uint64_t look_at = 0;      // at this delivery
  std::uint64_t sent_before = 0;  // the delivery of the messages sent last, and their size
  std::size_t sent_bytes = 0;
  std::size_t known_bytes = 0;    // the agent's memory after it reasoned last
  bool is_leaving = false;        // has stopped reasoning
  bool is_near = false;           // can reason in parallel (reach.h), as judged when
  std::size_t reach_version = 0;  // the number of programs then
  std::uint64_t period = 0;       // for which cycles_before holds
  std::uint64_t cycles_before = 0;
};

class AgentTable {
 public:
  /// `name`, or the first of name_1, name_2, ... that is free.
  [[nodiscard]] std::string free_name(const std::string& name);
  /// REQUIRES: the agent's name is free.
  AgentRecord& add(std::unique_ptr<Agent> agent, std::shared_ptr<const Program> program);
  /// The agent has left; its name is free again.
  void remove(AgentRecord& record);
  /// Destroys those that have left. REQUIRES: no agent is reasoning.
  void bury();

  /// The number of agents that there have been.
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] std::size_t living() const { return by_name_.size(); }
  [[nodiscard]] AgentRecord& operator[](std::uint32_t number) { return all_[number]; }
  [[nodiscard]] const AgentRecord& operator[](std::uint32_t number) const { return all_[number]; }
  /// Null if there is no such agent.
  [[nodiscard]] AgentRecord* find(std::string_view name);
  /// The agent that an atom has been found to name; null if that is not known.
  [[nodiscard]] AgentRecord* known_as(Predicate atom) {
    const std::uint32_t number = by_atom_.find(static_cast<std::uint32_t>(atom));
    return number == FlatIndex<std::uint32_t>::kNone ? nullptr : &all_[number];
  }
  /// REQUIRES: the atom is not known.
  void remember(Predicate atom, const AgentRecord& record) {
    by_atom_.insert(static_cast<std::uint32_t>(atom), record.number);
  }
  [[nodiscard]] AgentRecord& of(const Agent& agent) { return all_[agent.number()]; }
  /// In the order of their numbers, those that have left included.
  [[nodiscard]] std::deque<AgentRecord>& all() { return all_; }
  [[nodiscard]] const std::deque<AgentRecord>& all() const { return all_; }

  /// The agent may have something to do: it takes part from the next round on.
  void wake(AgentRecord& record);
  /// The only agent that takes part in the next round; null if there are none or several.
  [[nodiscard]] AgentRecord* lone_active() {
    if (!woken_.empty()) list_woken();
    return active_.size() == 1 ? &all_[active_.front()] : nullptr;
  }
  [[nodiscard]] bool has_leaving() const { return !leaving_.empty(); }
  /// Begins a round: the agents that may have something to do, in the order of numbers. An agent
  /// woken during the round takes part in the next one.
  [[nodiscard]] std::span<const std::uint32_t> begin_round();
  /// Agents that have nothing left to do no longer take part.
  void end_round();

 private:
  void list_woken();

  std::deque<AgentRecord> all_;  // a deque: references stay good when agents come
  std::unordered_map<std::string_view, std::uint32_t> by_name_;  // the agents' own names
  FlatIndex<std::uint32_t> by_atom_;  // those that were sent messages, until an agent leaves
  std::unordered_map<std::string, std::uint32_t> suffixes_;  // the last that was taken
  std::vector<std::uint32_t> active_;                        // sorted
  std::vector<std::uint32_t> woken_;                         // to be active from the next round on
  std::vector<std::uint32_t> leaving_;
};

}  // namespace jaywalk

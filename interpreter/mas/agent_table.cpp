// SPDX-License-Identifier: Apache-2.0
#include "interpreter/mas/agent_table.h"

#include <algorithm>

#include <fmt/format.h>

namespace jaywalk {

std::string AgentTable::free_name(const std::string& name) {
  if (!by_name_.contains(name)) return name;
  std::uint32_t& suffix = suffixes_[name];
  while (true) {
    std::string suffixed = fmt::format("{}_{}", name, ++suffix);
    if (!by_name_.contains(suffixed)) return suffixed;
  }
}

AgentRecord& AgentTable::add(std::unique_ptr<Agent> agent, std::shared_ptr<const Program> program) {
  const auto number = static_cast<std::uint32_t>(all_.size());
  agent->set_number(number);
  by_name_.emplace(agent->name(), number);
  AgentRecord& record = all_.emplace_back();
  record.agent = std::move(agent);
  record.program = std::move(program);
  record.number = number;
  return record;
}

void AgentTable::remove(AgentRecord& record) {
  if (record.is_leaving) return;
  record.is_leaving = true;
  by_name_.erase(by_name_.find(record.agent->name()));
  by_atom_.clear();
  suffixes_.clear();
  leaving_.push_back(record.number);
}

void AgentTable::bury() {
  for (const std::uint32_t number : leaving_) {
    all_[number].agent.reset();
  }
  leaving_.clear();
}

AgentRecord* AgentTable::find(std::string_view name) {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &all_[found->second];
}

void AgentTable::wake(AgentRecord& record) {
  if (record.is_listed || record.is_leaving) return;
  record.is_listed = true;
  woken_.push_back(record.number);
}

std::span<const std::uint32_t> AgentTable::begin_round() {
  if (!woken_.empty()) list_woken();
  return active_;
}

void AgentTable::end_round() {
  std::size_t kept = 0;
  for (const std::uint32_t number : active_) {
    AgentRecord& record = all_[number];
    if (!record.is_leaving && record.agent->is_active()) {
      active_[kept++] = number;
    } else {
      record.is_listed = false;
    }
  }
  active_.resize(kept);
}

void AgentTable::list_woken() {
  std::sort(woken_.begin(), woken_.end());
  if (active_.empty()) {
    active_.swap(woken_);
    return;
  }
  const auto middle = static_cast<std::ptrdiff_t>(active_.size());
  active_.insert(active_.end(), woken_.begin(), woken_.end());
  std::inplace_merge(active_.begin(), active_.begin() + middle, active_.end());
  woken_.clear();
}

}  // namespace jaywalk

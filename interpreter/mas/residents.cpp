#include "interpreter/mas/residents.h"

#include <algorithm>

#include <fmt/format.h>

namespace jaywalk {

std::string Residents::free_name(const std::string& name) {
  if (!by_name_.contains(name)) return name;
  std::uint32_t& suffix = suffixes_[name];
  while (true) {
    std::string suffixed = fmt::format("{}_{}", name, ++suffix);
    if (!by_name_.contains(suffixed)) return suffixed;
  }
}

Resident& Residents::add(std::unique_ptr<Agent> agent, std::shared_ptr<const Program> program) {
  const auto number = static_cast<std::uint32_t>(all_.size());
  agent->set_number(number);
  by_name_.emplace(agent->name(), number);
  Resident& resident = all_.emplace_back();
  resident.agent = std::move(agent);
  resident.program = std::move(program);
  resident.number = number;
  return resident;
}

void Residents::remove(Resident& resident) {
  if (resident.is_leaving) return;
  resident.is_leaving = true;
  by_name_.erase(by_name_.find(resident.agent->name()));
  by_atom_.clear();
  suffixes_.clear();
  leaving_.push_back(resident.number);
}

void Residents::bury() {
  for (const std::uint32_t number : leaving_) {
    all_[number].agent.reset();
  }
  leaving_.clear();
}

Resident* Residents::find(std::string_view name) {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &all_[found->second];
}

void Residents::wake(Resident& resident) {
  if (resident.is_listed || resident.is_leaving) return;
  resident.is_listed = true;
  woken_.push_back(resident.number);
}

std::span<const std::uint32_t> Residents::begin_round() {
  if (!woken_.empty()) list_woken();
  return active_;
}

void Residents::end_round() {
  std::size_t kept = 0;
  for (const std::uint32_t number : active_) {
    Resident& resident = all_[number];
    if (!resident.is_leaving && resident.agent->is_active()) {
      active_[kept++] = number;
    } else {
      resident.is_listed = false;
    }
  }
  active_.resize(kept);
}

void Residents::list_woken() {
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

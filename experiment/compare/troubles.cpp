// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/troubles.h"

#include <algorithm>
#include <tuple>

namespace jaywalk {
namespace {

auto place_of(const DropCause& cause) {
  return std::tie(cause.file, cause.line, cause.column, cause.error);
}

/// The same error from the same place; a goal that comes from no place is identified by its text.
bool is_same(const DropCause& left, const DropCause& right) {
  return place_of(left) == place_of(right) && (left.line > 0 || left.formula == right.formula);
}

bool comes_before(const SharedCause& left, const SharedCause& right) {
  if (left.agents != right.agents) return left.agents > right.agents;
  if (place_of(left.cause) != place_of(right.cause)) {
    return place_of(left.cause) < place_of(right.cause);
  }
  return left.cause.formula < right.cause.formula;
}

using Errors = std::map<std::string, SharedError>;

void add_error(const SharedError& error, std::uint64_t& count, Errors& errors) {
  count += error.tests;
  const auto [known, is_new] = errors.try_emplace(error.message, error);
  if (is_new) return;
  known->second.tests += error.tests;
  known->second.first_test = std::min(known->second.first_test, error.first_test);
}

std::vector<SharedError> most_frequent_first(const Errors& errors) {
  std::vector<SharedError> sorted;
  for (const auto& [message, error] : errors) sorted.push_back(error);
  std::ranges::stable_sort(sorted, [](const SharedError& left, const SharedError& right) {
    return left.tests > right.tests;
  });
  return sorted;
}

}  // namespace

void TroublesSum::add_cause(std::uint64_t test, const DropCause& cause) {
  const auto known = std::ranges::find_if(
      entries_, [&](const Entry& entry) { return is_same(entry.shared.cause, cause); });
  if (known == entries_.end()) {
    entries_.push_back({.shared = {.cause = cause, .agents = 1}, .first_test = test});
    return;
  }
  const std::uint64_t times = known->shared.cause.times + cause.times;
  if (test < known->first_test) {
    known->first_test = test;
    known->shared.cause = cause;
  }
  known->shared.cause.times = times;
  ++known->shared.agents;
}

void TroublesSum::add(std::uint64_t test, const TestTroubles& troubles) {
  totals_.agents += troubles.agents;
  totals_.pedestrians += troubles.pedestrians;
  totals_.idle += troubles.idle;
  std::uint32_t last = 0;
  for (const AgentDrop& drop : troubles.drops) {
    if (drop.actor != last) ++totals_.dropping;
    last = drop.actor;
    add_cause(test, drop.cause);
  }
  if (!troubles.error.empty()) add_error({troubles.error, 1, test}, totals_.errored, errors_);
}

Troubles TroublesSum::sum() const {
  Troubles sum = totals_;
  for (const Entry& entry : entries_) sum.causes.push_back(entry.shared);
  std::ranges::sort(sum.causes, comes_before);
  sum.errors = most_frequent_first(errors_);
  return sum;
}

Troubles together(std::span<const Troubles> parts) {
  Troubles all;
  Errors errors;
  for (const Troubles& part : parts) {
    for (const SharedError& each : part.errors) add_error(each, all.errored, errors);
    all.agents += part.agents;
    all.pedestrians += part.pedestrians;
    all.idle += part.idle;
    all.dropping += part.dropping;
    for (const SharedCause& each : part.causes) {
      const auto known = std::ranges::find_if(
          all.causes, [&](const SharedCause& other) { return is_same(other.cause, each.cause); });
      if (known == all.causes.end()) {
        all.causes.push_back(each);
      } else {
        known->agents += each.agents;
        known->cause.times += each.cause.times;
      }
    }
  }
  std::ranges::sort(all.causes, comes_before);
  all.errors = most_frequent_first(errors);
  return all;
}

std::size_t TroublesTable::cell_index(std::size_t behaviour, std::uint32_t agents) const {
  const auto column =
      static_cast<std::size_t>(std::ranges::find(agents_, agents) - agents_.begin());
  return behaviour * agents_.size() + column;
}

void TroublesTable::add(const TestKey& test, const TestTroubles& troubles) {
  Cell& cell = cells_[cell_index(test.behaviour, test.agents)];
  const std::lock_guard lock(cell.mutex);
  cell.sum.add(test.number, troubles);
}

Troubles TroublesTable::troubles(std::size_t behaviour, std::uint32_t agents) const {
  const Cell& cell = cells_[cell_index(behaviour, agents)];
  const std::lock_guard lock(cell.mutex);
  return cell.sum.sum();
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/first_tests.h"

#include <fmt/format.h>

namespace jaywalk {

bool FirstTests::is_wanted(const TestKey& test) const {
  return test.number < kCount && !cells_[plan_.cell_of(test)].goes_on;
}

std::optional<std::string> FirstTests::why_not_started(const TestKey& test) {
  Cell& cell = cells_[plan_.cell_of(test)];
  if (test.number < kCount || cell.goes_on) return std::string();
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return given_up_ || cell.goes_on || cell.errored == kCount; });
  if (given_up_) return std::nullopt;
  if (cell.goes_on) return std::string();
  return fmt::format("not started, since the first {} tests of the row ended errored alike",
                     kCount);
}

void FirstTests::finished(const TestKey& test, const std::string& error) {
  if (test.number >= kCount) return;
  const std::lock_guard lock(mutex_);
  Cell& cell = cells_[plan_.cell_of(test)];
  if (error.empty() || (cell.errored > 0 && error != cell.error)) cell.goes_on = true;
  cell.error = error;
  ++cell.errored;
  changed_.notify_all();
}

void FirstTests::give_up() {
  const std::lock_guard lock(mutex_);
  given_up_ = true;
  changed_.notify_all();
}

}  // namespace jaywalk

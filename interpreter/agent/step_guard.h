// SPDX-License-Identifier: Apache-2.0
#pragma once

// Turns the limits that a query or a term may hit into a failure of the step that hit them.

#include <algorithm>
#include <memory>

#include "interpreter/logic/machine.h"
#include "interpreter/term/heap.h"

namespace jaywalk {

/// The step's error for the limit that is being handled; other exceptions are rethrown.
/// REQUIRES: called from a handler.
[[nodiscard]] ActionError error_of_limit();

/// Runs `body`; if a limit stops it, `error` says which, and the result is false.
template <class Body>
[[nodiscard]] bool guarded(ActionError& error, Body&& body) {
  try {
    return body();
  } catch (...) {
    error = error_of_limit();
  }
  return false;
}

/// Like guarded() above, for work done in every cycle: the error is allocated only when needed.
template <class Body>
[[nodiscard]] bool guarded(std::unique_ptr<ActionError>& error, Body&& body) {
  try {
    return body();
  } catch (...) {
    error = std::make_unique<ActionError>(error_of_limit());
  }
  return false;
}

/// Allows memory beyond an agent's limit while it lives: for reporting a failure when none is left,
/// or for work on another agent's account. The next collection comes at the end of the cycle.
class MemoryReserve {
 public:
  static constexpr std::size_t kForReports = std::size_t{1} << 20U;
  explicit MemoryReserve(Heap& heap, std::size_t bytes = kForReports)
      : heap_(heap), limit_(heap.limit()) {
    heap_.set_limit(std::max(limit_, heap.all_bytes()) + bytes);
  }
  ~MemoryReserve() { heap_.set_limit(limit_); }
  MemoryReserve(const MemoryReserve&) = delete;
  MemoryReserve& operator=(const MemoryReserve&) = delete;

 private:
  Heap& heap_;
  std::size_t limit_;
};

/// No limit while it lives, for work on another's account.
class UnlimitedMemory {
 public:
  static constexpr std::size_t kBytes = std::size_t{1} << 62U;
  explicit UnlimitedMemory(Heap& heap) : heap_(heap), limit_(heap.limit()) {
    heap_.set_limit(kBytes);
  }
  ~UnlimitedMemory() { heap_.set_limit(limit_); }
  UnlimitedMemory(const UnlimitedMemory&) = delete;
  UnlimitedMemory& operator=(const UnlimitedMemory&) = delete;

 private:
  Heap& heap_;
  std::size_t limit_;
};

}  // namespace jaywalk

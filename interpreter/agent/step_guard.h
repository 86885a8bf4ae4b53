#pragma once

// Turns the limits that a query or a term may hit into a failure of the step that hit them.

#include <fmt/format.h>

#include "interpreter/logic/machine.h"
#include "interpreter/term/heap.h"

namespace jaywalk {

/// Runs `body`; if a limit stops it, `error` says which, and the result is false.
template <class Body>
[[nodiscard]] bool guarded(ActionError& error, Body&& body) {
  error.id = "limit";
  try {
    return body();
  } catch (const QueryLimit& limit) {
    error.message = limit.message;
  } catch (const HeapExhausted&) {
    error.message = "the agent's memory limit is reached";
  } catch (const TermTooDeep&) {
    error.message = fmt::format("a term is nested more than {} deep", kMaxTermDepth);
  } catch (const DivisionByZero&) {
    error.id = "division_by_zero";
    error.message = "division by zero in div";
  }
  return false;
}

/// Memory beyond an agent's limit while it lives: what it takes to tell of a failure when there is
/// none left. The next collection comes at the end of the cycle.
class MemoryReserve {
 public:
  explicit MemoryReserve(Heap& heap) : heap_(heap), limit_(heap.limit()) {
    constexpr std::size_t kBytes = std::size_t{1} << 20U;
    heap_.set_limit(limit_ + kBytes);
  }
  ~MemoryReserve() { heap_.set_limit(limit_); }
  MemoryReserve(const MemoryReserve&) = delete;
  MemoryReserve& operator=(const MemoryReserve&) = delete;

 private:
  Heap& heap_;
  std::size_t limit_;
};

}  // namespace jaywalk

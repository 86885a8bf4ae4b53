// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/step_guard.h"

#include <fmt/format.h>

#include "interpreter/term/heap.h"

namespace jaywalk {

ActionError error_of_limit() {
  ActionError error;
  error.id = "limit";
  try {
    throw;
  } catch (const QueryLimit& limit) {
    error.message = limit.message;
    error.limit = limit.limit;
  } catch (const HeapExhausted& exhausted) {
    error.message = exhausted.of_all ? "the memory limit of all agents together is reached"
                                     : "the agent's memory limit is reached";
    error.limit = ReachedLimit::memory;
  } catch (const TermTooDeep&) {
    error.message = fmt::format("a term is nested more than {} deep", kMaxTermDepth);
    error.limit = ReachedLimit::nesting;
  } catch (const TermTooWide&) {
    error.message = fmt::format("a structure has more than {} arguments", kMostParts);
    error.limit = ReachedLimit::nesting;
  } catch (const DivisionByZero&) {
    error.id = "division_by_zero";
    error.message = "division by zero in div";
  }
  return error;
}

}  // namespace jaywalk

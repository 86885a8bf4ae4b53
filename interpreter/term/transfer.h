// SPDX-License-Identifier: Apache-2.0
#pragma once

// Terms on their way from one agent to another.

#include <unordered_map>

#include "interpreter/term/heap.h"

namespace jaywalk {

/// Copies terms into another heap: constants of programs are shared, unbound variables become fresh
/// ones, the same in all terms that one Transfer copies. REQUIRES: the programs outlive the heap.
class Transfer {
 public:
  explicit Transfer(Heap& to) : to_(to) {}
  [[nodiscard]] Value copy(Value term);

 private:
  Value list(Value term);
  Value object(const Object& from);
  Value structure(const Structure& structure);

  Heap& to_;
  std::unordered_map<std::uint64_t, Value> variables_;
  int depth_ = 0;
};

[[nodiscard]] Value transfer(Value term, Heap& to);

}  // namespace jaywalk

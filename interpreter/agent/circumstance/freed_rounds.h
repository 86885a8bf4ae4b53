// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "interpreter/agent/circumstance/intention.h"

namespace jaywalk {

/// While this lives, the variables bound by the rounds of an intention's loops, and those bound by
/// bodies in their goals, are free: the copy of the stack needs the places as well as the values,
/// so that a failure can free them there, too.
class FreedRounds {
 public:
  explicit FreedRounds(Intention& intention) : intention_(intention) {
    for (std::size_t i = 0; i < intention.stack.size(); ++i) {
      const IntendedMeans& means = intention.stack[i];
      if (means.extras) {
        for (const Loop& loop : means.extras->loops) {
          for (const Value place : loop.bound) hold(i, place);
        }
      }
      const Value* const pairs = intention.frame(means) + means.plan->slot_count;
      for (std::size_t k = 0; k + 1 < means.returns; k += 2) {
        if (pairs[k + 1].is_variable()) hold(i, pairs[k + 1]);
      }
    }
  }
  ~FreedRounds() {
    for (std::size_t i = held_.size(); i > 0; --i) {
      cell_of(intention_, held_[i - 1].means, held_[i - 1].place) = held_[i - 1].value;
    }
  }
  FreedRounds(const FreedRounds&) = delete;
  FreedRounds& operator=(const FreedRounds&) = delete;

  struct Held {
    std::size_t means;
    Value place;
    Value value;
  };
  [[nodiscard]] const std::vector<Held>& held() const { return held_; }
  static Value& cell_of(Intention& intention, std::size_t means, Value place) {
    return place.is_slot() ? intention.frame(intention.stack[means])[place.slot_index()]
                           : place.variable()->value;
  }

 private:
  void hold(std::size_t means, Value place) {
    Value& cell = cell_of(intention_, means, place);
    if (cell.is_unset()) return;
    held_.push_back({means, place, cell});
    cell = Value();
  }

  Intention& intention_;
  std::vector<Held> held_;
};

}  // namespace jaywalk

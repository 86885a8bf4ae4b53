// SPDX-License-Identifier: Apache-2.0
#pragma once

// Internal actions with several solutions, without a class for each.

#include <memory>
#include <utility>

#include "interpreter/logic/action.h"

namespace jaywalk {

/// The solutions that a function object makes: it binds and returns true, or returns false at the
/// end.
template <class Next>
class MadeSolutions : public Solutions {
 public:
  explicit MadeSolutions(Next next) : next_(std::move(next)) {}
  bool next(ActionCall& call) override { return next_(call); }

 private:
  Next next_;
};

/// The outcome of an action whose solutions `next(call)` makes, one after another. `next` must own
/// its data: it is called long after the action has returned.
template <class Next>
[[nodiscard]] Outcome each(ActionCall& call, Next next) {
  return call.many(std::make_unique<MadeSolutions<Next>>(std::move(next)));
}

}  // namespace jaywalk

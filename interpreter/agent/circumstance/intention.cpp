// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/circumstance/intention.h"

#include <algorithm>

namespace jaywalk {

std::vector<Value> Intention::goal_arguments(const IntendedMeans& means, Heap& heap) const {
  std::vector<Value> args;
  if (!means.plan->trigger.is_structure()) return args;
  const Value* const slots = values.data() + means.frame;
  const auto known = [&](Value part) { return part.is_slot() ? slots[part.slot_index()] : part; };
  for (const Value arg : means.plan->trigger.structure()->arg_span()) {
    const bool is_list = arg.is_pair();
    args.push_back(is_list ? heap.pair(known(arg.pair()->head), known(arg.pair()->tail))
                           : known(arg));
  }
  return args;
}

void Intention::forget_bottom(std::size_t count) {
  const std::size_t cut = stack[count].frame;
  std::copy(values.begin() + cut, values.end(), values.begin());
  values.cut(values.size() - cut);
  for (std::size_t i = 0; i < count; ++i) {
    if (stack[i].plan->atomic) --atomic_means;
  }
  stack.erase(stack.begin(), stack.begin() + static_cast<std::ptrdiff_t>(count));
  for (IntendedMeans& means : stack) {
    means.frame -= cut;
    means.keeps = std::max(means.keeps, count) - count;
  }
}

void Intention::finish() {
  stack.clear();
  values.clear();
  shrink();
  reason.clear();
  also_suspended = false;
  has_event = false;
  origin = 0;
  shared = 0;
  atomic_means = 0;
  fork.reset();
  state = State::finished;
}

void Intention::shrink() {
  constexpr std::size_t kMostMeans = 32;  // capacity that is kept for later goals
  constexpr std::size_t kMostValues = 128;
  if (stack.capacity() > kMostMeans + 4 * stack.size()) stack.shrink_to_fit();
  if (values.capacity() > kMostValues + 4 * values.size()) values = ValueStack(values);
}

}  // namespace jaywalk

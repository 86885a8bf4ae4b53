#include "interpreter/agent/intention.h"

#include <algorithm>

namespace jaywalk {

IntendedMeans& Intention::push(const Plan& plan, std::span<const Value> slots) {
  IntendedMeans& means = stack.emplace_back();
  means.plan = &plan;
  means.cursor.body = plan.code.entry;
  means.frame = values.size();
  std::copy(slots.begin(), slots.end(), values.extend(slots.size()));
  if (plan.atomic) ++atomic_means;
  return means;
}

void Intention::pop() {
  if (stack.back().plan->atomic) --atomic_means;
  values.cut(stack.back().frame);
  stack.pop_back();
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
  constexpr std::size_t kMostMeans = 32;  // as many are kept for what comes
  constexpr std::size_t kMostValues = 128;
  if (stack.capacity() > kMostMeans + 4 * stack.size()) stack.shrink_to_fit();
  if (values.capacity() > kMostValues + 4 * values.size()) values = ValueStack(values);
}

void Intention::leave_finished_bodies(IntendedMeans& means) {
  while (means.cursor.at_end() && !means.cursor.is_loop && !means.outer.empty()) {
    means.cursor = std::move(means.outer.back());
    means.outer.pop_back();
  }
}

void Intention::advance() {
  IntendedMeans& means = stack.back();
  values.cut(means.frame + means.plan->slot_count);  // an open call's returns are done with
  means.returns = 0;
  ++means.cursor.index;
  leave_finished_bodies(means);
}

}  // namespace jaywalk

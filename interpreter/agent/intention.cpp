#include "interpreter/agent/intention.h"

namespace jaywalk {

void Intention::push(IntendedMeans means, std::span<const Value> slots) {
  means.frame = values.size();
  values.insert(values.end(), slots.begin(), slots.end());
  if (means.plan->atomic) ++atomic_means;
  stack.push_back(std::move(means));
}

void Intention::pop() {
  if (stack.back().plan->atomic) --atomic_means;
  values.resize(stack.back().frame);
  stack.pop_back();
}

void Intention::leave_finished_bodies(IntendedMeans& means) {
  while (means.cursor.at_end() && !means.cursor.is_loop && !means.outer.empty()) {
    means.cursor = std::move(means.outer.back());
    means.outer.pop_back();
  }
}

void Intention::advance() {
  IntendedMeans& means = stack.back();
  values.resize(means.frame + means.plan->slot_count);  // an open call's returns are done with
  means.returns = 0;
  ++means.cursor.index;
  leave_finished_bodies(means);
}

}  // namespace jaywalk

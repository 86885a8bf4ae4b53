// SPDX-License-Identifier: Apache-2.0
#include "interpreter/embed/formula_with_values.h"

#include "interpreter/agent/agent.h"
#include "interpreter/term/print.h"

namespace jaywalk {

std::string formula_with_values(Agent& agent, const Intention& intention, const Step& step) {
  if (step.source.is_unset()) return {};
  Unifier& unifier = agent.machine().unifier();
  const IntendedMeans& means = intention.stack.back();
  const std::span<const Symbol> names = unifier.slot_names();
  unifier.set_slot_names(means.plan->slot_names);
  const std::size_t trail = unifier.mark();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): bindings in the frame are undone
  Value* const frame = const_cast<Intention&>(intention).frame(means);
  const Value formula = unifier.instantiate(step.source, frame);
  std::string text = term_text(formula, agent.symbols());
  unifier.undo(trail);
  unifier.set_slot_names(names);
  return text;
}

}  // namespace jaywalk

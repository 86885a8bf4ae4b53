// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/execution/step_texts.h"

#include <fmt/format.h>

#include "interpreter/support/text.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

std::string source_of(Unifier& unifier, const Plan& plan, const Step& step) {
  unifier.set_slot_names(plan.slot_names);
  ScratchSlots slots(unifier, plan.slot_count);
  return brief_text(unifier.instantiate(step.source, slots.data()), unifier.symbols());
}

// The formulas that are left. A body may have thousands of them, and of variables.
std::string texts_from(Unifier& unifier, const Plan& plan, const Step* step) {
  std::string text;
  for (; step != nullptr; step = step->next) {
    if (step->source.is_unset()) continue;  // the end of a branch
    if (!text.empty()) text += "; ";
    text += source_of(unifier, plan, *step);
    if (text.size() > kLongestLogged) return shortened(text, kLongestLogged);
  }
  return text;
}

std::string values_of(Unifier& unifier, const Plan& plan, const Value* frame) {
  std::string text;
  for (std::size_t i = 0; i < plan.own_slots; ++i) {
    const Value value = deref(frame[i]);
    if (plan.slot_names[i] == names::unnamed || value.is_unset() || value.is_variable()) continue;
    if (!text.empty()) text += ", ";
    text += fmt::format("{}={}", unifier.symbols().text(plan.slot_names[i]),
                        brief_text(value, unifier.symbols()));
    if (text.size() > kLongestLogged) return shortened(text, kLongestLogged);
  }
  return text;
}

}  // namespace

std::string text_as_written(Unifier& unifier, const Plan& plan, const Step& step) {
  const std::string text = source_of(unifier, plan, step);
  const std::size_t begin = text.find_first_not_of("?!+-<>");
  return begin == std::string::npos ? text : text.substr(begin);
}

ActionError constraint_failure(Unifier& unifier, Intention& intention) {
  const IntendedMeans& means = intention.top();
  const Plan& plan = *means.plan;
  const std::string left = texts_from(unifier, plan, means.current);
  ActionError error;
  error.id = "constraint_failed";
  error.message =
      fmt::format("Constraint {} was not satisfied (file:{}:{}) un={{{}}}", left, plan.file,
                  means.step().place.line, values_of(unifier, plan, intention.frame(means)));
  return error;
}

}  // namespace jaywalk

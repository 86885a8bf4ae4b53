#include "tools/jaywalk/repl/repl_trace.h"

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

// The formula with the values that its variables have by now.
std::string formula_text(Agent& agent, const Intention& intention, const Step& step) {
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

}  // namespace

void ReplTrace::event_selected(Agent& agent, const Event& event) {
  if (on_) tell(fmt::format("event    {}", agent.trigger_text(event)));
}

void ReplTrace::plan_tried(Agent& agent, const Plan& plan, bool applicable) {
  if (on_ && !plan.is_standard && !applicable) {
    tell(fmt::format("  not    {}: its context does not hold", agent.plan_name(plan)));
  }
}

void ReplTrace::plan_chosen(Agent& agent, const Plan& plan, const Event& /*event*/,
                            const Intention& /*intention*/) {
  if (on_ && !plan.is_standard) tell(fmt::format("  takes  {}", agent.plan_name(plan)));
}

void ReplTrace::no_plan(Agent& /*agent*/, const Event& /*event*/, bool had_candidates) {
  if (on_) tell(had_candidates ? "  no plan is applicable" : "  there is no plan for it");
}

void ReplTrace::formula_executes(Agent& agent, const Intention& intention, const Step& step) {
  if (on_) tell(fmt::format("formula  {}", formula_text(agent, intention, step)));
}

void ReplTrace::formula_failed(Agent& /*agent*/, const Intention& /*intention*/,
                               const ActionError& error) {
  if (!on_) return;
  const std::string why = error.message.empty() ? std::string() : ": " + error.message;
  tell(fmt::format("  fails  {}{}", error.id, why));
}

}  // namespace jaywalk

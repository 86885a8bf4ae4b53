#include "tools/jaywalk/run/agent_trace.h"

#include <nlohmann/json.hpp>

#include "interpreter/agent/agent.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

/// The formula's literal with the values that its variables have by now.
Value literal_of(Agent& agent, const Intention& intention, const Step& step, std::size_t& trail) {
  Unifier& unifier = agent.machine().unifier();
  trail = unifier.mark();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): bindings in the frame are undone
  Value* const frame = const_cast<Intention&>(intention).frame(intention.stack.back());
  return deref(unifier.instantiate(step.term, frame));
}

bool is_percept(Value literal, const SymbolTable& symbols) {
  literal = deref(literal);
  if (!is_literal(literal)) return false;
  for (Value a = literal_parts(literal).annots; a.is_pair(); a = deref(a.pair()->tail)) {
    const Value annot = deref(a.pair()->head);
    if (annot.is_structure() && symbols.functor(annot.structure()->predicate()) == "source" &&
        term_text(annot.structure()->arg(0), symbols) == "percept") {
      return true;
    }
  }
  return false;
}

}  // namespace

void AgentTrace::append(const Line& line) {
  lines_ += line.dump(-1, ' ', false, Line::error_handler_t::replace);
  lines_ += '\n';
}

AgentTrace::Line AgentTrace::line(std::string_view kind, Agent& agent) {
  return {{"kind", kind}, {unit_, now(agent)}, {"agent", agent.name()}};
}

void AgentTrace::event_posted(Agent& agent, const Event& event) {
  const bool percept =
      event.kind == TriggerKind::belief && is_percept(event.literal, agent.symbols());
  Line said = line(percept ? "percept" : "event", agent);
  said[percept ? "change" : "event"] = agent.trigger_text(event);
  append(said);
}

void AgentTrace::plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                             const Intention& /*intention*/) {
  if (plan.is_standard) return;
  Line said = line("plan", agent);
  said["event"] = agent.trigger_text(event);
  said["plan"] = agent.plan_name(plan);
  append(said);
}

void AgentTrace::formula_executes(Agent& agent, const Intention& intention, const Step& step) {
  const bool acts = step.kind == Step::Kind::action;
  if ((!acts && step.kind != Step::Kind::internal_action) || step.term.is_unset()) return;
  std::size_t trail = 0;
  const Value literal = literal_of(agent, intention, step, trail);
  if (acts) {
    // An agent that acts again has had no failure of its last action.
    const auto before = actions_.find(agent.name());
    if (before != actions_.end()) write(before->second, before->first);
    actions_[agent.name()] = {.text = term_text(literal, agent.symbols()), .when = now(agent)};
  } else if (is_literal(literal)) {
    const LiteralParts parts = literal_parts(literal);
    const std::string_view name = agent.symbols().functor(parts.predicate);
    const bool to_all = name == ".broadcast";
    if ((to_all && parts.args.size() >= 2) || (name == ".send" && parts.args.size() >= 3)) {
      const std::size_t first = to_all ? 0 : 1;
      const auto text = [&](std::size_t i) { return term_text(parts.args[i], agent.symbols()); };
      Line said = line("message", agent);
      said["to"] = to_all ? "all" : text(0);
      said["performative"] = text(first);
      said["content"] = text(first + 1);
      append(said);
    }
  }
  agent.machine().unifier().undo(trail);
}

void AgentTrace::formula_failed(Agent& agent, const Intention& /*intention*/,
                                const ActionError& error) {
  const auto action = actions_.find(agent.name());
  if (action != actions_.end() && error.id == "action_failed") {
    action->second.failed = true;
    action->second.reason = error.message;
    write(action->second, action->first);
    actions_.erase(action);
    return;
  }
  Line said = line("failure", agent);
  said["error"] = error.id;
  said["reason"] = error.message;
  append(said);
}

void AgentTrace::write(const Action& action, const std::string& agent) {
  Line said{{"kind", "action"},
            {unit_, action.when},
            {"agent", agent},
            {"action", action.text},
            {"outcome", action.failed ? "failed" : "done"}};
  if (action.failed) said["reason"] = action.reason;
  append(said);
}

}  // namespace jaywalk

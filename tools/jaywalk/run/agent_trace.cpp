// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/run/agent_trace.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

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

constexpr std::size_t kMostKept = std::size_t{1} << 16U;

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
  show_with_values(agent, intention, step.term, [&](Value literal) {
    if (acts) note_action(agent, literal);
    if (!acts) note_message(agent, literal);
  });
}

void AgentTrace::note_action(Agent& agent, Value action) {
  // An agent that acts again has had no failure of its last action.
  const auto before = actions_.find(agent.name());
  if (before != actions_.end()) write(before->second, before->first);
  actions_[agent.name()] = {.text = term_text(action, agent.symbols()), .when = now(agent)};
}

void AgentTrace::note_message(Agent& agent, Value action) {
  if (!is_literal(action)) return;
  const LiteralParts parts = literal_parts(action);
  const std::string_view name = agent.symbols().functor(parts.predicate);
  const bool to_all = name == ".broadcast";
  const std::size_t first = to_all ? 0 : 1;
  if (!(to_all && parts.args.size() >= 2) && !(name == ".send" && parts.args.size() >= 3)) return;
  const auto text = [&](std::size_t i) { return term_text(parts.args[i], agent.symbols()); };
  Line said = line("message", agent);
  said["to"] = to_all ? "all" : text(0);
  said["performative"] = text(first);
  said["content"] = text(first + 1);
  append(said);
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

void ProgramTrace::begin(std::string_view program, std::size_t agents, std::uint64_t seed) {
  append({{"kind", "run"}, {"program", program}, {"agents", agents}, {"seed", seed}});
}

std::uint64_t ProgramTrace::now(Agent& agent) {
  if (agent.number() >= cycles_.size()) cycles_.resize(agent.number() + 1);
  const std::uint64_t cycle = agent.cycles();
  std::uint64_t& last = cycles_[agent.number()];
  if (std::exchange(last, cycle) == cycle) return cycle;
  if (lines_.size() >= kMostKept) hand_over();
  append({{"kind", "cycle"},
          {"cycle", cycle},
          {"agent", agent.name()},
          {"time_s", agent.host().now_ms() / 1000}});
  return cycle;
}

void ProgramTrace::hand_over() { file_.add(parts_++, std::exchange(lines_, {})); }

void ProgramTrace::end(std::string_view how, std::string_view why, double time_s, int exit_code) {
  for (const auto& [agent, action] : actions_) write(action, agent);
  actions_.clear();
  Line line{{"kind", "end"}, {"ended", how}, {"time_s", time_s}, {"exit_code", exit_code}};
  if (!why.empty()) line["reason"] = why;
  append(line);
  hand_over();
}

void TestTrace::begin(std::string_view behaviour, const TestSetup& setup) {
  append({{"kind", "test"},
          {"behaviour", behaviour},
          {"agents", setup.agents},
          {"test", setup.test},
          {"seed", setup.seed}});
}

void TestTrace::tick(const World& world, const Mas& mas) {
  const auto ticks = static_cast<std::uint64_t>(world.ticks());
  // Agents perceive a failed action one tick later: outcomes before this tick are known by now.
  for (auto it = actions_.begin(); it != actions_.end();) {
    if (it->second.when >= ticks && !world.finished()) {
      ++it;
      continue;
    }
    // After the last tick agents perceive nothing more; ask the world whether their actions failed.
    for (std::size_t i = 0; it->second.when >= ticks && i < mas.agent_count(); ++i) {
      if (mas.agent_name(static_cast<AgentId>(i)) != it->first) continue;
      it->second.failed = it->second.failed || world.last_action_failed(i);
    }
    write(it->second, it->first);
    it = actions_.erase(it);
  }
  append({{"kind", "tick"}, {"tick", world.ticks()}, {"time_s", world.ticks() * world.tick_s()}});
  tick_ = ticks + 1;
}

void TestTrace::end(const TestRun& result) {
  Line line{{"kind", "end"},
            {"completed", result.completed},
            {"met_precondition", result.outcome.success},
            {"ticks", result.outcome.ticks},
            {"score", result.outcome.score()},
            {"collisions", result.outcome.collisions.size()}};
  if (!result.completed) line["reason"] = result.message;
  append(line);
}

}  // namespace jaywalk

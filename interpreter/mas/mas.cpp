// SPDX-License-Identifier: Apache-2.0
#include "interpreter/mas/mas.h"

#include <cstdlib>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/mas/system.h"
#include "interpreter/term/print.h"

namespace jaywalk {

std::string_view name(RunLimit limit) {
  switch (limit) {
    case RunLimit::none:
      return "";
    case RunLimit::cycles:
      return "cycles";
    case RunLimit::ticks:
      return "ticks";
    case RunLimit::rounds:
      return "rounds";
    case RunLimit::inferences:
      return "inferences";
    case RunLimit::memory:
      return "memory";
  }
  std::abort();
}

Mas::Mas(std::shared_ptr<const SymbolTable> symbols, MasOptions options, Environment* environment)
    : implementation_(std::make_unique<Implementation>(
          std::make_unique<SystemStock>(std::move(symbols)), std::move(options), environment)) {}
Mas::~Mas() = default;

void Mas::restart(MasOptions options, Environment* environment) {
  std::unique_ptr<SystemStock> stock = Implementation::dismantle(std::move(implementation_));
  implementation_ =
      std::make_unique<Implementation>(std::move(stock), std::move(options), environment);
}

AgentId Mas::add_agent(const AgentSpec& spec) { return implementation_->add_agent(spec); }

void Mas::embody_newcomers() { implementation_->embody_newcomers(); }

RunOutcome Mas::run() {
  while (stride()) {
  }
  return outcome();
}

bool Mas::step() { return implementation_->step(); }
bool Mas::stride() { return implementation_->stride(); }
const RunOutcome& Mas::outcome() const { return implementation_->outcome(); }
std::size_t Mas::agent_count() const { return implementation_->records().size(); }

bool Mas::is_alive(AgentId id) const {
  const auto number = static_cast<std::uint32_t>(id);
  const AgentTable& records = implementation_->records();
  return number < records.size() && !records[number].is_leaving;
}

const Agent& Mas::agent(AgentId id) const {
  Agent& agent = *implementation_->records()[static_cast<std::uint32_t>(id)].agent;
  agent.start_if_due();
  return agent;
}

const std::string& Mas::agent_name(AgentId id) const {
  static const std::string kNobody;
  if (!is_alive(id)) return kNobody;
  return implementation_->records()[static_cast<std::uint32_t>(id)].agent->name();
}

std::vector<std::string> Mas::describe_intentions(AgentId id) const {
  if (!is_alive(id)) return {};
  const Agent& the_agent = agent(id);
  std::vector<std::string> texts;
  for (const auto& intention : the_agent.circumstance().intentions) {
    std::string text;
    for (const IntendedMeans& means : intention->stack) {
      if (!text.empty()) text += " > ";
      text += goal_text(*intention, means, the_agent.symbols());
    }
    if (!text.empty()) texts.push_back(std::move(text));
  }
  return texts;
}

std::vector<std::string> Mas::describe_beliefs(AgentId id) const {
  std::vector<std::string> texts;
  each_belief(id, [&](Value belief) { texts.push_back(term_text(belief, agent(id).symbols())); });
  return texts;
}

void Mas::each_belief(AgentId id, const std::function<void(Value belief)>& callback) const {
  if (!is_alive(id)) return;
  for (const auto& relation : agent(id).beliefs().relations()) {
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Row& row = relation->row(seq);
      if (!row.fact.is_unset()) callback(row.fact);
    }
  }
}

bool Mas::intervene(AgentId id, const std::function<void(Agent& agent)>& work,
                    std::string& problem) {
  if (!is_alive(id)) {
    problem = "there is no such agent";
    return false;
  }
  return implementation_->intervene(id, work, problem);
}

SymbolTable& Mas::symbols() { return implementation_->symbols(); }
double Mas::now_ms() const { return implementation_->now_ms(); }
std::optional<double> Mas::next_timer_ms() { return implementation_->next_timer_ms(); }
double Mas::reasoning_cpu_s() const { return implementation_->reasoning_cpu_s(); }

}  // namespace jaywalk

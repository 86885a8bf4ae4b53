// SPDX-License-Identifier: Apache-2.0
#include "interpreter/mas/system.h"

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/agent/step_guard.h"

namespace jaywalk {

Mas::Implementation::Implementation(std::unique_ptr<SystemStock> stock, MasOptions options,
                                    Environment* environment)
    : stock_(std::move(stock)),
      symbols_(stock_->symbols),
      options_(std::move(options)),
      environment_(environment),
      services_(
          [this](const std::string& subscriber, const std::string& provider,
                 const std::string& service) { tell_of_provider(subscriber, provider, service); }) {
  if (options_.max_system_bytes == 0) options_.max_system_bytes = half_of_the_machines_memory();
  if (environment_ != nullptr) environment_->use_names(symbols_);
  counted_symbols_ = symbols_.symbol_count();
  counted_predicates_ = symbols_.predicate_count();
  share_memory();
  inferences_before_ = stock_->workspaces.inferences();
  count_inferences({});
  if (options_.threads < 2 || options_.observer != nullptr) return;
  symbols_.allow_threads();
  workers_ = std::make_unique<Workers>(options_.threads);
  for (std::size_t worker = 0; worker < options_.threads; ++worker) {
    workspaces_of_workers_.push_back(std::make_unique<WorkspacePool>(symbols_));
  }
  count_inferences({});
}

const RunOutcome& Mas::Implementation::outcome() {
  // Within a step, what is under way does not count yet.
  outcome_.inferences = std::max(outcome_.inferences, inferences());
  return outcome_;
}

std::unique_ptr<SystemStock> Mas::Implementation::dismantle(
    std::unique_ptr<Implementation> system) {
  constexpr std::size_t kMostRemains = 64;
  system->stock_->workspaces.want_remains(kMostRemains);
  for (AgentRecord& record : system->table_.all()) {
    if (!record.has_body() || system->stock_->percepts.size() == kMostRemains) continue;
    record.percepts->clear();
    system->stock_->percepts.push_back(std::move(record.percepts));
  }
  system->table_ = {};
  system->mail_.reset();
  std::unique_ptr<SystemStock> stock = std::move(system->stock_);
  system.reset();
  stock->symbols.clear_layer();
  return stock;
}

// Agents come and go.

AgentRecord& Mas::Implementation::settle(const std::string& name,
                                         std::shared_ptr<const Program> program) {
  const std::uint64_t seed = mix_seed(options_.seed ^ mix_seed(table_.size()));
  check_isolation(*program);
  auto agent =
      std::make_unique<Agent>(table_.free_name(name), program, symbols_, *this, seed,
                              AgentLimits{options_.max_agent_bytes, options_.max_inferences});
  if (workers_ != nullptr) reaches_.add(*program, symbols_);
  AgentRecord& record = table_.add(std::move(agent), std::move(program));
  record.known_bytes = sizeof(Agent) + sizeof(AgentRecord);
  owned_bytes_ += static_cast<std::int64_t>(record.known_bytes);
  table_.wake(record);
  turn_.has_business = true;
  return record;
}

void Mas::Implementation::start(Agent& agent, const AgentSpec& spec) {
  std::vector<Predicate> replaced;
  std::vector<Value> given;
  agent.customise(spec.customisation);
  if (spec.parameters.empty() && spec.customisation == nullptr && options_.observer == nullptr &&
      spec.program->can_start_later()) {
    agent.start_later();
    return;
  }
  ActionError error;
  const bool started = guarded(error, [&] {
    for (const Parameter& parameter : spec.parameters) {
      replaced.push_back(parameter.predicate);
      given.push_back(agent.heap().structure(parameter.predicate, parameter.args, source_self()));
    }
    agent.start(replaced, given);
    return true;
  });
  if (!started) {
    agent.log("in its initial beliefs and goals: " + error.message);
    limit_reached(agent, error.limit, "its initial beliefs and goals");
  }
  agent.rest();
  if (!agent.is_active()) put_to_sleep(table_.of(agent));
}

std::unique_ptr<Percepts> Mas::Implementation::percepts_for_body() {
  if (stock_->percepts.empty()) return std::make_unique<Percepts>();
  std::unique_ptr<Percepts> percepts = std::move(stock_->percepts.back());
  stock_->percepts.pop_back();
  return percepts;
}

AgentId Mas::Implementation::add_agent(const AgentSpec& spec) {
  AgentRecord& record = settle(spec.name, spec.program);
  if (spec.customisation != nullptr) all_keep_to_themselves_ = false;
  if (environment_ != nullptr) record.percepts = percepts_for_body();
  go_on_after_idleness();
  record.agent->set_settings(spec.settings);
  start(*record.agent, spec);
  return AgentId{record.number};
}

// Why there can be no more agents; empty if there can.
std::string Mas::Implementation::problem_with_more_agents() const {
  if (table_.living() >= options_.max_agents) {
    return fmt::format("the limit of {} agents is reached", options_.max_agents);
  }
  if (owned_bytes_ >= static_cast<std::int64_t>(options_.max_system_bytes)) {
    return "the memory limit of all agents together is reached";
  }
  return {};
}

std::shared_ptr<const Program> Mas::Implementation::load(const ProgramRequest& request,
                                                         LoadProblem& problem) {
  if (!options_.load_program) {
    problem.text = "programs cannot be loaded in this run";
    return nullptr;
  }
  auto program = options_.load_program(request, symbols_, problem);
  if (program != nullptr && !problem.text.empty() && options_.log) {
    put_out(Outbox::Kind::log, problem.text);  // of an included file that is left out
    problem.text.clear();
  }
  if (program != nullptr) loaded_.insert(program);
  if (program != nullptr && workers_ != nullptr) reaches_.add(*program, symbols_);
  return program;
}

bool Mas::Implementation::save(const std::string& file, const std::string& text,
                               std::string& error) {
  if (options_.save_program) return options_.save_program(file, text, error);
  error = "files cannot be written in this run";
  return false;
}

std::string Mas::Implementation::why_not_list(const std::string& folder) {
  return options_.why_not_list ? options_.why_not_list(folder)
                               : "files cannot be listed in this run";
}

Society::Creation Mas::Implementation::create(const std::string& name, const std::string& file) {
  if (std::string problem = problem_with_more_agents(); !problem.empty()) return {{}, problem};
  AgentSpec spec;
  LoadProblem trouble;
  spec.program = load({.file = file, .included = false, .ns = {}}, trouble);
  if (spec.program == nullptr) return {{}, trouble.text};
  AgentRecord& record = settle(name, spec.program);
  if (newcomers_have_bodies_) record.percepts = percepts_for_body();
  Agent& agent = *record.agent;
  start(agent, spec);
  return {agent.name(), {}};
}

Society::Creation Mas::Implementation::clone(Agent& original, const std::string& name) {
  if (std::string problem = problem_with_more_agents(); !problem.empty()) return {{}, problem};
  AgentRecord& record = settle(name, table_.of(original).program);
  if (newcomers_have_bodies_) record.percepts = percepts_for_body();
  Agent& agent = *record.agent;
  agent.copy_from(original);
  agent.rest();
  return {agent.name(), {}};
}

bool Mas::Implementation::kill(std::string_view name, double deadline_ms) {
  AgentRecord* const record = table_.find(name);
  if (record == nullptr) return false;
  if (deadline_ms > 0) {
    const Value ms = Value::number(deadline_ms);
    announce(*record->agent, predicates::jag_shutting_down, std::span(&ms, 1));
    timers_.add({.at_ms = now_ms_ + deadline_ms,
                 .purpose = Timer::Purpose::departure,
                 .agent = record->number});
  } else {
    leave(*record);
  }
  return true;
}

void Mas::Implementation::leave(AgentRecord& record) {
  turn_.has_business = true;
  services_.forget(record.agent->name());
  release_memory(record);
  table_.remove(record);
}

void Mas::Implementation::stop(Agent& agent, double deadline_ms, int exit_code) {
  if (ParallelBlock* const block = this->block_of(agent)) {
    end({.how = RunEnd::stopped, .exit_code = exit_code}, block);
    return;
  }
  turn_.has_business = true;
  outcome_.exit_code = exit_code;
  if (deadline_ms <= 0) {
    end({.how = RunEnd::stopped, .exit_code = exit_code});
    return;
  }
  const Value ms = Value::number(deadline_ms);
  for (AgentRecord& record : table_.all()) {
    if (record.is_leaving) continue;
    announce(*record.agent, predicates::jag_shutting_down, std::span(&ms, 1));
  }
  timers_.add({.at_ms = now_ms_ + deadline_ms, .purpose = Timer::Purpose::stop});
}

void Mas::Implementation::end(Outbox::End how, ParallelBlock* block) {
  (block != nullptr ? *block : turn_).has_business = true;
  if (has_ended(block)) return;
  if (block != nullptr) {
    block->outbox.end = std::move(how);
    return;
  }
  ended_ = true;
  outcome_.end = how.how;
  outcome_.message = std::move(how.message);
  outcome_.exit_code = how.exit_code;
  outcome_.limit = how.limit;
  outcome_.agent = std::move(how.agent);
  outcome_.where = std::move(how.where);
}

// From outside, agents get something to do after all were idle.
void Mas::Implementation::go_on_after_idleness() {
  if (ended_ && outcome_.end == RunEnd::idle) ended_ = false;
}

bool Mas::Implementation::intervene(AgentId id, const std::function<void(Agent& agent)>& work,
                                    std::string& problem) {
  AgentRecord& record = table_[static_cast<std::uint32_t>(id)];
  Agent& agent = *record.agent;
  all_keep_to_themselves_ = false;  // it may get other plans
  turn_.texts.begin_turn(left_bytes_);
  const bool completed = agent.intervene([&] { work(agent); }, problem);
  go_on_after_idleness();
  if (agent.is_active()) wake(record);
  return completed;
}

// Requests of agents to the system.

void Mas::Implementation::set_timer(Agent& agent, double at_ms, std::uint64_t token) {
  const Timer timer{.at_ms = at_ms, .agent = table_.of(agent).number, .token = token};
  if (ParallelBlock* const block = this->block_of(agent)) {
    block->outbox.add(timer);
  } else {
    timers_.add(timer);
  }
}

bool Mas::Implementation::act(Agent& agent) { return table_.of(agent).has_body(); }

void Mas::Implementation::print(Agent& agent, std::string_view text) {
  if (options_.print)
    put_out(Outbox::Kind::print, fmt::format("[{}] {}", agent.name(), text), block_of(agent));
}

void Mas::Implementation::write(Agent& agent, std::string_view text) {
  if (options_.write) put_out(Outbox::Kind::write, std::string(text), block_of(agent));
}

void Mas::Implementation::log(Agent& agent, std::string_view text) {
  if (!options_.log) return;
  std::string line = fmt::format("[{}] {}", agent.name(), text);
  ParallelBlock* const block = this->block_of(agent);
  Batch& batch = block != nullptr ? block->batch : batch_;
  if (&agent == batch.agent) {
    batch.lines.push_back({agent.cycles() - batch.since, std::move(line)});
  } else {
    put_out(Outbox::Kind::log, line, block);
  }
}

void Mas::Implementation::put_out(Outbox::Kind kind, const std::string& text,
                                  ParallelBlock* block) {
  if (block != nullptr) {
    block->outbox.add_text(kind, text);
  } else if (kind == Outbox::Kind::print) {
    options_.print(text);
  } else if (kind == Outbox::Kind::write) {
    options_.write(text);
  } else {
    options_.log(text);
  }
}

std::vector<std::string> Mas::Implementation::names() const {
  std::vector<std::string> names;
  names.reserve(table_.all().size());
  for (const AgentRecord& record : table_.all()) {
    if (!record.is_leaving) names.push_back(record.agent->name());
  }
  return names;
}

// Events about the agent itself. Most agents have no plans for them.

void Mas::Implementation::announce(Agent& agent, Predicate predicate, std::span<const Value> args) {
  agent.start_if_due();
  const Value literal =
      args.empty() ? Value::atom(predicate) : agent.heap().structure(predicate, args);
  agent.add_event({TriggerOperator::add, TriggerKind::belief, literal, nullptr, 0});
  if (agent.is_active()) table_.wake(table_.of(agent));
}

void Mas::Implementation::put_to_sleep(AgentRecord& record) {
  if (record.is_asleep) return;
  record.is_asleep = true;
  announce(*record.agent, predicates::jag_sleeping, {});
}

void Mas::Implementation::wake(AgentRecord& record) {
  table_.wake(record);
  if (!record.is_asleep) return;
  record.is_asleep = false;
  announce(*record.agent, predicates::jag_awaking, {});
}

}  // namespace jaywalk

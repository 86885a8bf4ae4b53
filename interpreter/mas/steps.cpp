// SPDX-License-Identifier: Apache-2.0
// The steps of a run: ticks of an environment, or cycles of all active agents while virtual time
// stands still; and what happens between them.

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

#include <fmt/format.h>

#include "interpreter/agent/goal_stack.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/mas/system.h"

namespace jaywalk {
namespace {

/// How long the virtual clock lets busy agents reason while it moves on by a millisecond, so that
/// an agent that never rests does not keep the others from waking up. Few programs get there before
/// they wait.
constexpr std::uint64_t kStepsPerMs = 1000;

/// How long a step may sleep in real time; between steps the run can be interrupted.
constexpr double kLongestSleepMs = 20;

/// The cycles of one agent between two checks of the run's limits.
constexpr std::uint64_t kCyclesBetweenLooks = 4096;

double thread_cpu_s() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

void sleep_ms(double ms) {
  if (ms > 0) std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(ms));
}

}  // namespace

bool Mas::Implementation::step() {
  if (ended_) return false;
  environment_ != nullptr ? tick() : free_step(1);
  return is_to_go_on();
}

bool Mas::Implementation::is_to_go_on() {
  if (table_.has_leaving()) table_.bury();
  if (!ended_ && interrupted()) end({.how = RunEnd::interrupted});
  return !ended_;
}

bool Mas::Implementation::stride() {
  if (ended_) return false;
  AgentRecord* const lone =
      environment_ == nullptr && !options_.realtime ? table_.lone_active() : nullptr;
  if (lone != nullptr && !lone->is_leaving && lone->agent->is_active()) {
    reason_alone(*lone);
  } else {
    constexpr std::uint64_t kMostAtOnce = 32;
    environment_ != nullptr ? tick() : free_step(kMostAtOnce);
  }
  return is_to_go_on();
}

// Free steps, as long as only one agent takes part in each and no time passes: the same one, or one
// that the last one has sent a message.
void Mas::Implementation::reason_alone(AgentRecord& first) {
  constexpr std::uint64_t kLongestStride = 64;  // cycles; then the caller may look at the clock
  const std::uint64_t end = outcome_.cycles + kLongestStride;
  AgentRecord* lone = &first;
  while (lone != nullptr && !lone->is_leaving && lone->agent->is_active()) {
    const std::uint64_t start = outcome_.cycles;
    turn_.texts.begin_turn(left_bytes_);
    reason(*lone, std::min(end - start, kStepsPerMs - busy_steps_));
    if (ended_) return;
    share_memory();
    deliver_messages();
    busy_steps_ += outcome_.cycles - start;
    steps_ += outcome_.cycles - start;
    if (busy_steps_ >= kStepsPerMs) {
      pass_busy_ms();
      return;
    }
    table_.end_round();
    if (outcome_.cycles >= end || table_.has_leaving()) return;
    lone = table_.lone_active();
  }
}

void Mas::Implementation::pass_busy_ms() {
  busy_steps_ = 0;
  now_ms_ += 1;
  fire_timers();
}

double Mas::Implementation::wall_ms() const {
  const std::chrono::duration<double, std::milli> passed =
      std::chrono::steady_clock::now() - wall_start_;
  return passed.count();
}

// Cycles of an agent that has something to do: `most` at most, and none after one in which it has
// asked anything of others.
void Mas::Implementation::reason(AgentRecord& record, std::uint64_t most) {
  Agent& agent = *record.agent;
  if (record.period != period_) {
    record.period = period_;
    record.cycles_before = agent.cycles();
  }
  most =
      std::min(most - 1, options_.max_cycles_per_tick - (agent.cycles() - record.cycles_before)) +
      1;
  if (options_.max_cycles > agent.cycles()) {
    most = std::min(most, options_.max_cycles - agent.cycles());
  }
  // Interrupts and limits are checked now and then.
  if (options_.interrupted || options_.max_run_inferences != 0) {
    most = std::min(most, kCyclesBetweenLooks);
  }
  allow_memory(record);
  agent.turn().has_business = false;
  const std::uint64_t taken = agent.reason(most);
  ParallelBlock* const block = this->block_of(agent);
  (block != nullptr ? block->outbox.cycles : outcome_.cycles) += taken;
  note_memory(record, block != nullptr ? block->outbox.grown : owned_bytes_);
  if (has_ended(block)) note_who_stopped(agent);
  const std::uint64_t in_period = agent.cycles() - record.cycles_before;
  if (in_period > options_.max_cycles_per_tick) {
    end({.how = RunEnd::looping,
         .message = busy_message(agent, options_.max_cycles_per_tick),
         .limit = RunLimit::cycles,
         .agent = agent.name(),
         .where = last_place(agent)},
        block);
  } else if (options_.max_cycles != 0 && agent.cycles() >= options_.max_cycles) {
    end({.how = RunEnd::limit,
         .message = fmt::format("agent {} reached the limit of {} cycles", agent.name(),
                                options_.max_cycles),
         .limit = RunLimit::cycles,
         .agent = agent.name(),
         .where = last_place(agent)},
        block);
  }
  if (options_.max_run_inferences != 0 && block == nullptr) count_inferences(agent.name());
  if (!record.is_leaving && !agent.is_active()) put_to_sleep(record);
}

void Mas::Implementation::note_who_stopped(Agent& agent) {
  if (ParallelBlock* const block = this->block_of(agent)) {
    Outbox::End& end = *block->outbox.end;
    if (end.how == RunEnd::stopped) end.agent = agent.name();
  } else if (outcome_.end == RunEnd::stopped) {
    outcome_.agent = agent.name();
  }
}

// Inferences of the run's queries, without those of agents that are reasoning.
std::uint64_t Mas::Implementation::inferences() const {
  std::uint64_t all = stock_->workspaces.inferences();
  for (const auto& pool : workspaces_of_workers_) all += pool->inferences();
  return all - std::min(all, inferences_before_);
}

// Counts inferences against the run's limit, and ends the run when it is reached. Agents that
// reason in parallel may each take the remainder before the round.
void Mas::Implementation::count_inferences(std::string agent) {
  const std::uint64_t most = options_.max_run_inferences;
  const std::uint64_t taken = most == 0 ? 0 : inferences();
  const std::uint64_t left = most == 0 ? UINT64_MAX : most - std::min(most, taken);
  stock_->workspaces.set_inferences_left(left);
  for (const auto& pool : workspaces_of_workers_) pool->set_inferences_left(left);
  if (left > 0) return;
  std::string message = fmt::format("{} inferences, the limit of the run{}{}{}", most,
                                    agent.empty() ? "" : fmt::format(": agent {}", agent),
                                    last_query_.empty() ? "" : " in ", last_query_);
  end({.how = RunEnd::limit,
       .message = std::move(message),
       .limit = RunLimit::inferences,
       .agent = std::move(agent),
       .where = last_query_});
}

void Mas::Implementation::limit_reached(Agent& agent, ReachedLimit limit, std::string where) {
  if (limit == ReachedLimit::memory &&
      options_.at_memory_limit == MasOptions::AtMemoryLimit::end_run) {
    const bool of_all = agent.heap().limit() < options_.max_agent_bytes;
    std::string message = fmt::format("agent {} needs more memory than {}{}{}", agent.name(),
                                      of_all ? "all agents together may have" : "it may have",
                                      where.empty() ? "" : ", in ", where);
    end({.how = RunEnd::limit,
         .message = std::move(message),
         .limit = RunLimit::memory,
         .agent = agent.name(),
         .where = std::move(where)},
        block_of(agent));
  } else if (limit == ReachedLimit::inferences && block_of(agent) == nullptr) {
    last_query_ = std::move(where);
    turn_.has_business = true;  // perhaps it was the run's limit
  }
}

// The place of the latest intention's formula.
std::string Mas::Implementation::last_place(const Agent& agent) {
  std::string place;
  for (const auto& intention : agent.circumstance().intentions) {
    if (!intention->is_finished()) place = formula_place(*intention);
  }
  return place;
}

std::string Mas::Implementation::busy_message(const Agent& agent, std::uint64_t cycles) {
  std::string doing;
  for (const auto& intention : agent.circumstance().intentions) {
    if (intention->is_finished()) continue;
    doing = fmt::format(", last in {}", agent.plan_name(*intention->top().plan));
  }
  return fmt::format("agent {} reasoned for {} cycles without waiting{}; it seems to loop for ever",
                     agent.name(), cycles, doing);
}

// All agents reason, in rounds, until none has anything to do.
void Mas::Implementation::reason_until_quiet() {
  ++period_;
  std::uint32_t rounds = 0;
  do {
    if (++rounds > options_.max_rounds) {
      end({.how = RunEnd::looping,
           .message = fmt::format("agents exchanged messages for {} rounds in one tick",
                                  options_.max_rounds),
           .limit = RunLimit::rounds});
      return;
    }
    (void)round(Turn::until_idle);
    if (interrupted()) end({.how = RunEnd::interrupted});
    if (ended_) return;
  } while (deliver_messages());
}

void Mas::Implementation::tick() {
  if (environment_->finished()) {
    end({.how = RunEnd::finished});
    return;
  }
  take_results();
  look();
  const double start = options_.measure_cpu ? thread_cpu_s() : 0;
  update_percepts();
  reason_until_quiet();
  if (options_.measure_cpu) cpu_s_ += thread_cpu_s() - start;
  if (ended_) return;
  table_.bury();
  execute_actions();
  environment_->advance();
  now_ms_ += environment_->tick_ms();
  if (options_.realtime) sleep_ms(now_ms_ - wall_ms());
  fire_timers();
  ++outcome_.ticks;
  if (environment_->finished()) {
    end({.how = RunEnd::finished});
  } else if (options_.max_ticks != 0 && outcome_.ticks >= options_.max_ticks) {
    end({.how = RunEnd::limit,
         .message = fmt::format("reached the limit of {} ticks", options_.max_ticks),
         .limit = RunLimit::ticks});
  }
}

void Mas::Implementation::take_results() {
  environment_->take_results([&](std::uint64_t number, ActionResult result) {
    const auto pending = pending_actions_.find(number);
    if (pending == pending_actions_.end()) return;
    AgentRecord& record = table_[pending->second];
    pending_actions_.erase(pending);
    if (record.agent == nullptr || record.is_leaving) return;
    if (record.agent->give_feedback(number, result.succeeded, std::move(result.reason))) {
      wake(record);
    }
  });
}

void Mas::Implementation::look() {
  if (outcome_.ticks == 0) stock_->constants.learn(*environment_, symbols_);
  for (AgentRecord& record : table_.all()) {
    if (!record.has_body() || record.is_leaving) continue;
    record.looks =
        record.percepts->looks() == 0 || !environment_->is_unchanged(AgentId{record.number});
    if (!record.looks) continue;
    record.percepts->begin_look();
    environment_->perceive(AgentId{record.number}, *record.percepts);
    record.percepts->end_look();
  }
}

// At an agent's first look; then it knows that.
KnownToAll Mas::Implementation::known_to_all(const AgentRecord& record) {
  if (record.percepts->looks() != 1) return {};
  return stock_->constants.known_to_agents_of(record.program, symbols_);
}

void Mas::Implementation::update_percepts() {
  for (AgentRecord& record : table_.all()) {
    if (!record.has_body() || record.is_leaving || !record.looks) continue;
    Agent& agent = *record.agent;
    ActionError error;
    const bool perceived = guarded(error, [&] {
      agent.update_percepts(*record.percepts, known_to_all(record));
      return true;
    });
    if (!perceived) {
      agent.log("in its percepts: " + error.message);
      limit_reached(agent, error.limit, "its percepts");
    }
    record.agent->rest();
    if (record.agent->is_active()) wake(record);
  }
}

void Mas::Implementation::execute_actions() {
  requests_.clear();
  actors_.clear();
  for (AgentRecord& record : table_.all()) {
    if (!record.has_body() || record.is_leaving) continue;
    const PendingAction* const action = record.agent->take_action(last_action_ + 1);
    if (action == nullptr) continue;
    ++last_action_;
    const Value literal = action->literal;
    const bool atom = literal.is_atom();
    requests_.push_back(
        {AgentId{record.number}, atom ? literal.atom_id() : literal.structure()->predicate(),
         atom ? std::span<const Value>{} : literal.structure()->arg_span(), last_action_});
    actors_.push_back(record.agent.get());
  }
  results_.assign(requests_.size(), ActionResult{});
  environment_->execute(requests_, results_);
  for (std::size_t i = 0; i < actors_.size(); ++i) {
    const std::uint64_t number = requests_[i].number;
    if (results_[i].is_pending) {
      pending_actions_.emplace(number, actors_[i]->number());
      continue;
    }
    actors_[i]->give_feedback(number, results_[i].succeeded, std::move(results_[i].reason));
    wake(table_.of(*actors_[i]));
  }
}

void Mas::Implementation::fire_timers() {
  while (!timers_.empty() && timers_.next_ms() <= now_ms_ && !ended_) {
    const Timer timer = timers_.take();
    if (timer.purpose == Timer::Purpose::stop) {
      end({.how = RunEnd::stopped, .exit_code = outcome_.exit_code});
      return;
    }
    AgentRecord& record = table_[timer.agent];
    if (record.is_leaving) continue;
    if (timer.purpose == Timer::Purpose::departure) {
      leave(record);
      continue;
    }
    record.agent->timer_fired(timer.token);
    record.agent->rest();
    if (record.agent->is_active()) wake(record);
  }
}

// Without an environment: one cycle of every active agent; time passes when all are idle. Agents of
// where none can observe when another reasons do several steps at once, each all of its cycles in a
// row.
void Mas::Implementation::free_step(std::uint64_t most) {
  if (options_.realtime) {
    now_ms_ = std::max(now_ms_, wall_ms());
    fire_timers();
  }
  const std::uint64_t steps = can_run_batch(most)
                                  ? run_batch(std::min(most, kStepsPerMs - busy_steps_))
                                  : (round(Turn::one_cycle) ? 1 : 0);
  steps_ += steps;
  if (ended_) return;
  if (!deliver_messages() && steps == 0) {
    pass_idle_time();
  } else if (!options_.realtime) {
    busy_steps_ += std::max<std::uint64_t>(steps, 1);
    if (busy_steps_ >= kStepsPerMs) pass_busy_ms();
  }
}

// Timers without a waiting agent are dropped.
void Mas::Implementation::drop_stale_timers() {
  while (!timers_.empty()) {
    const Timer& next = timers_.next();
    if (next.purpose == Timer::Purpose::stop) return;
    const AgentRecord& record = table_[next.agent];
    const bool is_wanted = !record.is_leaving && (next.purpose == Timer::Purpose::departure ||
                                                  record.agent->expects_timer(next.token));
    if (is_wanted) return;
    (void)timers_.take();
  }
}

std::optional<double> Mas::Implementation::next_timer_ms() {
  drop_stale_timers();
  return timers_.empty() ? std::nullopt : std::optional(timers_.next_ms());
}

void Mas::Implementation::pass_idle_time() {
  drop_stale_timers();
  if (timers_.empty()) {
    end({.how = RunEnd::idle});
    return;
  }
  ++period_;
  if (options_.realtime) {
    sleep_ms(std::min(timers_.next_ms() - now_ms_, kLongestSleepMs));
    return;
  }
  busy_steps_ = 0;
  now_ms_ = std::max(now_ms_, timers_.next_ms());
  fire_timers();
}

}  // namespace jaywalk

#include "interpreter/mas/system.h"

#include <algorithm>
#include <ctime>
#include <thread>

#include <fmt/format.h>

#include "interpreter/agent/step_guard.h"
#include "interpreter/term/transfer.h"

namespace jaywalk {
namespace {

/// How long the virtual clock lets busy agents reason while it moves on by a millisecond, so that
/// an agent that never rests does not keep the others from waking up. Few programs get there before
/// they wait.
constexpr std::uint64_t kStepsPerMs = 1000;

/// How long a step may sleep in real time; between steps the run can be interrupted.
constexpr double kLongestSleepMs = 20;

double thread_cpu_s() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

void sleep_ms(double ms) {
  if (ms > 0) std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(ms));
}

}  // namespace

Mas::Implementation::Implementation(std::unique_ptr<SystemStock> stock, MasOptions options,
                                    Environment* environment)
    : stock_(std::move(stock)),
      symbols_(stock_->symbols),
      options_(std::move(options)),
      environment_(environment),
      services_(
          [this](const std::string& subscriber, const std::string& provider,
                 const std::string& service) { tell_of_provider(subscriber, provider, service); }) {
  if (options_.threads < 2 || options_.observer != nullptr) return;
  symbols_.allow_threads();
  lanes_ = std::make_unique<Lanes>(options_.threads);
  for (std::size_t lane = 0; lane < options_.threads; ++lane) {
    workspaces_of_lanes_.push_back(std::make_unique<WorkspacePool>(symbols_));
  }
}

std::unique_ptr<SystemStock> Mas::Implementation::dismantle(
    std::unique_ptr<Implementation> system) {
  constexpr std::size_t kMostRemains = 64;
  system->stock_->workspaces.want_remains(kMostRemains);
  system->residents_ = {};
  system->mail_.reset();
  std::unique_ptr<SystemStock> stock = std::move(system->stock_);
  system.reset();
  stock->symbols.clear_layer();
  return stock;
}

// Agents come and go.

Resident& Mas::Implementation::settle(const std::string& name,
                                      std::shared_ptr<const Program> program) {
  const std::uint64_t seed = mix_seed(options_.seed ^ mix_seed(residents_.size()));
  look_whether_solitary(*program);
  auto agent =
      std::make_unique<Agent>(residents_.free_name(name), program, symbols_, *this, seed,
                              AgentLimits{options_.max_heap_bytes, options_.max_inferences});
  if (lanes_ != nullptr) reaches_.add(*program, symbols_);
  Resident& resident = residents_.add(std::move(agent), std::move(program));
  resident.name = symbols_.predicate(resident.agent->name(), 0);
  residents_.wake(resident);
  has_business_ = true;
  return resident;
}

void Mas::Implementation::start(Agent& agent, const AgentSpec& spec) {
  std::vector<Predicate> replaced;
  std::vector<Value> given;
  agent.customise(spec.customisation);
  ActionError error;
  const bool started = guarded(error, [&] {
    for (const Parameter& parameter : spec.parameters) {
      replaced.push_back(parameter.predicate);
      given.push_back(agent.heap().structure(parameter.predicate, parameter.args, source_self()));
    }
    agent.start(replaced, given);
    return true;
  });
  if (!started) agent.log("in its initial beliefs and goals: " + error.message);
  agent.rest();
  if (!agent.is_active()) put_to_sleep(residents_.of(agent));
}

AgentId Mas::Implementation::add_agent(const AgentSpec& spec) {
  Resident& resident = settle(spec.name, spec.program);
  if (spec.customisation != nullptr) all_keep_to_themselves_ = false;
  if (environment_ != nullptr) resident.percepts = std::make_unique<Percepts>();
  go_on_after_idleness();
  resident.agent->set_settings(spec.settings);
  start(*resident.agent, spec);
  return AgentId{resident.number};
}

bool Mas::Implementation::is_full() const { return residents_.living() >= options_.max_agents; }

std::shared_ptr<const Program> Mas::Implementation::load(const ProgramRequest& request,
                                                         std::string& error) {
  if (!options_.load_program) {
    error = "programs cannot be loaded in this run";
    return nullptr;
  }
  auto program = options_.load_program(request, symbols_, error);
  if (program != nullptr) loaded_.insert(program);
  if (program != nullptr && lanes_ != nullptr) reaches_.add(*program, symbols_);
  return program;
}

bool Mas::Implementation::save(const std::string& file, const std::string& text,
                               std::string& error) {
  if (options_.save_program) return options_.save_program(file, text, error);
  error = "files cannot be written in this run";
  return false;
}

Society::Creation Mas::Implementation::create(const std::string& name, const std::string& file) {
  if (is_full()) return {{}, fmt::format("there are {} agents, the limit", options_.max_agents)};
  AgentSpec spec;
  std::string error;
  spec.program = load({.file = file, .included = false, .ns = {}}, error);
  if (spec.program == nullptr) return {{}, error};
  Agent& agent = *settle(name, spec.program).agent;
  start(agent, spec);
  return {agent.name(), {}};
}

Society::Creation Mas::Implementation::clone(Agent& original, const std::string& name) {
  if (is_full()) return {{}, fmt::format("there are {} agents, the limit", options_.max_agents)};
  Agent& agent = *settle(name, residents_.of(original).program).agent;
  agent.copy_from(original);
  agent.rest();
  return {agent.name(), {}};
}

bool Mas::Implementation::kill(std::string_view name, double deadline_ms) {
  Resident* const resident = residents_.find(name);
  if (resident == nullptr) return false;
  if (deadline_ms > 0) {
    const Value ms = Value::number(deadline_ms);
    announce(*resident->agent, predicates::jag_shutting_down, std::span(&ms, 1));
    timers_.add({.at_ms = now_ms_ + deadline_ms,
                 .purpose = Timer::Purpose::departure,
                 .agent = resident->number});
  } else {
    leave(*resident);
  }
  return true;
}

void Mas::Implementation::leave(Resident& resident) {
  has_business_ = true;
  services_.forget(resident.agent->name());
  residents_.remove(resident);
}

void Mas::Implementation::stop(double deadline_ms, int exit_code) {
  has_business_ = true;
  if (beside_ != nullptr) {
    if (!beside_->outbox.end) beside_->outbox.end = {RunEnd::stopped, {}, exit_code};
    return;
  }
  outcome_.exit_code = exit_code;
  if (deadline_ms <= 0) {
    end(RunEnd::stopped);
    return;
  }
  const Value ms = Value::number(deadline_ms);
  for (Resident& resident : residents_.all()) {
    if (resident.is_leaving) continue;
    announce(*resident.agent, predicates::jag_shutting_down, std::span(&ms, 1));
  }
  timers_.add({.at_ms = now_ms_ + deadline_ms, .purpose = Timer::Purpose::stop});
}

void Mas::Implementation::end(RunEnd how, std::string message) {
  has_business_ = true;
  if (has_ended()) return;
  if (beside_ != nullptr) {
    beside_->outbox.end = {how, std::move(message), outcome_.exit_code};
    return;
  }
  ended_ = true;
  outcome_.end = how;
  outcome_.message = std::move(message);
}

// From outside, agents get something to do after all were idle.
void Mas::Implementation::go_on_after_idleness() {
  if (ended_ && outcome_.end == RunEnd::idle) ended_ = false;
}

bool Mas::Implementation::intervene(AgentId id, const std::function<void(Agent& agent)>& work,
                                    std::string& problem) {
  Resident& resident = residents_[static_cast<std::uint32_t>(id)];
  Agent& agent = *resident.agent;
  all_keep_to_themselves_ = false;  // it may get other plans
  const bool completed = agent.intervene([&] { work(agent); }, problem);
  go_on_after_idleness();
  if (agent.is_active()) wake(resident);
  return completed;
}

// What agents ask for.

void Mas::Implementation::set_timer(Agent& agent, double at_ms, std::uint64_t token) {
  const Timer timer{.at_ms = at_ms, .agent = residents_.of(agent).number, .token = token};
  if (beside_ != nullptr) {
    beside_->outbox.add(timer);
  } else {
    timers_.add(timer);
  }
}

bool Mas::Implementation::act(Agent& agent) { return residents_.of(agent).has_body(); }

void Mas::Implementation::print(Agent& agent, std::string_view text) {
  if (options_.print) put_out(Outbox::Kind::print, fmt::format("[{}] {}", agent.name(), text));
}

void Mas::Implementation::write(std::string_view text) {
  if (options_.write) put_out(Outbox::Kind::write, std::string(text));
}

void Mas::Implementation::log(Agent& agent, std::string_view text) {
  if (!options_.log) return;
  std::string line = fmt::format("[{}] {}", agent.name(), text);
  if (&agent == ahead_) {
    held_log_.push_back({agent.cycles() - ahead_since_, std::move(line)});
  } else {
    put_out(Outbox::Kind::log, line);
  }
}

void Mas::Implementation::put_out(Outbox::Kind kind, const std::string& text) {
  if (beside_ != nullptr) {
    beside_->outbox.add_text(kind, text);
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
  for (const Resident& resident : residents_.all()) {
    if (!resident.is_leaving) names.push_back(resident.agent->name());
  }
  return names;
}

// Messages.

bool Mas::Implementation::send(Agent& sender, const OutgoingMessage& message) {
  has_business_ = true;
  Resident* const receiver =
      message.receiver == "self" ? &residents_.of(sender) : residents_.find(message.receiver);
  if (receiver == nullptr) return false;
  Message copy;
  const bool to_itself = receiver->agent.get() == &sender;
  copy.sender = to_itself ? "self" : sender.name();
  copy.sender_atom = to_itself ? predicates::self : residents_.of(sender).name;
  copy.performative = message.performative;
  copy.id = message.id;
  copy.in_reply_to = message.in_reply_to;
  // Variables and collections are numbered by the heap that they come into, and people see the
  // numbers. So they come into the receiver's when they are delivered, after its own of this round.
  const bool is_plain = message.content.is_closed() && !sender.heap().has_objects();
  if (beside_ != nullptr) {
    Outbox& outbox = beside_->outbox;
    copy.content = transfer(message.content, outbox.heap);
    outbox.add(Outbox::Letter{receiver->number, std::move(copy), is_plain});
  } else if (is_plain) {
    copy.content = transfer(message.content, receiver->agent->heap());
    post(*receiver, std::move(copy));
  } else {
    post_later(*receiver, std::move(copy), message.content);
  }
  return true;
}

void Mas::Implementation::tell_of_provider(const std::string& subscriber,
                                           const std::string& provider,
                                           const std::string& service) {
  Resident* const receiver = residents_.find(subscriber);
  if (receiver == nullptr) return;
  Heap& heap = receiver->agent->heap();
  const std::array<Value, 2> args{Value::atom(symbols_.predicate(provider, 0)), heap.text(service)};
  Message message;
  message.sender = "df";
  message.sender_atom = symbols_.predicate(message.sender, 0);
  message.performative = symbols_.symbol("tell");
  message.content = heap.structure(symbols_.predicate("provider", 2), args);
  post(*receiver, std::move(message));
}

void Mas::Implementation::post(Resident& receiver, Message message) {
  has_business_ = true;
  receiver.agent->circumstance().arriving.push_back(std::move(message));
  if (receiver.has_mail) return;
  receiver.has_mail = true;
  receivers_.push_back(receiver.number);
}

void Mas::Implementation::post_later(Resident& receiver, Message message, Value content) {
  if (!mail_) mail_.emplace();
  contents_.push_back(
      {receiver.number, receiver.agent->circumstance().arriving.size(), transfer(content, *mail_)});
  message.content = Value();
  post(receiver, std::move(message));
}

// A content that is too large for its receiver is lost: `false` arrives.
Value Mas::Implementation::hand_over(Value content, Agent& receiver) {
  Value copy = Value::atom(predicates::falsity);
  ActionError error;
  const bool arrived = guarded(error, [&] {
    copy = transfer(content, receiver.heap());
    return true;
  });
  if (!arrived) receiver.log("a message was too large: " + error.message);
  return copy;
}

bool Mas::Implementation::deliver_messages() {
  if (receivers_.empty()) return false;
  for (const Content& each : contents_) {
    Resident& receiver = residents_[each.receiver];
    if (receiver.is_leaving) continue;
    receiver.agent->circumstance().arriving[each.message].content =
        hand_over(each.content, *receiver.agent);
  }
  contents_.clear();
  mail_.reset();
  for (const std::uint32_t number : receivers_) {
    Resident& receiver = residents_[number];
    receiver.has_mail = false;
    if (receiver.is_leaving) continue;
    auto& arriving = receiver.agent->circumstance().arriving;
    for (Message& message : arriving) receiver.agent->receive(std::move(message));
    arriving.clear();
    wake(receiver);
  }
  receivers_.clear();
  return true;
}

// Events about the agent itself. Most agents have no plans for them.

void Mas::Implementation::announce(Agent& agent, Predicate predicate, std::span<const Value> args) {
  const Value literal =
      args.empty() ? Value::atom(predicate) : agent.heap().structure(predicate, args);
  agent.add_event({TriggerOperator::add, TriggerKind::belief, literal, nullptr, 0});
  if (agent.is_active()) residents_.wake(residents_.of(agent));
}

void Mas::Implementation::put_to_sleep(Resident& resident) {
  if (resident.is_asleep) return;
  resident.is_asleep = true;
  announce(*resident.agent, predicates::jag_sleeping, {});
}

void Mas::Implementation::wake(Resident& resident) {
  residents_.wake(resident);
  if (!resident.is_asleep) return;
  resident.is_asleep = false;
  announce(*resident.agent, predicates::jag_awaking, {});
}

// The run.

bool Mas::Implementation::step() {
  if (ended_) return false;
  environment_ != nullptr ? tick() : free_step(1);
  if (residents_.has_leaving()) residents_.bury();
  return !ended_;
}

bool Mas::Implementation::stride() {
  if (ended_) return false;
  Resident* const lone =
      environment_ == nullptr && !options_.realtime ? residents_.lone_active() : nullptr;
  if (lone != nullptr && !lone->is_leaving && lone->agent->is_active()) {
    reason_alone(*lone);
  } else {
    constexpr std::uint64_t kMostAtOnce = 32;
    environment_ != nullptr ? tick() : free_step(kMostAtOnce);
  }
  if (residents_.has_leaving()) residents_.bury();
  return !ended_;
}

// Free steps, as long as no other agent takes part and no time passes.
void Mas::Implementation::reason_alone(Resident& resident) {
  constexpr std::uint64_t kLongestStride = 64;  // cycles; then the caller may look at the clock
  const std::uint64_t end = outcome_.cycles + kLongestStride;
  do {
    const std::uint64_t start = outcome_.cycles;
    reason(resident, std::min(end - start, kStepsPerMs - busy_steps_));
    if (ended_) return;
    deliver_messages();
    busy_steps_ += outcome_.cycles - start;
    steps_ += outcome_.cycles - start;
    if (busy_steps_ >= kStepsPerMs) {
      pass_busy_ms();
      return;
    }
  } while (outcome_.cycles < end && !residents_.has_woken() && !resident.is_leaving &&
           resident.agent->is_active());
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
void Mas::Implementation::reason(Resident& resident, std::uint64_t most) {
  Agent& agent = *resident.agent;
  if (resident.period != period_) {
    resident.period = period_;
    resident.cycles_before = agent.cycles();
  }
  most =
      std::min(most - 1, options_.max_cycles_per_tick - (agent.cycles() - resident.cycles_before)) +
      1;
  if (options_.max_cycles > agent.cycles()) {
    most = std::min(most, options_.max_cycles - agent.cycles());
  }
  has_business_ = false;
  const std::uint64_t taken = agent.reason(most);
  (beside_ != nullptr ? beside_->outbox.cycles : outcome_.cycles) += taken;
  if (agent.cycles() - resident.cycles_before > options_.max_cycles_per_tick) {
    end(RunEnd::looping, busy_message(agent, options_.max_cycles_per_tick));
  } else if (options_.max_cycles != 0 && agent.cycles() >= options_.max_cycles) {
    end(RunEnd::limit, fmt::format("agent {} has reasoned for {} cycles, the limit", agent.name(),
                                   options_.max_cycles));
  }
  if (!resident.is_leaving && !agent.is_active()) put_to_sleep(resident);
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
      end(RunEnd::looping,
          fmt::format("agents exchanged messages for {} rounds in one tick", options_.max_rounds));
      return;
    }
    (void)round(Turn::until_idle);
    if (ended_) return;
  } while (deliver_messages());
}

void Mas::Implementation::tick() {
  if (environment_->finished()) {
    end(RunEnd::finished);
    return;
  }
  look();
  const double start = options_.measure_cpu ? thread_cpu_s() : 0;
  update_percepts();
  reason_until_quiet();
  if (options_.measure_cpu) cpu_s_ += thread_cpu_s() - start;
  if (ended_) return;
  residents_.bury();
  execute_actions();
  environment_->advance();
  now_ms_ += environment_->tick_ms();
  if (options_.realtime) sleep_ms(now_ms_ - wall_ms());
  fire_timers();
  ++outcome_.ticks;
  if (environment_->finished()) {
    end(RunEnd::finished);
  } else if (options_.max_ticks != 0 && outcome_.ticks >= options_.max_ticks) {
    end(RunEnd::limit, fmt::format("{} ticks, the limit", options_.max_ticks));
  }
}

void Mas::Implementation::look() {
  for (Resident& resident : residents_.all()) {
    if (!resident.has_body() || resident.is_leaving) continue;
    resident.percepts->begin_look();
    environment_->perceive(AgentId{resident.number}, *resident.percepts);
    resident.percepts->end_look();
  }
}

void Mas::Implementation::update_percepts() {
  for (Resident& resident : residents_.all()) {
    if (!resident.has_body() || resident.is_leaving) continue;
    resident.agent->update_percepts(*resident.percepts);
    resident.agent->rest();
    if (resident.agent->is_active()) wake(resident);
  }
}

void Mas::Implementation::execute_actions() {
  requests_.clear();
  actors_.clear();
  for (Resident& resident : residents_.all()) {
    if (!resident.has_body() || resident.is_leaving) continue;
    const PendingAction* const action = resident.agent->take_action();
    if (action == nullptr) continue;
    const Value literal = action->literal;
    const bool atom = literal.is_atom();
    requests_.push_back({AgentId{resident.number},
                         atom ? literal.atom_id() : literal.structure()->predicate(),
                         atom ? std::span<const Value>{} : literal.structure()->arg_span()});
    actors_.push_back(resident.agent.get());
  }
  results_.assign(requests_.size(), ActionResult{});
  environment_->execute(requests_, results_);
  for (std::size_t i = 0; i < actors_.size(); ++i) {
    actors_[i]->give_feedback(results_[i].succeeded, std::move(results_[i].reason));
    wake(residents_.of(*actors_[i]));
  }
}

void Mas::Implementation::fire_timers() {
  while (!timers_.empty() && timers_.next_ms() <= now_ms_ && !ended_) {
    const Timer timer = timers_.take();
    if (timer.purpose == Timer::Purpose::stop) {
      end(RunEnd::stopped);
      return;
    }
    Resident& resident = residents_[timer.agent];
    if (resident.is_leaving) continue;
    if (timer.purpose == Timer::Purpose::departure) {
      leave(resident);
      continue;
    }
    resident.agent->timer_fired(timer.token);
    resident.agent->rest();
    if (resident.agent->is_active()) wake(resident);
  }
}

// Without an environment: one cycle of every active agent; time passes when all are idle. Agents of
// which none can tell when another reasons do several steps at once, each all of its cycles in a
// row.
void Mas::Implementation::free_step(std::uint64_t most) {
  if (options_.realtime) {
    now_ms_ = std::max(now_ms_, wall_ms());
    fire_timers();
  }
  const std::uint64_t steps = can_run_ahead(most)
                                  ? run_ahead(std::min(most, kStepsPerMs - busy_steps_))
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

// Timers that nobody waits for any more are not worth waiting for.
void Mas::Implementation::drop_stale_timers() {
  while (!timers_.empty()) {
    const Timer& next = timers_.next();
    if (next.purpose == Timer::Purpose::stop) return;
    const Resident& resident = residents_[next.agent];
    const bool is_wanted = !resident.is_leaving && (next.purpose == Timer::Purpose::departure ||
                                                    resident.agent->expects_timer(next.token));
    if (is_wanted) return;
    (void)timers_.take();
  }
}

void Mas::Implementation::pass_idle_time() {
  drop_stale_timers();
  if (timers_.empty()) {
    end(RunEnd::idle);
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

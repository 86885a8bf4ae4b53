#include "interpreter/mas/mas.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <queue>
#include <thread>
#include <tuple>
#include <unordered_map>

#include "interpreter/agent/agent.h"
#include "interpreter/mas/transfer.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

double thread_cpu_s() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

struct Timer {
  double at_ms = 0;
  std::uint64_t sequence = 0;
  std::uint32_t agent = 0;
  std::uint64_t token = 0;

  bool operator>(const Timer& other) const {
    return std::tie(at_ms, sequence) > std::tie(other.at_ms, other.sequence);
  }
};

struct Resident {
  std::unique_ptr<Agent> agent;
  std::uint64_t cycles_at_tick = 0;
};

}  // namespace

class Mas::Implementation : public AgentHost {
 public:
  Implementation(std::shared_ptr<const SymbolTable> symbols, MasOptions options,
                 Environment* environment)
      : symbols_(std::move(symbols)), options_(std::move(options)), environment_(environment) {}

  AgentId add_agent(const AgentSpec& spec) {
    std::string name = spec.name;
    for (int n = 1; by_name_.contains(name); ++n) name = fmt::format("{}_{}", spec.name, n);
    const auto number = static_cast<std::uint32_t>(residents_.size());
    Resident resident;
    resident.agent = std::make_unique<Agent>(
        name, spec.program, symbols_, *this, mix_seed(options_.seed ^ mix_seed(number)),
        AgentLimits{options_.max_heap_bytes, options_.max_inferences});
    by_name_.emplace(name, number);
    numbers_.emplace(resident.agent.get(), number);
    Agent& agent = *resident.agent;
    residents_.push_back(std::move(resident));
    std::vector<Predicate> replaced;
    std::vector<Value> given;
    for (const Parameter& parameter : spec.parameters) {
      replaced.push_back(parameter.predicate);
      given.push_back(agent.heap().structure(parameter.predicate, parameter.args, source_self()));
    }
    agent.start(replaced, given);
    return AgentId{number};
  }

  RunOutcome run() {
    while (step()) {
    }
    return outcome_;
  }

  bool step() {
    if (ended_) return false;
    environment_ != nullptr ? tick() : free_step();
    return !ended_;
  }

  [[nodiscard]] const RunOutcome& outcome() const { return outcome_; }
  [[nodiscard]] const std::vector<Resident>& residents() const { return residents_; }
  [[nodiscard]] double reasoning_cpu_s() const { return cpu_s_; }

  // What agents ask of the system.
  [[nodiscard]] double now_ms() const override { return now_ms_; }
  void set_timer(Agent& agent, double at_ms, std::uint64_t token) override {
    timers_.push({at_ms, ++timer_sequence_, numbers_.at(&agent), token});
  }
  bool send(Agent& sender, const OutgoingMessage& message) override {
    const bool to_self = message.receiver == "self";
    const auto found = by_name_.find(std::string(to_self ? sender.name() : message.receiver));
    if (found == by_name_.end()) return false;
    deliver(sender, residents_[found->second], message);
    return true;
  }
  void broadcast(Agent& sender, const OutgoingMessage& message) override {
    for (Resident& resident : residents_) {
      if (resident.agent.get() != &sender) deliver(sender, resident, message);
    }
  }
  [[nodiscard]] std::vector<std::string> agent_names() const override {
    std::vector<std::string> names;
    for (const Resident& resident : residents_) names.push_back(resident.agent->name());
    return names;
  }
  bool act(Agent&) override { return environment_ != nullptr; }
  void print(Agent& agent, std::string_view text) override {
    if (options_.print) options_.print(fmt::format("[{}] {}", agent.name(), text));
  }
  void log(Agent& agent, std::string_view text) override {
    if (options_.log) options_.log(fmt::format("[{}] {}", agent.name(), text));
  }
  void stop(int exit_code) override {
    end(RunEnd::stopped);
    outcome_.exit_code = exit_code;
  }

 private:
  void end(RunEnd how, std::string message = {}) {
    if (ended_) return;
    ended_ = true;
    outcome_.end = how;
    outcome_.message = std::move(message);
  }

  void deliver(Agent& sender, Resident& receiver, const OutgoingMessage& message) {
    Message copy;
    copy.sender = receiver.agent.get() == &sender ? "self" : sender.name();
    copy.performative = message.performative;
    copy.content = transfer(message.content, receiver.agent->heap());
    copy.id = message.id;
    copy.in_reply_to = message.in_reply_to;
    receiver.agent->circumstance().arriving.push_back(std::move(copy));
    messages_waiting_ = true;
  }

  bool deliver_messages() {
    if (!messages_waiting_) return false;
    messages_waiting_ = false;
    for (Resident& resident : residents_) {
      auto& arriving = resident.agent->circumstance().arriving;
      for (Message& message : arriving) resident.agent->receive(std::move(message));
      arriving.clear();
    }
    return true;
  }

  // One cycle of an agent; false once the run has ended.
  bool reason(Resident& resident) {
    Agent& agent = *resident.agent;
    agent.cycle();
    ++outcome_.cycles;
    if (agent.cycles() - resident.cycles_at_tick > options_.max_cycles_per_tick) {
      end(RunEnd::looping, busy_message(agent, options_.max_cycles_per_tick));
    } else if (options_.max_cycles != 0 && agent.cycles() >= options_.max_cycles) {
      end(RunEnd::limit, fmt::format("agent {} has reasoned for {} cycles, the limit",
                                     agent.name(), options_.max_cycles));
    }
    return !ended_;
  }

  std::string busy_message(const Agent& agent, std::uint64_t cycles) const {
    std::string doing;
    for (const auto& intention : agent.circumstance().intentions) {
      if (intention->is_finished()) continue;
      const IntendedMeans& means = intention->top();
      doing = fmt::format(", last in {}", agent.plan_name(*means.plan));
    }
    return fmt::format("agent {} reasoned for {} cycles without waiting{}; it seems to loop for ever",
                       agent.name(), cycles, doing);
  }

  // All agents reason, in rounds, until none has anything to do.
  void reason_until_quiet() {
    for (Resident& resident : residents_) resident.cycles_at_tick = resident.agent->cycles();
    std::uint32_t rounds = 0;
    do {
      if (++rounds > options_.max_rounds) {
        end(RunEnd::looping, fmt::format("agents exchanged messages for {} rounds in one tick",
                                         options_.max_rounds));
        return;
      }
      for (Resident& resident : residents_) {
        while (resident.agent->is_active()) {
          if (!reason(resident)) return;
        }
      }
    } while (deliver_messages());
  }

  void tick() {
    if (environment_->finished()) {
      end(RunEnd::finished);
      return;
    }
    const double start = options_.measure_cpu ? thread_cpu_s() : 0;
    perceive();
    reason_until_quiet();
    if (options_.measure_cpu) cpu_s_ += thread_cpu_s() - start - perceiving_s_;
    if (ended_) return;
    execute_actions();
    environment_->advance();
    now_ms_ += environment_->tick_ms();
    fire_timers();
    ++outcome_.ticks;
    if (environment_->finished()) {
      end(RunEnd::finished);
    } else if (options_.max_ticks != 0 && outcome_.ticks >= options_.max_ticks) {
      end(RunEnd::limit, fmt::format("{} ticks, the limit", options_.max_ticks));
    }
  }

  void perceive() {
    perceiving_s_ = 0;
    for (std::uint32_t i = 0; i < residents_.size(); ++i) {
      const double start = options_.measure_cpu ? thread_cpu_s() : 0;
      percepts_.clear();
      environment_->perceive(AgentId{i}, percepts_);
      if (options_.measure_cpu) perceiving_s_ += thread_cpu_s() - start;
      residents_[i].agent->update_percepts(percepts_);
    }
  }

  void execute_actions() {
    requests_.clear();
    actors_.clear();
    for (std::uint32_t i = 0; i < residents_.size(); ++i) {
      const PendingAction* const action = residents_[i].agent->take_action();
      if (action == nullptr) continue;
      const Value literal = action->literal;
      const bool atom = literal.is_atom();
      requests_.push_back({AgentId{i},
                           atom ? literal.atom_id() : literal.structure()->predicate(),
                           atom ? std::span<const Value>{} : literal.structure()->arg_span()});
      actors_.push_back(residents_[i].agent.get());
    }
    results_.assign(requests_.size(), ActionResult{});
    environment_->execute(requests_, results_);
    for (std::size_t i = 0; i < actors_.size(); ++i) {
      actors_[i]->give_feedback(results_[i].succeeded, std::move(results_[i].reason));
    }
  }

  void fire_timers() {
    while (!timers_.empty() && timers_.top().at_ms <= now_ms_) {
      const Timer timer = timers_.top();
      timers_.pop();
      residents_[timer.agent].agent->timer_fired(timer.token);
    }
  }

  // Without an environment: one cycle of every active agent; time passes when all are idle.
  void free_step() {
    bool any = false;
    for (std::size_t i = 0; i < residents_.size(); ++i) {
      if (!residents_[i].agent->is_active()) continue;
      any = true;
      if (!reason(residents_[i])) return;
    }
    if (deliver_messages() || any) return;
    if (timers_.empty()) {
      end(RunEnd::idle);
      return;
    }
    const double next = timers_.top().at_ms;
    if (options_.realtime && next > now_ms_) {
      std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(next - now_ms_));
    }
    now_ms_ = std::max(now_ms_, next);
    for (Resident& resident : residents_) resident.cycles_at_tick = resident.agent->cycles();
    fire_timers();
  }

  SymbolTable symbols_;
  MasOptions options_;
  Environment* environment_;
  std::vector<Resident> residents_;
  std::unordered_map<std::string, std::uint32_t> by_name_;
  std::unordered_map<const Agent*, std::uint32_t> numbers_;
  std::priority_queue<Timer, std::vector<Timer>, std::greater<>> timers_;
  std::uint64_t timer_sequence_ = 0;
  double now_ms_ = 0;
  bool messages_waiting_ = false;
  bool ended_ = false;
  RunOutcome outcome_;
  double cpu_s_ = 0;
  double perceiving_s_ = 0;
  Percepts percepts_;
  std::vector<ActionRequest> requests_;
  std::vector<ActionResult> results_;
  std::vector<Agent*> actors_;
};

Mas::Mas(std::shared_ptr<const SymbolTable> symbols, MasOptions options, Environment* environment)
    : implementation_(std::make_unique<Implementation>(std::move(symbols), std::move(options),
                                                       environment)) {}
Mas::~Mas() = default;

AgentId Mas::add_agent(const AgentSpec& spec) { return implementation_->add_agent(spec); }
RunOutcome Mas::run() { return implementation_->run(); }
bool Mas::step() { return implementation_->step(); }
const RunOutcome& Mas::outcome() const { return implementation_->outcome(); }
std::size_t Mas::agent_count() const { return implementation_->residents().size(); }
const Agent& Mas::agent(AgentId id) const {
  return *implementation_->residents()[static_cast<std::size_t>(id)].agent;
}
const std::string& Mas::agent_name(AgentId id) const { return agent(id).name(); }
double Mas::now_ms() const { return implementation_->now_ms(); }
double Mas::reasoning_cpu_s() const { return implementation_->reasoning_cpu_s(); }

std::vector<std::string> Mas::describe_intentions(AgentId id) const {
  const Agent& the_agent = agent(id);
  std::vector<std::string> texts;
  for (const auto& intention : the_agent.circumstance().intentions) {
    std::string text;
    for (const IntendedMeans& means : intention->stack) {
      if (!text.empty()) text += " > ";
      if (means.op == TriggerOperator::remove) text += '-';
      if (means.kind == TriggerKind::belief) text += '+';
      const Value plain = means.trigger;
      std::string goal = term_text(plain, the_agent.symbols());
      if (const auto annots = goal.rfind(")["); annots != goal.npos) goal.resize(annots + 1);
      else if (const auto bare = goal.find('['); bare != goal.npos && goal.find('(') == goal.npos) {
        goal.resize(bare);
      }
      text += goal;
    }
    if (!text.empty()) texts.push_back(std::move(text));
  }
  return texts;
}

std::vector<std::string> Mas::describe_beliefs(AgentId id) const {
  const Agent& the_agent = agent(id);
  std::vector<std::string> texts;
  for (const auto& relation : the_agent.beliefs().relations()) {
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Row& row = relation->row(seq);
      if (!row.fact.is_unset()) texts.push_back(term_text(row.fact, the_agent.symbols()));
    }
  }
  return texts;
}

}  // namespace jaywalk

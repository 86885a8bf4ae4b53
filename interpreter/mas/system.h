// SPDX-License-Identifier: Apache-2.0
#pragma once

// The multi-agent system behind Mas (mas.h, read it first): the order in which things happen, and
// what agents ask of the system.

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "interpreter/agent/surroundings/host.h"
#include "interpreter/agent/surroundings/services.h"
#include "interpreter/mas/agent_table.h"
#include "interpreter/mas/constants.h"
#include "interpreter/mas/mas.h"
#include "interpreter/mas/outbox.h"
#include "interpreter/mas/reach.h"
#include "interpreter/mas/workers.h"

namespace jaywalk {

/// The parts of a system that the next one can reuse: names above those of the programs, and
/// memory. They do not depend on what the previous system did.
struct SystemStock {
  explicit SystemStock(const std::shared_ptr<const SymbolTable>& base)
      : symbols(base), constants(base->predicate_count()) {}

  SymbolTable symbols;
  WorkspacePool workspaces{symbols};
  std::vector<std::unique_ptr<Percepts>> percepts;
  Constants constants;
};

class Mas::Implementation : public AgentHost, public Society {
 public:
  Implementation(std::unique_ptr<SystemStock> stock, MasOptions options, Environment* environment);
  /// Ends a system and keeps its parts for the next one.
  [[nodiscard]] static std::unique_ptr<SystemStock> dismantle(
      std::unique_ptr<Implementation> system);

  AgentId add_agent(const AgentSpec& spec);
  bool step();
  [[nodiscard]] bool intervene(AgentId id, const std::function<void(Agent& agent)>& work,
                               std::string& problem);
  [[nodiscard]] SymbolTable& symbols() { return symbols_; }
  bool stride();

  [[nodiscard]] const RunOutcome& outcome();
  [[nodiscard]] const AgentTable& records() const { return table_; }
  [[nodiscard]] double reasoning_cpu_s() const { return cpu_s_; }
  [[nodiscard]] std::optional<double> next_timer_ms();
  void embody_newcomers() { newcomers_have_bodies_ = environment_ != nullptr; }

  // AgentHost
  [[nodiscard]] double now_ms() const override { return now_ms_; }
  void set_timer(Agent& agent, double at_ms, std::uint64_t token) override;
  bool send(Agent& sender, const OutgoingMessage& message) override;
  bool act(Agent& agent) override;
  void print(Agent& agent, std::string_view text) override;
  void write(Agent& agent, std::string_view text) override;
  void log(Agent& agent, std::string_view text) override;
  [[nodiscard]] bool keeps_log() const override { return static_cast<bool>(options_.log); }
  [[nodiscard]] Society& society() override { return *this; }
  [[nodiscard]] AgentTurn& common_turn() override { return turn_; }
  void limit_reached(Agent& agent, ReachedLimit limit, std::string where) override;
  [[nodiscard]] bool interrupted() override {
    return options_.interrupted && options_.interrupted();
  }
  [[nodiscard]] OptionPolicies* policies() override { return options_.policies; }
  [[nodiscard]] ReasoningObserver* observer() override { return options_.observer; }

  // Society
  [[nodiscard]] std::vector<std::string> names() const override;
  [[nodiscard]] std::shared_ptr<const Program> load(const ProgramRequest& request,
                                                    LoadProblem& problem) override;
  [[nodiscard]] bool save(const std::string& file, const std::string& text,
                          std::string& error) override;
  [[nodiscard]] std::string why_not_list(const std::string& folder) override;
  [[nodiscard]] Creation create(const std::string& name, const std::string& file) override;
  [[nodiscard]] Creation clone(Agent& original, const std::string& name) override;
  bool kill(std::string_view name, double deadline_ms) override;
  void stop(Agent& agent, double deadline_ms, int exit_code) override;
  [[nodiscard]] ServiceDirectory& services() override { return services_; }

 private:
  [[nodiscard]] std::unique_ptr<Percepts> percepts_for_body();
  AgentRecord& settle(const std::string& name, std::shared_ptr<const Program> program);
  [[nodiscard]] std::string problem_with_more_agents() const;
  void start(Agent& agent, const AgentSpec& spec);
  struct ParallelBlock;
  /// Ends the run, now or, for an agent that reasons beside others, as far as it is concerned.
  void end(Outbox::End how, ParallelBlock* block = nullptr);
  void go_on_after_idleness();
  void leave(AgentRecord& record);

  // One step of the run.
  [[nodiscard]] bool is_to_go_on();
  void tick();
  void free_step(std::uint64_t most);

  // Several steps at once (batches.cpp).
  void check_isolation(const Program& program);
  [[nodiscard]] bool can_run_batch(std::uint64_t most) const;
  /// The agent that reasons for several steps in a row, and the lines that it has logged meanwhile.
  struct Batch {
    struct Line {
      std::uint64_t step;
      std::string text;
    };
    const Agent* agent = nullptr;  // null: none
    std::uint64_t since = 0;       // its cycles before
    std::vector<Line> lines;
    std::uint64_t longest = 0;  // cycles that an agent has taken
  };
  std::uint64_t run_batch(std::uint64_t most);
  void reason_in_batch(AgentRecord& record, std::uint64_t most, Batch& batch);
  void write_held_log();

  void reason_alone(AgentRecord& first);
  void pass_busy_ms();
  void look();
  [[nodiscard]] KnownToAll known_to_all(const AgentRecord& record);
  void take_results();
  void update_percepts();
  void reason_until_quiet();
  void execute_actions();
  void reason(AgentRecord& record, std::uint64_t most);
  void note_who_stopped(Agent& agent);
  [[nodiscard]] std::uint64_t inferences() const;
  void count_inferences(std::string agent);
  [[nodiscard]] bool has_ended(const ParallelBlock* block) const {
    return block != nullptr ? block->outbox.end.has_value() : ended_;
  }
  void fire_timers();
  void pass_idle_time();
  void drop_stale_timers();

  // Rounds, perhaps on several threads (parallel.cpp).
  enum class Turn : std::uint8_t { one_cycle, until_idle };
  /// Every active agent takes a turn. False: there was none.
  bool round(Turn turn);
  bool take_turn(AgentRecord& record, Turn turn);
  std::uint64_t take_turns_in_parallel(std::span<const std::uint32_t> numbers, Turn turn);
  void run_batch_in_parallel(std::span<const std::uint32_t> numbers, std::uint64_t most);
  [[nodiscard]] bool can_reason_in_parallel(AgentRecord& record);
  void empty(Outbox& outbox);
  /// The turn of a block of agents on one of several threads, and the block's requests.
  struct ParallelBlock : AgentTurn {
    using AgentTurn::AgentTurn;
    Outbox outbox;
    Batch batch;
    /// The agents of its block that have not had their turns.
    std::span<const std::uint32_t> left;
  };
  /// The block in which the agent reasons in parallel. Null: it reasons alone, and its requests are
  /// carried out at once.
  [[nodiscard]] ParallelBlock* block_of(Agent& agent) {
    return &agent.turn() == &turn_ ? nullptr : static_cast<ParallelBlock*>(&agent.turn());
  }
  template <class TakeTurn>
  void take_turn_in_block(AgentRecord& record, ParallelBlock& block, TakeTurn take_turn);
  /// Calls `take_turn(record, block)` for each of these on all threads; then, in order, carries
  /// out their requests and calls `is_done(block)` for each block.
  template <class TakeTurn, class IsDone>
  void reason_in_parallel(std::span<const std::uint32_t> numbers, TakeTurn take_turn,
                          IsDone is_done);

  void put_out(Outbox::Kind kind, const std::string& text, ParallelBlock* block = nullptr);
  void wake(AgentRecord& record);
  void put_to_sleep(AgentRecord& record);
  void announce(Agent& agent, Predicate predicate, std::span<const Value> args);
  [[nodiscard]] const AgentRecord& named(AgentRecord& record);
  [[nodiscard]] AgentRecord* receiver_of(const OutgoingMessage& message, Agent& sender);
  void post(AgentRecord& receiver, const Message& message);
  void post_content(AgentRecord& receiver, Message message, Value content);
  [[nodiscard]] static Value hand_over(Value content, Agent& receiver);
  bool deliver_messages();
  void require_room_for_message(AgentRecord& sender, const AgentRecord& receiver);

  // Memory (memory.cpp).
  void share_memory();
  void sweep();
  void allow_memory(AgentRecord& record) const;
  /// Adds by how much more the agent owns to `sum`.
  static void note_memory(AgentRecord& record, std::int64_t& sum);
  void release_memory(AgentRecord& record);
  void look_for_room(AgentRecord& receiver);
  void look_at_full();
  void count_names();
  void tell_of_provider(const std::string& subscriber, const std::string& provider,
                        const std::string& service);
  [[nodiscard]] static std::string last_place(const Agent& agent);
  [[nodiscard]] static std::string busy_message(const Agent& agent, std::uint64_t cycles);
  [[nodiscard]] double wall_ms() const;

  std::unique_ptr<SystemStock> stock_;  // outlives the agents, as do the next
  AgentTurn turn_{stock_->workspaces};
  SymbolTable& symbols_;  // of this run, above the programs' own
  /// Loaded during the run. Terms that agents send refer to their constants.
  std::unordered_set<std::shared_ptr<const Program>> loaded_;
  MasOptions options_;
  Environment* environment_;
  std::vector<std::unique_ptr<WorkspacePool>> workspaces_of_workers_;
  Reaches reaches_;
  AgentTable table_;
  Timers timers_;
  ServiceDirectory services_;
  std::chrono::steady_clock::time_point wall_start_ = std::chrono::steady_clock::now();
  double now_ms_ = 0;
  std::uint64_t period_ = 1;      // counts the ticks, or the times when all agents were idle
  std::uint64_t busy_steps_ = 0;  // since time passed
  std::uint64_t steps_ = 0;       // ever; no agent has reasoned for more cycles
  std::vector<std::uint32_t> receivers_;  // of messages not yet delivered
  std::vector<std::uint32_t> full_;       // agents without memory for messages
  std::uint64_t deliveries_ = 1;
  // The memory of all agents, and the remainder of their limit, in all and for an agent that owns
  // little, when a round last ended.
  std::int64_t owned_bytes_ = 0;
  std::size_t left_bytes_ = 0;
  std::size_t least_bytes_ = 0;
  // The bytes of the names that this run has made, and how many names were counted.
  std::size_t name_bytes_ = 0;
  std::size_t counted_symbols_ = 0;
  std::size_t counted_predicates_ = 0;
  std::uint32_t full_rounds_ = 0;  // at whose end nothing was left, since agents were last swept
  std::uint32_t rounds_to_sweep_ = 1;
  /// Contents that get to their receivers' heaps only when they are delivered; they are in `mail_`.
  struct Content {
    std::uint32_t receiver = 0;
    std::size_t message = 0;  // among those that arrive
    Value content;
  };
  std::vector<Content> contents_;
  std::optional<Heap> mail_;
  std::unique_ptr<Workers> workers_;  // null: one thread
  bool newcomers_have_bodies_ = false;
  bool ended_ = false;
  RunOutcome outcome_;
  std::uint64_t inferences_before_ = 0;  // of the kept parts, before this run
  std::string last_query_;               // that hit a limit: where it was asked
  double cpu_s_ = 0;
  // Agents of which none can observe when another reasons (program/isolation.h).
  bool all_keep_to_themselves_ = true;
  const Program* isolated_program_ = nullptr;  // the last program that was looked at
  Batch batch_;
  std::vector<ActionRequest> requests_;
  std::vector<ActionResult> results_;
  std::uint64_t last_action_ = 0;
  /// The agents of actions whose results come later, by the actions' numbers.
  std::unordered_map<std::uint64_t, std::uint32_t> pending_actions_;
  std::vector<Agent*> actors_;
};

/// Half of the memory that the machine has, or that its group of processes (a container) may have.
[[nodiscard]] std::uint64_t half_of_the_machines_memory();

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options of a run of agents, and how it ended. A run goes on in ticks; within a tick
// everything happens in a fixed order, so that a run is a function of the programs, the environment
// and the seed:
//
//   1. results of actions that took longer than a tick reach their agents, and every agent
//   perceives
//      the world as the last tick left it;
//   2. rounds: every active agent reasons until it is idle or has chosen an action; then messages
//      are delivered, in the order (sender, sequence); again, until no agent has anything to do;
//   3. the actions chosen, at most one for each agent, take effect at once; their results reach the
//      agents in the next tick's reasoning, before anything else;
//   4. the environment advances, the clock moves on by one tick.
//
// Without an environment a step is one reasoning cycle of every active agent, and when all are idle
// the clock jumps to the next timer. (Where some agents never rest, a millisecond passes for every
// thousand steps.)
//
// Agents may create others, and end them, while the system runs. Those have no body in the
// environment: they perceive nothing, and their actions fail.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace jaywalk {

class OptionPolicies;
class Program;
class ReasoningObserver;
class SymbolTable;

/// A program to be loaded while agents run.
struct ProgramRequest {
  std::string file;
  /// The program is included into a running agent (`.include`), with its literals in the
  /// namespace `ns`; empty: the default one.
  bool included = false;
  std::string ns;
};

/// Why a program was not loaded, or which parts of it were left out.
struct LoadProblem {
  std::string text;  // empty: there is none
  /// The agents may not read the file, so that `.include` fails; one that is missing or wrong it
  /// leaves out.
  bool is_refused = false;
};

struct MasOptions {
  /// Every agent's random stream derives from it and from the agent's number.
  std::uint64_t seed = 0;
  /// Reasoning cycles of one agent in one tick, or without time passing, before the run is stopped.
  std::uint64_t max_cycles_per_tick = 100'000'000;
  /// Reasoning cycles of one agent in all; 0: no limit.
  std::uint64_t max_cycles = 0;
  /// Ticks of the environment; 0: no limit.
  std::uint64_t max_ticks = 0;
  /// Message rounds within one tick.
  std::uint32_t max_rounds = 10'000;
  /// Agents that live at the same time; beyond, `.create_agent` fails.
  std::size_t max_agents = 1'000'000;
  /// The memory limit of one agent, in bytes: terms (twice, since they are copied when garbage is
  /// collected), beliefs, plans of its own, goals, intentions, events and messages. A step that
  /// exceeds it fails, unless `at_memory_limit` says otherwise.
  std::uint64_t max_agent_bytes = std::uint64_t{1} << 30U;
  /// The memory limit of all agents together; 0: half of the machine's memory. Use is summed
  /// up between rounds: in one round each agent may take what was left before it. Where nothing is
  /// left, an agent that asks for more fails unless it owns less than an eighth of an equal share.
  std::uint64_t max_system_bytes = 0;
  enum class AtMemoryLimit : std::uint8_t { fail_step, end_run };
  AtMemoryLimit at_memory_limit = AtMemoryLimit::fail_step;
  /// Inferences that one query may take; beyond, the step that asks it fails.
  std::uint64_t max_inferences = 100'000'000;
  /// Inferences of all agents in the whole run; 0: no limit.
  std::uint64_t max_run_inferences = 0;
  /// Timers, and the ticks of an environment, follow the wall clock.
  bool realtime = false;
  /// Loads a program during the run (of an agent that is created, or for `.include`) into the run's
  /// own symbols; null after setting `problem`. With a program, `problem` lists the parts that were
  /// left out. Not set: programs cannot be loaded during the run.
  std::function<std::shared_ptr<const Program>(const ProgramRequest& request, SymbolTable& symbols,
                                               LoadProblem& problem)>
      load_program;
  /// Writes a file for `.save_agent`; false after setting `error`. Not set: nothing can be written.
  std::function<bool(const std::string& file, const std::string& text, std::string& error)>
      save_program;
  /// Why `.list_files` may not look into a folder; empty: it may. Not set: it may look into none.
  std::function<std::string(const std::string& folder)> why_not_list;
  /// Receives the output of `.print` and related actions as lines `[agent] text` without line
  /// break.
  std::function<void(std::string_view line)> print;
  /// Receives the output of agents with `verbose=0`, the text as it is; not set: it is dropped.
  std::function<void(std::string_view text)> write;
  /// Warnings and errors of the run (an intention that failed, an unknown action).
  std::function<void(std::string_view line)> log;
  /// Threads on which agents reason in parallel; the result does not depend on their number.
  /// An observer, and functions of agent classes, are called on the thread that runs the system.
  std::size_t threads = 1;
  /// With fewer active agents in a round they reason one after another.
  std::size_t fewest_parallel = 64;
  /// Measures the CPU time that agents spend reasoning; off, no clock is read.
  bool measure_cpu = false;
  /// Observes all agents as they reason (observer.h); must outlive the system.
  /// Null: unobserved.
  ReasoningObserver* observer = nullptr;
  /// Says how probable options are that are labelled learned(P); must outlive the system. Null: one
  /// is as probable as the other.
  OptionPolicies* policies = nullptr;
  /// Asked now and then, on every thread that reasons and within queries and long actions, too:
  /// true ends the run (RunEnd::interrupted). Not set: never.
  std::function<bool()> interrupted;
};

enum class RunEnd {
  stopped,      // `.stopMAS`
  idle,         // every agent is idle, no timer and no message pending
  finished,     // the environment says so
  limit,        // a limit of the run; RunOutcome::limit says which
  looping,      // an agent reasoned max_cycles_per_tick cycles within one tick, or for max_rounds
  interrupted,  // MasOptions::interrupted
};

/// A limit of MasOptions that ends a run.
enum class RunLimit : std::uint8_t { none, cycles, ticks, rounds, inferences, memory };
/// "cycles", "memory", ...; empty for none.
[[nodiscard]] std::string_view name(RunLimit limit);

struct RunOutcome {
  RunEnd end = RunEnd::idle;
  std::uint64_t ticks = 0;
  std::uint64_t cycles = 0;
  int exit_code = 0;    // given to .stopMAS
  std::string message;  // of limit and looping: which agent, doing what
  /// For limit and looping: the limit, the agent that reached it (empty: all of them together) and
  /// its work at that moment: "x.asl:2:21", "the context of @p1"; may be empty. For stopped: the
  /// agent that stopped the system at once (empty: it was stopped with a delay).
  RunLimit limit = RunLimit::none;
  std::string agent;
  std::string where;
  /// Inferences that agents have taken.
  std::uint64_t inferences = 0;
};

}  // namespace jaywalk

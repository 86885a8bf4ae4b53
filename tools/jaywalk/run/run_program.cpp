// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "env/environment_process/process_environment.h"
#include "env/process/guarded_child.h"
#include "experiment/scenario/files/write_file.h"
#include "interpreter/agent/surroundings/observer.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/embed/program_loader.h"
#include "interpreter/embed/project_agents.h"
#include "interpreter/mas/mas.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/load.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/shipped.h"
#include "tools/jaywalk/programs/program_check.h"
#include "tools/jaywalk/run/agent_trace.h"
#include "tools/jaywalk/run/java_host.h"
#include "tools/jaywalk/run/own_world.h"
#include "tools/jaywalk/run/run_files.h"
#include "tools/jaywalk/run/world_calls.h"

namespace jaywalk {
namespace {

/// Looking at the clock after every cycle would cost more than the cycle.
constexpr std::uint64_t kStepsBetweenLooks = 4;

constexpr std::uint64_t kMostThreads = 256;

struct Limits {
  MasOptions mas;
  std::optional<double> timeout_s;
};

std::optional<Limits> read_limits(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  Limits limits;
  limits.mas.seed = arguments.number(option::kSeed, 0, diagnostics).value_or(0);
  limits.mas.max_cycles = arguments.number(option::kMaxCycles, 1, diagnostics).value_or(0);
  limits.mas.max_run_inferences =
      arguments.number(option::kMaxInferences, 1, diagnostics).value_or(0);
  limits.mas.max_ticks = arguments.number(option::kMaxTicks, 1, diagnostics).value_or(0);
  if (const auto megabytes =
          arguments.number(option::kMaxMemory, 1, diagnostics, TestLimits::kMostMegabytes)) {
    limits.mas.max_agent_bytes = *megabytes << 20U;
    limits.mas.max_system_bytes = limits.mas.max_agent_bytes;
  }
  limits.mas.realtime = arguments.has(option::kRealtime);
  limits.mas.threads = arguments.number(option::kThreads, 1, diagnostics, kMostThreads).value_or(1);
  limits.timeout_s = arguments.positive(option::kTimeout, diagnostics);
  check_coverage_options(arguments, diagnostics);
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return std::nullopt;
  }
  limits.mas.print = [&console, flush = limits.mas.realtime](std::string_view line) {
    console.print(line);
    console.print("\n");
    if (flush) console.flush();
  };
  limits.mas.write = [&console](std::string_view text) { console.print(text); };
  limits.mas.log = [&console](std::string_view line) { console.warn_of_agent(line); };
  return limits;
}

ExitCode verdict(const RunOutcome& outcome, Console& console) {
  switch (outcome.end) {
    case RunEnd::stopped:
      return outcome.exit_code == 0 ? ExitCode::success : ExitCode::failed;
    case RunEnd::idle:
    case RunEnd::finished:
      return ExitCode::success;
    case RunEnd::limit:
    case RunEnd::looping:
      console.error(outcome.message);
      return ExitCode::failed;
    case RunEnd::interrupted:
      console.note("interrupted");
      return ExitCode::interrupted;
  }
  std::abort();
}

std::string_view name(RunEnd end) {
  switch (end) {
    case RunEnd::stopped:
      return "stopped";
    case RunEnd::idle:
      return "idle";
    case RunEnd::finished:
      return "finished";
    case RunEnd::limit:
      return "limit";
    case RunEnd::looping:
      return "looping";
    case RunEnd::interrupted:
      return "interrupted";
  }
  std::abort();
}

/// How a run ended: as a RunEnd, "interrupted", or "timeout".
struct End {
  ExitCode code = ExitCode::success;
  std::string_view how;
};

/// The agents' world, if it is a program.
struct RunWorld {
  OwnWorld named;
  std::unique_ptr<ProcessEnvironment> environment;
  DeclaredWords words;
};

/// The world that the user names, or the host of the agents' Java classes.
std::optional<OwnWorld> named_world(const Arguments& arguments, const ProjectParts& parts,
                                    const std::string& folder, Diagnostics& diagnostics) {
  const bool is_named = arguments.has(option::kEnvironment) || parts.environment;
  if (!is_named && has_jason(arguments) && (parts.java.environment || calls_java(parts.programs))) {
    return java_world(arguments, parts.java, folder, diagnostics);
  }
  return own_world(arguments, parts.environment, folder, diagnostics);
}

/// Starts the agents' world; none if they have none, after adding errors, and if the user
/// interrupts it.
std::optional<RunWorld> start_world(const Arguments& arguments, const ProjectParts& parts,
                                    const std::string& folder, Console& console,
                                    Diagnostics& diagnostics) {
  auto named = named_world(arguments, parts, folder, diagnostics);
  if (!named) return std::nullopt;
  auto environment = make_world(*named, console);
  const InterruptGuard interrupt;
  if (!environment->start()) {
    if (!interrupt.interrupted()) named->report_failure(*environment, diagnostics);
    return std::nullopt;
  }
  DeclaredWords words(environment->identity());
  return RunWorld{std::move(*named), std::move(environment), std::move(words)};
}

/// Ends the world's program. How the run ended, if the world failed.
std::optional<End> end_world(RunWorld& world, const InterruptGuard& interrupt, Console& console) {
  world.environment->end();
  if (world.environment->failure().empty()) return std::nullopt;
  if (interrupt.interrupted()) {
    console.note("interrupted");
    return End{ExitCode::interrupted, "interrupted"};
  }
  Diagnostics diagnostics;
  world.named.report_failure(*world.environment, diagnostics);
  console.report(diagnostics);
  return End{ExitCode::failed, "errored"};
}

/// `calls`: what the world does for agents beside what they perceive; may be null.
End run_to_end(Mas& mas, WorldCalls* calls, const Limits& limits, const InterruptGuard& interrupt,
               Console& console) {
  const Deadline deadline(limits.timeout_s);
  for (std::uint64_t steps = 1; mas.stride(); ++steps) {
    if (calls != nullptr) calls->deliver(mas);
    if (interrupt.interrupted()) {
      console.note("interrupted");
      return {ExitCode::interrupted, "interrupted"};
    }
    // In real time a step may sleep.
    if ((limits.mas.realtime || steps % kStepsBetweenLooks == 0) && deadline.passed()) {
      console.error(fmt::format("stopped after {:g} s (--timeout)", deadline.seconds()));
      return {ExitCode::failed, "timeout"};
    }
  }
  return {verdict(mas.outcome(), console), name(mas.outcome().end)};
}

/// Whether the warnings of `check` are reported, and whether programs belong to a project.
enum class ProgramCheck { off, alone, in_project };

/// Loads and compiles each agent's program, once for all agents that share it. Those whose program
/// is missing or wrong are left out and diagnosed.
std::vector<AgentSpec> compile_all(const std::vector<ProgramSource>& sources, ProgramCheck check,
                                   KnownWorld world, const ActionRegistry* actions,
                                   SymbolTable& symbols, Diagnostics& all) {
  std::vector<AgentSpec> agents;
  for (const ProgramSource& source : sources) {
    Diagnostics diagnostics;
    const SourceTree tree = load_source(source, diagnostics);
    const auto program = compile(tree, symbols, diagnostics, {.actions = actions});
    // The agent runs without the missing include, as in Jason, but it is reported as an error.
    diagnostics = with_errors(diagnostics, kMissingInclude, kMissingIncludeHint);
    if (program && check != ProgramCheck::off) {
      check_compiled(tree, source.path,
                     check == ProgramCheck::alone ? StartedAs::alone : StartedAs::part, world,
                     actions, diagnostics);
    }
    all.append(std::move(diagnostics));
    if (!program) continue;
    for (const std::string& name : source.agents) {
      agents.push_back(
          {.name = name, .program = program, .parameters = {}, .settings = source.settings});
    }
  }
  return agents;
}

/// The folders in which programs may write: the working folder, and those of options. Nothing after
/// reporting a folder that does not exist.
std::optional<AllowedFolders> writable_folders(const Arguments& arguments, Console& console) {
  AllowedFolders writable(option::kAllowWrite.dashed());
  writable.add(".");
  Diagnostics diagnostics;
  for (const std::string& folder : arguments.texts(option::kAllowWrite)) {
    if (is_folder(option::kAllowWrite, folder, diagnostics)) writable.add(folder);
  }
  console.report(diagnostics);
  return diagnostics.has_errors() ? std::nullopt : std::optional(writable);
}

/// `folder` is the one of the program or project.
ExitCode run_parts(ProjectParts parts, const std::string& folder, ProgramCheck check,
                   const Limits& limits, const Arguments& arguments, Console& console) {
  const std::optional<AllowedFolders> writable = writable_folders(arguments, console);
  if (!writable) return ExitCode::usage;
  const auto symbols = std::make_shared<SymbolTable>();
  Diagnostics diagnostics;
  auto world = start_world(arguments, parts, folder, console, diagnostics);
  if (end_requested) {
    console.note("interrupted");
    return ExitCode::interrupted;
  }
  const bool lacks_world = diagnostics.has_errors();
  std::optional<WorldCalls> calls;
  if (world && world->named.has_actions) {
    calls.emplace(*world->environment);
    Diagnostics reported_later;
    for (const ProgramSource& program : parts.programs) {
      calls->add_missing(load_source(program, reported_later));
    }
  }
  const ActionRegistry* const actions = calls ? &calls->actions() : nullptr;
  std::vector<AgentSpec> agents = compile_all(
      parts.programs, arguments.has(option::kNoCheck) ? ProgramCheck::off : check,
      world ? KnownWorld(world->words.kind()) : KnownWorld(), actions, *symbols, diagnostics);
  console.report(diagnostics);
  if (lacks_world || (agents.empty() && diagnostics.has_errors())) return ExitCode::usage;
  MasOptions options = limits.mas;
  if (world && world->environment->identity().free_running && !options.realtime) {
    options.realtime = true;
    options.print = [&console, print = options.print](std::string_view line) {
      print(line);
      console.flush();
    };
  }
  const IncludePath include_path =
      parts.programs.empty() ? IncludePath{} : parts.programs.front().include_path;
  parts.programs = {};  // which has a name for each of perhaps very many agents, as the agents have
  options.load_program = [loader = std::make_shared<ProgramLoader>(folder, include_path, actions)](
                             const ProgramRequest& request, SymbolTable& run_symbols,
                             LoadProblem& problem) {
    return loader->load(request, run_symbols, problem);
  };
  options.why_not_list = [readable =
                              include_path.readable_from(folder)](const std::string& listed) {
    const auto denial = readable.denial(listed);
    return denial ? fmt::format("cannot list {}: {}", listed, denial->text()) : std::string();
  };
  options.save_program = [writable = *writable](const std::string& file, const std::string& text,
                                                std::string& error) {
    if (const auto denial = writable.denial(file)) {
      error = fmt::format("cannot write {}: {}", file, denial->text());
    } else {
      error = write_file(file, text).value_or("");
    }
    return error.empty();
  };
  const std::string& subject = arguments.operands().front();
  Observers observers;
  Probes probes(symbols, Probes::Detail::counts);
  std::optional<CoverageObserver> coverage;
  if (arguments.has(option::kCoverage)) {
    for (const AgentSpec& agent : agents) probes.add(agent.program);
    observers.add(coverage.emplace(probes));
  }
  std::optional<TraceFile> trace_file;
  if (!open_trace(arguments, trace_file, console)) return ExitCode::usage;
  std::optional<ProgramTrace> trace;
  if (trace_file) {
    observers.add(trace.emplace(*trace_file));
    trace->begin(subject, agents.size(), options.seed);
  }
  options.observer = observers.get();
  const InterruptGuard interrupt;
  options.interrupted = [&interrupt] { return interrupt.interrupted(); };
  const std::uint64_t seed = options.seed;
  Mas mas(symbols, std::move(options), world ? world->environment.get() : nullptr);
  for (const AgentSpec& agent : agents) mas.add_agent(agent);
  if (world) {
    mas.embody_newcomers();
    // A world that cannot begin is finished.
    (void)world->environment->begin_run(seed,
                                        {.count = agents.size(),
                                         .name = [&mas](AgentId id) { return mas.agent_name(id); },
                                         .next_timer_ms = [&mas] { return mas.next_timer_ms(); }});
  }
  agents = {};
  End end = run_to_end(mas, calls ? &*calls : nullptr, limits, interrupt, console);
  std::string why = mas.outcome().message;
  if (const auto failed = world ? end_world(*world, interrupt, console) : std::nullopt) {
    end = *failed;
    why = world->environment->failure();
  }
  console.tell_counted();
  if (trace) {
    trace->end(end.how, why, mas.now_ms() / 1000, static_cast<int>(end.code));
  }
  if (!finish_trace(arguments, trace_file, console)) return ExitCode::failed;
  if (coverage &&
      !write_coverage(arguments, locate_in_files(probes, coverage->counts(), files_on_disk()),
                      subject, console)) {
    return ExitCode::failed;
  }
  // As in Jason, the agents of a project with valid programs run without the others.
  return end.code == ExitCode::success && diagnostics.has_errors() ? ExitCode::usage : end.code;
}

std::string folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.string();
}

}  // namespace

ExitCode run_agent_file(const std::string& path, const Arguments& arguments, Console& console) {
  const auto limits = read_limits(arguments, console);
  const auto include_path = read_include_path(arguments, console);
  if (!limits || !include_path) return ExitCode::usage;
  const ProgramSource source{.path = path,
                             .include_path = *include_path,
                             .agents = {std::filesystem::path(path).stem().string()}};
  return run_parts({.programs = {source}, .environment = {}, .java = {}}, folder_of(path),
                   ProgramCheck::alone, *limits, arguments, console);
}

ExitCode run_project_file(const std::string& path, const Arguments& arguments, Console& console) {
  const auto limits = read_limits(arguments, console);
  const auto include_path = read_include_path(arguments, console);
  if (!limits || !include_path) return ExitCode::usage;
  Diagnostics diagnostics;
  const JavaParts java{.hosted = has_jason(arguments),
                       .ignored = arguments.has(option::kIgnoreJava)};
  auto parts = read_project_agents(path, *include_path, java, diagnostics);
  console.report(diagnostics);
  if (!parts) return ExitCode::usage;
  return run_parts(std::move(*parts), folder_of(path), ProgramCheck::in_project, *limits, arguments,
                   console);
}

}  // namespace jaywalk

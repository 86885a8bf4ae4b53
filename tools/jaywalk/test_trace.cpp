#include "tools/jaywalk/test_trace.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interpreter/agent/agent.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

/// Keys stay in the order in which they are written.
using Line = nlohmann::ordered_json;

void append(std::string& lines, const Line& line) {
  lines += line.dump(-1, ' ', false, Line::error_handler_t::replace);
  lines += '\n';
}

/// The formula's literal with the values that its variables have by now.
Value literal_of(Agent& agent, const Intention& intention, const Step& step, std::size_t& trail) {
  Unifier& unifier = agent.machine().unifier();
  trail = unifier.mark();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): what is bound in the frame is undone
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

void TestTrace::begin(std::string_view behaviour, const TrialInput& input) {
  append(lines_, {{"kind", "test"},
                  {"behaviour", behaviour},
                  {"agents", input.agents},
                  {"test", input.test},
                  {"seed", input.seed}});
}

void TestTrace::event_posted(Agent& agent, const Event& event) {
  const bool percept =
      event.kind == TriggerKind::belief && is_percept(event.literal, agent.symbols());
  append(lines_, {{"kind", percept ? "percept" : "event"},
                  {"tick", tick_},
                  {"agent", agent.name()},
                  {percept ? "change" : "event", agent.trigger_text(event)}});
}

void TestTrace::plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                            const Intention& /*intention*/) {
  if (plan.is_standard) return;
  append(lines_, {{"kind", "plan"},
                  {"tick", tick_},
                  {"agent", agent.name()},
                  {"event", agent.trigger_text(event)},
                  {"plan", agent.plan_name(plan)}});
}

void TestTrace::formula_executes(Agent& agent, const Intention& intention, const Step& step) {
  const bool acts = step.kind == Step::Kind::action;
  if ((!acts && step.kind != Step::Kind::internal_action) || step.term.is_unset()) return;
  std::size_t trail = 0;
  const Value literal = literal_of(agent, intention, step, trail);
  if (acts) {
    // Whoever acts again has not heard of a failure.
    const auto before = actions_.find(agent.name());
    if (before != actions_.end()) write(before->second, before->first);
    actions_[agent.name()] = {.text = term_text(literal, agent.symbols()), .tick = tick_};
  } else if (is_literal(literal)) {
    const LiteralParts parts = literal_parts(literal);
    const std::string_view name = agent.symbols().functor(parts.predicate);
    const bool to_all = name == ".broadcast";
    if ((to_all && parts.args.size() >= 2) || (name == ".send" && parts.args.size() >= 3)) {
      const std::size_t first = to_all ? 0 : 1;
      const auto text = [&](std::size_t i) { return term_text(parts.args[i], agent.symbols()); };
      append(lines_, {{"kind", "message"},
                      {"tick", tick_},
                      {"agent", agent.name()},
                      {"to", to_all ? "all" : text(0)},
                      {"performative", text(first)},
                      {"content", text(first + 1)}});
    }
  }
  agent.machine().unifier().undo(trail);
}

void TestTrace::formula_failed(Agent& agent, const Intention& /*intention*/,
                               const ActionError& error) {
  const auto action = actions_.find(agent.name());
  if (action != actions_.end() && error.id == "action_failed") {
    action->second.failed = true;
    action->second.reason = error.message;
    write(action->second, action->first);
    actions_.erase(action);
    return;
  }
  append(lines_, {{"kind", "failure"},
                  {"tick", tick_},
                  {"agent", agent.name()},
                  {"error", error.id},
                  {"reason", error.message}});
}

void TestTrace::write(const Action& action, const std::string& agent) {
  Line line{{"kind", "action"},
            {"tick", action.tick},
            {"agent", agent},
            {"action", action.text},
            {"outcome", action.failed ? "failed" : "done"}};
  if (action.failed) line["reason"] = action.reason;
  append(lines_, line);
}

void TestTrace::tick(const Crossing& crossing, const Mas& mas) {
  // Whoever had failed in the tick before has heard of it by now.
  for (auto it = actions_.begin(); it != actions_.end();) {
    if (it->second.tick >= crossing.ticks() && !crossing.finished()) {
      ++it;
      continue;
    }
    // Of the last tick nobody hears any more: a step that led nowhere has failed.
    if (it->second.tick >= crossing.ticks() && it->second.text.starts_with("move(")) {
      for (std::size_t i = 0; i < crossing.bodies().size(); ++i) {
        if (mas.agent_name(static_cast<AgentId>(i)) != it->first) continue;
        it->second.failed = crossing.bodies()[i].stepped_in != crossing.ticks();
      }
    }
    write(it->second, it->first);
    it = actions_.erase(it);
  }
  append(lines_, {{"kind", "tick"},
                  {"tick", crossing.ticks()},
                  {"time_s", crossing.ticks() * crossing.parameters().tick_s}});
  tick_ = crossing.ticks() + 1;
}

void TestTrace::end(const TrialResult& result) {
  Line line{{"kind", "end"},
            {"completed", result.completed},
            {"met_precondition", result.outcome.success},
            {"ticks", result.outcome.ticks},
            {"score", result.outcome.score()},
            {"collisions", result.outcome.collisions.size()}};
  if (!result.completed) line["reason"] = result.message;
  append(lines_, line);
}

TraceFile::TraceFile(std::string path) : path_(std::move(path)) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path_, ignored);
  const bool regular = !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
  temporary_ = regular ? fmt::format("{}.{}.part", path_, ::getpid()) : path_;
  file_ = std::fopen(temporary_.c_str(), "wb");
  if (file_ == nullptr) failure_ = std::generic_category().message(errno);
}

TraceFile::~TraceFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  if (temporary_ == path_) return;
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void TraceFile::write(std::string_view lines) {
  if (!failure_.empty() || file_ == nullptr || lines.empty()) return;
  if (std::fwrite(lines.data(), 1, lines.size(), file_) != lines.size()) {
    failure_ = std::generic_category().message(errno);
  }
}

void TraceFile::add(std::uint64_t number, std::string lines) {
  const std::lock_guard lock(mutex_);
  waiting_.emplace(number, std::move(lines));
  for (auto it = waiting_.begin(); it != waiting_.end() && it->first == next_; ++next_) {
    write(it->second);
    it = waiting_.erase(it);
  }
}

std::string TraceFile::finish() {
  // After an interruption there are gaps.
  for (const auto& [number, lines] : waiting_) write(lines);
  waiting_.clear();
  if (file_ != nullptr && std::fclose(file_) != 0 && failure_.empty()) {
    failure_ = std::generic_category().message(errno);
  }
  file_ = nullptr;
  if (failure_.empty() && temporary_ != path_ &&
      std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    failure_ = std::generic_category().message(errno);
  }
  return failure_;
}

bool open_trace(const Arguments& arguments, std::optional<TraceFile>& trace, Console& console) {
  const auto path = arguments.text("trace");
  if (!path) return true;
  if (arguments.has("coverage")) {
    console.error("--trace and --coverage each look at the agents alone",
                  "run the same tests twice: they are the same for one seed");
    return false;
  }
  trace.emplace(*path);
  if (trace->failure().empty()) return true;
  console.error(fmt::format("cannot write '{}': {}", *path, trace->failure()));
  return false;
}

bool finish_trace(const Arguments& arguments, std::optional<TraceFile>& trace, Console& console) {
  if (!trace) return true;
  const std::string why = trace->finish();
  if (why.empty()) return true;
  console.error(fmt::format("cannot write '{}': {}", arguments.text("trace").value_or(""), why));
  return false;
}

}  // namespace jaywalk

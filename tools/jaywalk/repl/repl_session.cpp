// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/repl/repl_session.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/mas/mas.h"
#include "interpreter/term/print.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/repl/line_editor.h"

namespace jaywalk {
namespace {

/// The most reasoning cycles after one input, for an agent that never rests.
constexpr std::uint64_t kCycles = 100'000;

constexpr std::string_view kHelp =
    "What is typed ends with a full stop and may take several lines:\n"
    "  ?- p(X) & X > 1.      asks; every answer is shown\n"
    "  +p(1).  -p(1).        adds or removes a belief\n"
    "  !g(1).                gives the agent a goal\n"
    "  q(X) :- p(X).         adds what a program may contain: beliefs, rules, plans ...\n"
    "  +!g(X) <- .print(X).\n"
    "Several may stand on a line; each is read as it would be alone. Tab completes names.\n"
    "Commands stand on a line of their own, also amid an input (of ':help' and ':quit' the colon\n"
    "may be left out):\n"
    "  :load FILE            begins anew with the agent in a file\n"
    "  :reload               the same with the file as it is now\n"
    "  :beliefs [NAME]       what is believed\n"
    "  :rules                the rules\n"
    "  :plans [NAME]         the plans, or those for triggers of a name\n"
    "  :intentions           what the agent is after\n"
    "  :trace GOAL           gives a goal and shows each step; in a terminal Enter goes\n"
    "                        on, c goes on to the end\n"
    "  :run                  goes on with an agent that never rests\n"
    "  :help                 this\n"
    "  :quit                 ends, as Ctrl-D does\n"
    "Ctrl-C drops what was typed, and ends a query that takes long.\n";

std::string answer_text(const Answer& answer) {
  std::string text;
  for (const Answer::Binding& binding : answer.bindings()) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} = {}", binding.variable, binding.term);
  }
  return text.empty() ? "true" : text;
}

std::string_view functor_of(Value literal, const SymbolTable& symbols) {
  return is_literal(literal) ? symbols.functor(literal_parts(literal).predicate)
                             : std::string_view();
}

}  // namespace

void ReplTrace::event_selected(Agent& agent, const Event& event) {
  if (on_) tell(fmt::format("event    {}", agent.trigger_text(event)));
}

void ReplTrace::plan_tried(Agent& agent, const Plan& plan, bool applicable) {
  if (on_ && !plan.is_standard && !applicable) {
    tell(fmt::format("  not    {}: its context does not hold", agent.plan_name(plan)));
  }
}

void ReplTrace::plan_chosen(Agent& agent, const Plan& plan, const Event& /*event*/,
                            const Intention& /*intention*/) {
  if (on_ && !plan.is_standard) tell(fmt::format("  takes  {}", agent.plan_name(plan)));
}

void ReplTrace::no_plan(Agent& /*agent*/, const Event& /*event*/, bool had_candidates) {
  if (on_) tell(had_candidates ? "  no plan is applicable" : "  there is no plan for it");
}

void ReplTrace::formula_executes(Agent& agent, const Intention& intention, const Step& step) {
  if (on_) tell(fmt::format("formula  {}", formula_with_values(agent, intention, step)));
}

void ReplTrace::formula_failed(Agent& /*agent*/, const Intention& /*intention*/,
                               const ActionError& error) {
  if (!on_) return;
  const std::string why = error.message.empty() ? std::string() : ": " + error.message;
  tell(fmt::format("  fails  {}{}", error.id, why));
}

ReplSession::ReplSession(IncludePath include_path, Console& console, LineReader* pauses)
    : include_path_(std::move(include_path)),
      console_(console),
      pauses_(pauses),
      trace_([this](std::string_view line) {
        print_line(line);
        if (!waits_) return;
        console_.flush();
        const auto answer = pauses_->read("");
        waits_ = answer && !answer->cancelled && answer->text != "c";
      }) {}

void ReplSession::print_line(std::string_view line) {
  console_.print(line);
  console_.print("\n");
}

bool ReplSession::load(const std::string& path) {
  MasOptions options;
  options.print = [this](std::string_view line) { print_line(line); };
  options.write = [this](std::string_view text) { console_.print(text); };
  options.log = [this](std::string_view line) { console_.log(LogLevel::warning, line); };
  options.observer = &trace_;
  auto fresh = std::make_unique<Interpreter>(std::move(options));
  const auto program = path.empty() ? fresh->load_text("agent.asl", "", include_path_)
                                    : fresh->load_file(path, include_path_);
  if (!program) return accept(program.diagnostics());
  const std::string name = path.empty() ? "agent" : std::filesystem::path(path).stem().string();
  // Only now: a program with errors leaves the agent as it was.
  agent_ = fresh->add_agent(name, program.value());
  interpreter_ = std::move(fresh);
  path_ = path;
  reason();
  return true;
}

void ReplSession::reason() {
  const InterruptGuard interrupt;
  trace_.heed(&interrupt);
  std::uint64_t cycles = 0;
  // Cycle by cycle, so that Ctrl-C works, and the prompt comes back even if the agent never rests.
  while (!interrupt.interrupted() && cycles < kCycles && interpreter_->step()) ++cycles;
  trace_.heed(nullptr);
  if (interrupt.interrupted()) {
    console_.note("interrupted");
  } else if (cycles == kCycles) {
    console_.note(fmt::format("still reasoning after {} cycles; ':run' goes on", kCycles));
  } else if (interpreter_->mas().outcome().end == RunEnd::stopped) {
    console_.note("the agent has stopped everything; ':reload' begins anew");
  }
}

bool ReplSession::accept(const Diagnostics& found) {
  console_.report(found);
  had_mistakes_ = had_mistakes_ || found.has_errors();
  return !found.has_errors();
}

void ReplSession::mistake(std::string_view message, std::string_view hint) {
  console_.error(message, hint);
  had_mistakes_ = true;
}

bool ReplSession::carry_out(const ReplInput& input) {
  using Kind = ReplInput::Kind;
  if (input.kind == Kind::nothing) return true;
  if (input.kind == Kind::command) return carry_out_command(input);
  if (!interpreter_->mas().is_alive(agent_)) {
    mistake("the agent is gone", "':reload' begins anew");
    return true;
  }
  bool done = true;
  switch (input.kind) {
    case Kind::query:
      ask(input.text);
      break;
    case Kind::add:
      done = accept(interpreter_->believe(agent_, input.text));
      break;
    case Kind::remove:
      done = accept(interpreter_->forget(agent_, input.text));
      break;
    case Kind::goal:
      done = accept(interpreter_->achieve(agent_, input.text));
      if (done) suggest(input.text, true);
      break;
    case Kind::program:
      done = accept(interpreter_->include(agent_, "input", input.text));
      break;
    case Kind::nothing:
    case Kind::command:
      break;
  }
  if (done) reason();
  return true;
}

void ReplSession::ask(const std::string& query) {
  const InterruptGuard interrupt;
  trace_.heed(&interrupt);
  bool any = false;
  const Diagnostics found = interpreter_->ask(agent_, query, [&](const Answer& answer) {
    any = true;
    print_line(answer_text(answer));
    console_.flush();
    return !interrupt.interrupted() && Console::can_print();
  });
  trace_.heed(nullptr);
  if (interrupt.interrupted()) {
    console_.note("interrupted");
  } else if (accept(found) && !any) {
    print_line("false");
    suggest(query, false);
  }
}

void ReplSession::suggest(const std::string& text, bool is_goal) {
  const std::size_t end = text.find_first_of("([. &|=<>");
  const std::string name = text.substr(0, std::min(end, text.size()));
  const bool is_atom = !name.empty() && name.front() >= 'a' && name.front() <= 'z';
  const ReplNames known = names();
  const std::vector<std::string>& same_kind = is_goal ? known.goals : known.predicates;
  if (!is_atom || std::ranges::find(same_kind, name) != same_kind.end()) return;
  const auto like = closest(name, same_kind);
  if (like) console_.note(fmt::format("did you mean '{}{}'?", is_goal ? "!" : "", *like));
}

ReplNames ReplSession::names() const {
  ReplNames names{.commands = repl_commands(), .predicates = {}, .goals = {}, .actions = {}};
  for (const ActionDefinition& action : standard_actions().actions()) {
    names.actions.emplace_back(action.name);
  }
  for (const FunctionDefinition& function : standard_actions().functions()) {
    names.actions.emplace_back(function.name);
  }
  if (!interpreter_->mas().is_alive(agent_)) return names;
  const Agent& agent = interpreter_->mas().agent(agent_);
  for (const auto& relation : agent.beliefs().relations()) {
    names.predicates.emplace_back(agent.symbols().functor(relation->predicate()));
  }
  for (const auto& plan : agent.library().plans()) {
    const std::string_view name = functor_of(plan->trigger, agent.symbols());
    const bool is_goal = plan->key.kind == TriggerKind::achieve;
    if (is_goal && !plan->is_standard && !name.empty()) names.goals.emplace_back(name);
  }
  return names;
}

void ReplSession::trace(const std::string& goal) {
  std::string literal = goal;
  if (literal.starts_with('!')) literal.erase(0, 1);
  if (literal.ends_with('.')) literal.pop_back();
  if (!accept(interpreter_->achieve(agent_, literal))) return;
  trace_.set_on(true);
  waits_ = pauses_ != nullptr;
  reason();
  trace_.set_on(false);
}

void ReplSession::show_beliefs(const std::string& name) {
  const Agent& agent = interpreter_->mas().agent(agent_);
  for (const auto& relation : agent.beliefs().relations()) {
    if (!name.empty() && agent.symbols().functor(relation->predicate()) != name) continue;
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Row& row = relation->row(seq);
      if (!row.fact.is_unset()) print_line(term_text(row.fact, agent.symbols()));
    }
  }
}

void ReplSession::show_rules_and_plans(const std::string& name, bool rules) {
  // Prints the rules or plans without the agent's name before each line.
  std::string problem;
  const bool completed = interpreter_->mas().intervene(
      agent_,
      [&](Agent& agent) {
        if (rules) {
          for (const auto& relation : agent.beliefs().relations()) {
            for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
              const Row& row = relation->row(seq);
              if (row.rule == nullptr) continue;
              const Value rule = actions::rule_term(agent.machine().unifier(), *row.rule);
              std::string text = term_text(deref(rule.structure()->arg(0)), agent.symbols());
              text += " :- ";
              append_term(text, rule.structure()->arg(1), agent.symbols());
              print_line(text + ".");
            }
          }
          return;
        }
        for (const auto& plan : agent.library().plans()) {
          if (plan->is_standard) continue;
          if (!name.empty() && functor_of(plan->trigger, agent.symbols()) != name) continue;
          const std::string text = term_text(agent.plan_term(*plan), agent.symbols());
          print_line(text.substr(2, text.size() - 4) + ".");  // without the braces
        }
      },
      problem);
  if (!completed) mistake(problem);
}

void ReplSession::show_intentions() {
  for (const std::string& text : interpreter_->mas().describe_intentions(agent_)) print_line(text);
}

bool ReplSession::carry_out_command(const ReplInput& input) {
  const std::string& word = input.word;
  if (word == "quit") return false;
  if (word == "help") {
    console_.print(kHelp);
  } else if (word == "load") {
    if (input.text.empty()) {
      mistake("expected a file", ":load FILE");
    } else {
      (void)load(input.text);
    }
  } else if (word == "reload") {
    (void)load(path_);
  } else if (std::find(repl_commands().begin(), repl_commands().end(), word) ==
             repl_commands().end()) {
    const std::string hint = did_you_mean(word, repl_commands());
    mistake(fmt::format("unknown command ':{}'", word),
            hint.empty() ? "':help' names the commands" : hint);
  } else if (!interpreter_->mas().is_alive(agent_)) {
    mistake("the agent is gone", "':reload' begins anew");
  } else if (word == "beliefs") {
    show_beliefs(input.text);
  } else if (word == "rules" || word == "plans") {
    show_rules_and_plans(input.text, word == "rules");
  } else if (word == "intentions") {
    show_intentions();
  } else if (word == "trace") {
    trace(input.text);
  } else {
    reason();
  }
  return true;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/compile/translator.h"
#include "interpreter/embed/agent_functions.h"
#include "interpreter/mas/mas.h"
#include "interpreter/syntax/load.h"
#include "interpreter/syntax/parser.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"
#include <jaywalk/interpreter.h>

namespace jaywalk {

const Answer::Binding* Answer::find(std::string_view variable) const {
  const auto found = std::ranges::find(bindings_, variable, &Binding::variable);
  return found == bindings_.end() ? nullptr : &*found;
}

std::string Answer::operator[](std::string_view variable) const {
  const Binding* const found = find(variable);
  return found == nullptr ? std::string() : found->term;
}

namespace {

/// A text on its way to become a term with variables of its own.
class QueryText {
 public:
  using Parse = const ast::Node* (*)(const SourcePtr&, ast::Arena&, Diagnostics&);

  QueryText(const std::string& name, const std::string& text, Parse parse)
      : source_(std::make_shared<const Source>(name, text)) {
    node_ = parse(source_, arena_, diagnostics_);
  }

  [[nodiscard]] bool is_good() const { return node_ != nullptr && !diagnostics_.has_errors(); }
  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
  void error(std::string message) {
    const auto end = static_cast<std::uint32_t>(source_->text().size());
    diagnostics_.error({source_, Span{0, end}}, std::move(message));
  }

  /// As a formula; `variables` receives those with a name, in order.
  [[nodiscard]] Value formula(Agent& agent, std::vector<Value>& variables) const {
    VariableScope scope(VariableScope::Kind::variables, agent.heap(), agent.symbols());
    const Value term =
        Translator(agent.heap(), agent.symbols(), agent.machine().actions()).formula(*node_, scope);
    for (const Symbol name : scope.slot_names()) {
      if (name != names::unnamed) variables.push_back(scope.find(agent.symbols().text(name)));
    }
    return term;
  }

 private:
  SourcePtr source_;
  ast::Arena arena_;
  Diagnostics diagnostics_;
  const ast::Node* node_ = nullptr;
};

/// While it lives, an interpreter is at work.
class AtWork {
 public:
  explicit AtWork(bool& is_at_work) : is_at_work_(is_at_work) { is_at_work_ = true; }
  ~AtWork() { is_at_work_ = false; }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  bool& is_at_work_;
};

bool is_formula(Value term) {
  if (is_literal(term) || term.is_variable()) return true;
  if (!term.is_structure()) return false;
  const Form form = term.structure()->form();
  return form == Form::relation || form == Form::logical || form == Form::decorated;
}

Answer answer_of(Terms terms, std::span<const Interpreter::BoundVariable> variables) {
  std::vector<Answer::Binding> bindings;
  for (const auto& [name, value] : variables) {
    Answer::Binding& binding = bindings.emplace_back();
    binding.variable = name;
    binding.term = terms.printed(value);
    if (value.is_number()) binding.number = value.as_number();
    if (value.is_text()) binding.text = terms.text(value);
  }
  return Answer(std::move(bindings));
}

}  // namespace

class Interpreter::Implementation {
 public:
  Implementation(MasOptions options, const EnvironmentMaker& make_environment) {
    actions.add_all(standard_actions());
    const auto symbols = std::make_shared<SymbolTable>();
    if (make_environment) environment = make_environment(*symbols);
    if (!options.load_program) {
      options.load_program = [this](const ProgramRequest& request, SymbolTable&,
                                    LoadProblem& problem) -> std::shared_ptr<const Program> {
        problem.text = why_denied("read", request.file);
        problem.is_refused = !problem.text.empty();
        if (problem.is_refused) return nullptr;
        Diagnostics diagnostics;
        const SourceTree tree = load_agent(request.file, include_path, diagnostics);
        auto program = compiled(tree, std::move(diagnostics),
                                {.ns = request.ns, .fresh_names = request.included});
        if (program) return program.value();
        problem.text = program.diagnostics().items().front().message;
        return nullptr;
      };
    }
    if (!options.why_not_list) {
      options.why_not_list = [this](const std::string& folder) {
        return why_denied("list", folder);
      };
    }
    mas = std::make_unique<Mas>(symbols, std::move(options), environment.get());
  }

  void note_loading(const std::string& program, const IncludePath& path);
  [[nodiscard]] Result<std::shared_ptr<const Program>> compiled(const SourceTree& tree,
                                                                Diagnostics diagnostics,
                                                                CompileOptions options);
  /// Why the agents may not read or list a file; empty: they may.
  [[nodiscard]] std::string why_denied(std::string_view verb, const std::string& path) const;
  /// Why this interpreter cannot do anything with the agent now; empty if it can.
  [[nodiscard]] std::string obstacle(AgentId agent) const;
  [[nodiscard]] Diagnostics tell(AgentId agent, const std::string& name, const std::string& text,
                                 const std::function<void(Agent&, Value literal)>& what);

  ActionRegistry actions;
  std::unique_ptr<Environment> environment;
  std::unique_ptr<Mas> mas;
  std::vector<std::shared_ptr<const Program>> programs;
  // The files that agents may read as they run: those of the program that was loaded last, and in
  // the folders of all programs.
  IncludePath include_path;
  std::set<std::string> folders;
  bool is_at_work = false;
};

Interpreter::Interpreter(MasOptions options, const EnvironmentMaker& make_environment)
    : implementation_(std::make_unique<Implementation>(std::move(options), make_environment)) {}
Interpreter::~Interpreter() = default;

void Interpreter::Implementation::note_loading(const std::string& program,
                                               const IncludePath& path) {
  include_path = path;
  folders.insert(std::filesystem::path(program).parent_path().string());
}

std::string Interpreter::Implementation::why_denied(std::string_view verb,
                                                    const std::string& path) const {
  AllowedFolders readable;
  for (const std::string& folder : folders) readable.add(include_path.readable_from(folder));
  const auto denial = readable.denial(path);
  return denial ? fmt::format("cannot {} {}: {}", verb, path, denial->text()) : std::string();
}

void Interpreter::add_action(std::string name, int least_args, int most_args,
                             std::function<Outcome(Call& call)> body) {
  implementation_->actions.add(own_action(std::move(name), least_args, most_args,
                                          [body = std::move(body)](ActionCall& internal) {
                                            Call call(internal);
                                            return body(call);
                                          }));
}

void Interpreter::add_function(FunctionDefinition function) {
  implementation_->actions.add(std::move(function));
}

Result<std::shared_ptr<const Program>> Interpreter::Implementation::compiled(
    const SourceTree& tree, Diagnostics diagnostics, CompileOptions options) {
  options.actions = &actions;
  auto program = compile(tree, mas->symbols(), diagnostics, options);
  // `run` leaves an include with errors out; here it is refused.
  if (program == nullptr || diagnostics.has_errors()) return diagnostics;
  programs.push_back(program);
  return program;
}

Result<std::shared_ptr<const Program>> Interpreter::load_file(const std::string& path,
                                                              const IncludePath& include_path) {
  implementation_->note_loading(path, include_path);
  Diagnostics diagnostics;
  const SourceTree tree = load_agent(path, include_path, diagnostics);
  return implementation_->compiled(tree, std::move(diagnostics), {});
}

Result<std::shared_ptr<const Program>> Interpreter::load_text(const std::string& name,
                                                              std::string text,
                                                              const IncludePath& include_path) {
  implementation_->note_loading(name, include_path);
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>(name, std::move(text));
  const SourceTree tree = load_agent(source, include_path, diagnostics);
  return implementation_->compiled(tree, std::move(diagnostics), {});
}

namespace {

// As the engine's readers have it.
IncludePath include_path_of(const ProgramFolders& folders) {
  IncludePath path;
  path.folders = folders.included;
  path.mapped = folders.mapped;
  for (const std::string& folder : folders.readable) path.files.allow_reading(folder);
  return path;
}

}  // namespace

Result<std::shared_ptr<const Program>> Interpreter::load_file(const std::string& path,
                                                              const ProgramFolders& folders) {
  return load_file(path, include_path_of(folders));
}

Result<std::shared_ptr<const Program>> Interpreter::load_text(const std::string& name,
                                                              std::string text,
                                                              const ProgramFolders& folders) {
  return load_text(name, std::move(text), include_path_of(folders));
}

AgentId Interpreter::add_agent(const std::string& name, std::shared_ptr<const Program> program) {
  return add_agent(name, std::move(program), AgentClass{});
}

AgentId Interpreter::add_agent(const std::string& name, std::shared_ptr<const Program> program,
                               AgentClass functions) {
  AgentSpec spec;
  spec.name = name;
  spec.program = program != nullptr ? std::move(program) : load_text(name, "").value();
  spec.customisation = customisation_of(std::move(functions));
  return mas().add_agent(spec);
}

RunOutcome Interpreter::run() {
  if (implementation_->is_at_work) return mas().outcome();
  const AtWork work(implementation_->is_at_work);
  return mas().run();
}

bool Interpreter::step() {
  if (implementation_->is_at_work) return false;
  const AtWork work(implementation_->is_at_work);
  return mas().step();
}

Mas& Interpreter::mas() { return *implementation_->mas; }
bool Interpreter::is_alive(AgentId agent) const { return implementation_->mas->is_alive(agent); }
const std::string& Interpreter::agent_name(AgentId agent) const {
  return implementation_->mas->agent_name(agent);
}
std::vector<std::string> Interpreter::beliefs(AgentId agent) const {
  return implementation_->mas->describe_beliefs(agent);
}
void Interpreter::each_belief(AgentId agent,
                              const std::function<void(Terms terms, Value belief)>& callback) {
  if (!implementation_->obstacle(agent).empty()) return;
  const AtWork work(implementation_->is_at_work);
  std::string problem;
  (void)mas().intervene(
      agent,
      [&](Agent& asked) {
        const Terms terms(asked.heap(), asked.symbols());
        mas().each_belief(agent, [&](Value belief) { callback(terms, belief); });
      },
      problem);
}
std::vector<std::string> Interpreter::intentions(AgentId agent) const {
  return implementation_->mas->describe_intentions(agent);
}
double Interpreter::now_ms() const { return implementation_->mas->now_ms(); }

std::string Interpreter::Implementation::obstacle(AgentId agent) const {
  if (is_at_work) return "the interpreter is at work: wait until it is done";
  if (mas->is_alive(agent)) return {};
  const bool was_there = static_cast<std::uint32_t>(agent) < mas->agent_count();
  return was_there ? "the agent is gone" : "there is no agent of that number";
}

Diagnostics Interpreter::ask(AgentId agent, const std::string& query,
                             const std::function<bool(const Answer&)>& answer) {
  return ask_terms(agent, query, [&](Terms terms, std::span<const BoundVariable> variables) {
    return answer(answer_of(terms, variables));
  });
}

Diagnostics Interpreter::ask_terms(AgentId agent, const std::string& query,
                                   const AnswerReader& answer) {
  QueryText text("query", query, parse_term);
  if (!text.is_good()) return std::move(text.diagnostics());
  std::string problem = implementation_->obstacle(agent);
  if (!problem.empty()) {
    text.error(std::move(problem));
    return std::move(text.diagnostics());
  }
  const AtWork work(implementation_->is_at_work);
  const bool completed = mas().intervene(
      agent,
      [&](Agent& asked) {
        std::vector<Value> variables;
        const Value formula = text.formula(asked, variables);
        if (!is_formula(formula)) {
          text.error("expected a formula, as in a plan's context");
          return;
        }
        const Terms terms(asked.heap(), asked.symbols());
        std::vector<BoundVariable> bound;
        asked.machine().solve_all_terms(formula, [&] {
          bound.clear();
          for (const Value variable : variables) {
            if (deref(variable).is_variable()) continue;
            bound.push_back({asked.symbols().text(variable.variable()->name()),
                             asked.machine().unifier().apply(variable)});
          }
          return answer(terms, bound);
        });
      },
      problem);
  if (!completed) text.error(std::move(problem));
  return std::move(text.diagnostics());
}

Result<std::vector<Answer>> Interpreter::ask(AgentId agent, const std::string& query,
                                             std::size_t most) {
  std::vector<Answer> answers;
  Diagnostics found = ask(agent, query, [&](const Answer& answer) {
    answers.push_back(answer);
    return most == 0 || answers.size() < most;
  });
  if (found.has_errors()) return found;
  return answers;
}

// Shared by all functions that give an agent a belief, goal or message.
Diagnostics Interpreter::Implementation::tell(
    AgentId agent, const std::string& name, const std::string& text,
    const std::function<void(Agent&, Value literal)>& what) {
  QueryText parsed(name, text, parse_literal);
  if (!parsed.is_good()) return std::move(parsed.diagnostics());
  std::string problem = obstacle(agent);
  if (!problem.empty()) {
    parsed.error(std::move(problem));
    return std::move(parsed.diagnostics());
  }
  const AtWork work(is_at_work);
  const bool completed = mas->intervene(
      agent,
      [&](Agent& told) {
        std::vector<Value> variables;
        const Value written = parsed.formula(told, variables);
        const Value literal = told.machine().unifier().apply(written);
        if (is_literal(literal)) {
          what(told, literal);
        } else {
          parsed.error("expected a literal, as in p(1)");
        }
      },
      problem);
  if (!completed) parsed.error(std::move(problem));
  return std::move(parsed.diagnostics());
}

Diagnostics Interpreter::believe(AgentId agent, const std::string& belief) {
  return implementation_->tell(agent, "belief", belief, [](Agent& told, Value literal) {
    told.add_belief(literal, Place::front, nullptr);
  });
}

Diagnostics Interpreter::forget(AgentId agent, const std::string& belief) {
  return implementation_->tell(agent, "belief", belief, [](Agent& told, Value literal) {
    told.remove_belief(literal, nullptr);
  });
}

Diagnostics Interpreter::achieve(AgentId agent, const std::string& goal) {
  return implementation_->tell(agent, "goal", goal, [](Agent& told, Value literal) {
    const LiteralParts parts = literal_parts(literal);
    if (!has_source(parts.annots)) {
      literal = with_annotations(
          told.heap(), literal, union_of(told.heap(), parts.annots, source_self(), told.symbols()));
    }
    told.add_goal(literal);
  });
}

Diagnostics Interpreter::include(AgentId agent, const std::string& name, std::string text) {
  Diagnostics found;
  std::string problem = implementation_->obstacle(agent);
  if (!problem.empty()) {
    found.error(name, problem);
    return found;
  }
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>(name, std::move(text));
  const SourceTree tree = load_agent(source, {}, diagnostics);
  auto program = implementation_->compiled(tree, std::move(diagnostics), {.fresh_names = true});
  if (!program) return std::move(program.diagnostics());
  const AtWork work(implementation_->is_at_work);
  const bool completed = mas().intervene(
      agent, [&](Agent& told) { (void)told.include(program.value(), problem); }, problem);
  if (!completed || !problem.empty()) found.error(name, problem);
  return found;
}

Diagnostics Interpreter::resume(AgentId agent, std::uint32_t intention) {
  Diagnostics found;
  std::string problem = implementation_->obstacle(agent);
  if (problem.empty()) {
    const AtWork work(implementation_->is_at_work);
    const bool completed = mas().intervene(
        agent,
        [&](Agent& resumed) {
          const auto& all = resumed.circumstance().intentions;
          const auto waiting = std::ranges::find_if(all, [&](const auto& each) {
            return each->id == intention && each->state == Intention::State::waiting;
          });
          if (waiting == all.end()) {
            problem = "no intention of that number waits";
          } else {
            resumed.resume(**waiting);
          }
        },
        problem);
    if (completed && problem.empty()) return found;
  }
  found.error("resume", std::move(problem));
  return found;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// Agents from Python: the interpreter, internal actions as functions, worlds as classes.

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "interpreter/mas/mas.h"
#include "interpreter/syntax/load.h"
#include "interpreter/term/heap.h"
#include "interpreter/term/symbol.h"
#include "python/module/values.h"
#include "tools/jaywalk/programs/program_check.h"
#include <jaywalk/interpreter.h>

namespace jaywalk::python {
namespace {

/// Exceptions of functions and worlds fail the action. KeyboardInterrupt, SystemExit and their like
/// end the run.
std::string failure_text(py::error_already_set& error, const std::string& where, Thrown& thrown) {
  if (!error.matches(PyExc_Exception)) {
    thrown.keep_current();
    return "interrupted";
  }
  return report(where, error);
}

class World;
class PyInterpreter;

/// Its numbers of names are those of one interpreter.
struct LoadedProgram {
  std::shared_ptr<const Program> program;
  const PyInterpreter* owner = nullptr;
};

class PyInterpreter {
 public:
  PyInterpreter(std::uint64_t seed, const py::object& print, const py::object& log,
                const py::object& world, std::uint64_t max_cycles, bool realtime);

  void add_action(const std::string& name, int args, const py::function& body, bool has_result);
  void add_arithmetic(const std::string& name, int args, const py::function& body);
  LoadedProgram load(const std::string& name, const std::optional<std::string>& text,
                     const std::vector<std::string>& include);
  std::uint32_t add_agent(const std::string& name, const LoadedProgram& program) {
    const Use use(*this);
    if (program.owner != this) throw py::value_error("another interpreter has loaded the program");
    return static_cast<std::uint32_t>(interpreter_->add_agent(name, program.program));
  }

  py::dict run();
  bool step();

  py::list ask(AgentId agent, const std::string& query, std::size_t most);
  py::list beliefs(AgentId agent);
  void believe(AgentId agent, const std::string& text) {
    check(*this, &Interpreter::believe, agent, text);
  }
  void forget(AgentId agent, const std::string& text) {
    check(*this, &Interpreter::forget, agent, text);
  }
  void achieve(AgentId agent, const std::string& text) {
    check(*this, &Interpreter::achieve, agent, text);
  }
  void include(AgentId agent, const std::string& name, const std::string& text);

  [[nodiscard]] std::vector<std::string> intentions(AgentId agent) {
    const Use use(*this);
    return interpreter_->intentions(agent);
  }
  [[nodiscard]] bool is_alive(AgentId agent) {
    const Use use(*this);
    return interpreter_->is_alive(agent);
  }
  [[nodiscard]] const std::string& agent_name(AgentId agent) {
    const Use use(*this);
    return interpreter_->agent_name(agent);
  }
  [[nodiscard]] double now_ms() {
    const Use use(*this);
    return interpreter_->now_ms();
  }

  Thrown& thrown() { return thrown_; }
  [[nodiscard]] SymbolTable& symbols() { return interpreter_->mas().symbols(); }

 private:
  /// One thread at a time: another one gets RuntimeError. Calls of the thread itself from a
  /// function that it runs are for the interpreter to answer.
  class Use {
   public:
    explicit Use(PyInterpreter& used) : used_(used), is_outer_(used.user_ == std::thread::id()) {
      if (is_outer_) {
        used.user_ = std::this_thread::get_id();
      } else if (used.user_ != std::this_thread::get_id()) {
        throw std::runtime_error("another thread is using this interpreter");
      }
    }
    ~Use() {
      if (is_outer_) used_.user_ = std::thread::id();
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    PyInterpreter& used_;
    bool is_outer_;
  };

  static void check(PyInterpreter& self,
                    Diagnostics (Interpreter::*function)(AgentId, const std::string&),
                    AgentId agent, const std::string& text);
  Outcome call(Call& call, const std::string& name, bool has_result, const py::function& body);

  Thrown thrown_;
  std::thread::id user_;  // changed with Python's lock held
  std::vector<py::function> functions_;
  std::unique_ptr<Interpreter> interpreter_;
};

const py::object& pending_class() {
  static const auto* const found =
      new py::object(py::module_::import("jaywalk.agents").attr("Pending"));
  return *found;
}

/// A world that is a Python object (jaywalk.Environment).
class World final : public Environment {
 public:
  World(PyInterpreter& interpreter, py::object self)
      : interpreter_(interpreter),
        self_(std::move(self)),
        tick_ms_(self_.attr("tick_ms").cast<double>()) {
    if (!(tick_ms_ > 0 && std::isfinite(tick_ms_))) {
      throw py::value_error("tick_ms: expected a number of milliseconds above 0, found " +
                            py::repr(self_.attr("tick_ms")).cast<std::string>());
    }
  }

  [[nodiscard]] bool is_unchanged(AgentId agent) const override {
    Look& look = looks_[agent];
    look.is_due = ask(agent, look);
    return !look.is_due;
  }
  void perceive(AgentId agent, Percepts& percepts) const override {
    Look& look = looks_[agent];
    if (!std::exchange(look.is_due, false)) (void)ask(agent, look);
    for (const GroundLiteral& each : look.percepts) add_percept(percepts, each);
  }

  void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) override {
    const py::gil_scoped_acquire acquire;
    for (std::size_t i = 0; i < actions.size(); ++i) {
      const std::string& agent = interpreter_.agent_name(actions[i].agent);
      try {
        const py::object done = self_.attr("act")(agent, action(actions[i]));
        results[i].is_pending = py::isinstance(done, pending_class());
        if (results[i].is_pending) slow_.emplace_back(actions[i].number, done);
        results[i].succeeded = done.is_none() || py::bool_(done);
      } catch (py::error_already_set& error) {
        results[i] = {
            .succeeded = false,
            .reason = failure_text(error, "act() of the environment", interpreter_.thrown())};
      }
    }
  }
  void take_results(const ResultReceiver& deliver) override {
    if (slow_.empty()) return;
    const py::gil_scoped_acquire acquire;
    std::erase_if(slow_, [&](const auto& each) {
      const py::object result = each.second.attr("_result");
      if (result.is_none()) return false;
      const auto [succeeded, reason] = result.template cast<std::pair<bool, std::string>>();
      deliver(each.first, {.succeeded = succeeded, .reason = reason});
      return true;
    });
  }

  void advance() override {
    const py::gil_scoped_acquire acquire;
    try {
      self_.attr("advance")();
    } catch (py::error_already_set&) {
      interpreter_.thrown().keep_current();
    }
  }
  [[nodiscard]] bool finished() const override {
    const py::gil_scoped_acquire acquire;
    try {
      return bool(py::bool_(self_.attr("finished")()));
    } catch (py::error_already_set&) {
      interpreter_.thrown().keep_current();
      return true;
    }
  }
  [[nodiscard]] double tick_ms() const override { return tick_ms_; }

 private:
  struct Look {
    std::vector<GroundLiteral> percepts;
    std::vector<GroundLiteral> before;  // until the agent has looked again
    bool is_due = false;                // percepts() has returned these for the look that follows
  };

  /// Asks for the agent's percepts. False: they are unchanged, or the answer was an error.
  bool ask(AgentId agent, Look& look) const {
    const py::gil_scoped_acquire acquire;
    try {
      const py::object told = self_.attr("percepts")(interpreter_.agent_name(agent));
      if (told.is_none()) return false;
      std::vector<GroundLiteral> percepts = read(told);
      look.before = std::exchange(look.percepts, std::move(percepts));
      return true;
    } catch (py::error_already_set&) {
      interpreter_.thrown().keep_current();
    } catch (py::builtin_exception&) {
      interpreter_.thrown().keep_current();
    }
    return false;
  }

  [[nodiscard]] std::vector<GroundLiteral> read(const py::object& told) const {
    std::vector<GroundLiteral> percepts;
    for (const py::handle each : told) {
      const py::object literal = as_literal(each);
      percepts.emplace_back(interpreter_.symbols(), [&](Terms terms) {
        const Value value = from_python(terms, literal);
        if (value.is_closed()) return value;
        throw py::type_error("a percept has no variables, found " +
                             py::repr(literal).cast<std::string>());
      });
    }
    return percepts;
  }

  /// The action as jaywalk.Structure.
  [[nodiscard]] py::object action(const ActionRequest& request) const {
    const Terms terms(heap_, interpreter_.symbols());
    py::tuple args(request.args.size());
    for (std::size_t i = 0; i < request.args.size(); ++i) {
      args[i] = to_python(terms, request.args[i]);
    }
    return structure_class()(std::string(interpreter_.symbols().functor(request.predicate)), args);
  }

  PyInterpreter& interpreter_;
  py::object self_;
  double tick_ms_;
  mutable Heap heap_;  // to read actions with
  mutable std::map<AgentId, Look> looks_;
  std::vector<std::pair<std::uint64_t, py::object>> slow_;  // actions that go on, by their numbers
};

PyInterpreter::PyInterpreter(std::uint64_t seed, const py::object& print, const py::object& log,
                             const py::object& world, std::uint64_t max_cycles, bool realtime) {
  MasOptions options;
  options.seed = seed;
  options.max_cycles = max_cycles;
  options.realtime = realtime;
  options.print = line_printer(print, thrown_);
  options.log = line_printer(log, thrown_);
  options.interrupted = [this] { return thrown_.is_interrupted(); };
  Interpreter::EnvironmentMaker make_world;
  if (!world.is_none()) {
    make_world = [&](SymbolTable&) { return std::make_unique<World>(*this, world); };
  }
  interpreter_ = std::make_unique<Interpreter>(std::move(options), make_world);
}

Outcome PyInterpreter::call(Call& call, const std::string& name, bool has_result,
                            const py::function& body) {
  const py::gil_scoped_acquire acquire;
  const std::size_t inputs = call.count() - (has_result ? 1 : 0);
  try {
    py::tuple args(inputs);
    for (std::size_t i = 0; i < inputs; ++i) args[i] = to_python(call.terms(), call.arg(i));
    const py::object found = body(*args);
    if (!has_result) {
      return found.is_none() || py::bool_(found) ? Outcome::succeeded : Outcome::failed;
    }
    if (!PyIter_Check(found.ptr())) {
      return call.result(inputs, from_python(call.terms(), found));
    }
    return call.each([this, name, inputs, answers = shared(found)](Call& again) {
      const py::gil_scoped_acquire acquire_again;
      try {
        while (PyObject* const next = PyIter_Next(answers->ptr())) {
          const auto answer = py::reinterpret_steal<py::object>(next);
          if (again.unify(inputs, from_python(again.terms(), answer))) return true;
        }
        if (PyErr_Occurred() != nullptr) throw py::error_already_set();
      } catch (py::error_already_set& error) {
        (void)failure_text(error, name, thrown_);
      } catch (py::builtin_exception& error) {
        (void)term_part("report_exception")(name, py::str(error.what()));
      }
      return false;
    });
  } catch (py::error_already_set& error) {
    const py::object wrong = term_part("WrongArgument");
    if (error.matches(wrong)) {
      return call.wrong_argument(error.value().attr("index").cast<std::size_t>(),
                                 error.value().attr("expected").cast<std::string>());
    }
    return call.fail("python_error", failure_text(error, name, thrown_));
  } catch (py::builtin_exception& error) {
    return call.fail("python_error", name + ": " + error.what());
  }
}

void PyInterpreter::add_action(const std::string& name, int args, const py::function& body,
                               bool has_result) {
  functions_.push_back(body);
  const std::size_t index = functions_.size() - 1;
  interpreter_->add_action(name, args, args, [this, name, has_result, index](Call& call) {
    return this->call(call, name, has_result, functions_[index]);
  });
}

void PyInterpreter::add_arithmetic(const std::string& name, int args, const py::function& body) {
  functions_.push_back(body);
  const std::size_t index = functions_.size() - 1;
  const auto evaluate = [this, name, index](std::span<const Value> given, Heap& heap,
                                            SymbolTable& symbols, Value& result) {
    const py::gil_scoped_acquire acquire;
    const Terms terms(heap, symbols);
    try {
      py::tuple values(given.size());
      for (std::size_t i = 0; i < given.size(); ++i) values[i] = to_python(terms, given[i]);
      const Value found = from_python(terms, functions_[index](*values));
      if (!found.is_number()) throw py::type_error("expected a number as its result");
      result = found;
      return true;
    } catch (py::error_already_set& error) {
      (void)failure_text(error, name, thrown_);
    } catch (py::builtin_exception& error) {
      (void)term_part("report_exception")(name, py::str(error.what()));
    }
    return false;
  };
  interpreter_->add_function({.name = name,
                              .least_args = args,
                              .most_args = args,
                              .signature = name + "(...)",
                              .summary = {},
                              .own = evaluate});
}

LoadedProgram PyInterpreter::load(const std::string& name, const std::optional<std::string>& text,
                                  const std::vector<std::string>& include) {
  const Use use(*this);
  ProgramFolders folders;
  folders.included = include;
  return {value_of(text ? interpreter_->load_text(name, *text, folders)
                        : interpreter_->load_file(name, folders)),
          this};
}

py::dict PyInterpreter::run() {
  const Use use(*this);
  RunOutcome outcome;
  {
    const py::gil_scoped_release release;
    outcome = interpreter_->run();
  }
  thrown_.rethrow();
  constexpr std::array kEnds{"stopped", "idle", "finished", "limit", "looping", "interrupted"};
  py::dict said;
  said["end"] = kEnds[static_cast<std::size_t>(outcome.end)];
  said["ticks"] = outcome.ticks;
  said["cycles"] = outcome.cycles;
  said["inferences"] = outcome.inferences;
  said["exit_code"] = outcome.exit_code;
  said["message"] = outcome.message;
  return said;
}

bool PyInterpreter::step() {
  const Use use(*this);
  bool goes_on = false;
  {
    const py::gil_scoped_release release;
    goes_on = interpreter_->step();
  }
  thrown_.rethrow();
  return goes_on;
}

py::list PyInterpreter::ask(AgentId agent, const std::string& query, std::size_t most) {
  const Use use(*this);
  py::list answers;
  const Diagnostics found = interpreter_->ask_terms(
      agent, query, [&](Terms terms, std::span<const Interpreter::BoundVariable> variables) {
        // No exception may pass through the interpreter.
        try {
          py::dict answer;
          for (const auto& [name, value] : variables) {
            answer[py::str(std::string(name))] = to_python(terms, value);
          }
          answers.append(answer);
        } catch (py::error_already_set&) {
          thrown_.keep_current();
        }
        return !thrown_.is_there() && (most == 0 || answers.size() < most);
      });
  thrown_.rethrow();
  if (found.has_errors()) raise(found);
  return answers;
}

py::list PyInterpreter::beliefs(AgentId agent) {
  const Use use(*this);
  py::list beliefs;
  interpreter_->each_belief(agent, [&](Terms terms, Value belief) {
    try {
      if (!thrown_.is_there()) beliefs.append(to_python(terms, belief));
    } catch (py::error_already_set&) {
      thrown_.keep_current();
    }
  });
  thrown_.rethrow();
  return beliefs;
}

void PyInterpreter::check(PyInterpreter& self,
                          Diagnostics (Interpreter::*function)(AgentId, const std::string&),
                          AgentId agent, const std::string& text) {
  const Use use(self);
  const Diagnostics found = (*self.interpreter_.*function)(agent, text);
  self.thrown_.rethrow();
  if (found.has_errors()) raise(found);
}

void PyInterpreter::include(AgentId agent, const std::string& name, const std::string& text) {
  const Use use(*this);
  const Diagnostics found = interpreter_->include(agent, name, text);
  thrown_.rethrow();
  if (found.has_errors()) raise(found);
}

/// As `jaywalk check` does it.
py::list check_program(const std::string& name, const std::string& text,
                       const std::vector<std::string>& include) {
  Diagnostics found;
  IncludePath path;
  path.folders = include;
  const auto source = std::make_shared<const Source>(name, text);
  const SourceTree tree = load_agent(source, path, found);
  check_alone(tree, name, found);
  return to_python(found);
}

}  // namespace

void add_agents(py::module_& module) {
  py::class_<LoadedProgram>(module, "Program", "A program that an interpreter has loaded.");
  py::class_<PyInterpreter>(module, "Interpreter")
      .def(py::init<std::uint64_t, py::object, py::object, py::object, std::uint64_t, bool>())
      .def("add_action", &PyInterpreter::add_action)
      .def("add_arithmetic", &PyInterpreter::add_arithmetic)
      .def("load", &PyInterpreter::load, py::keep_alive<0, 1>())
      .def("add_agent", &PyInterpreter::add_agent)
      .def("run", &PyInterpreter::run)
      .def("step", &PyInterpreter::step)
      .def("ask", [](PyInterpreter& self, std::uint32_t agent, const std::string& query,
                     std::size_t most) { return self.ask(AgentId{agent}, query, most); })
      .def("believe", [](PyInterpreter& self, std::uint32_t agent,
                         const std::string& text) { self.believe(AgentId{agent}, text); })
      .def("forget", [](PyInterpreter& self, std::uint32_t agent,
                        const std::string& text) { self.forget(AgentId{agent}, text); })
      .def("achieve", [](PyInterpreter& self, std::uint32_t agent,
                         const std::string& text) { self.achieve(AgentId{agent}, text); })
      .def("include", [](PyInterpreter& self, std::uint32_t agent, const std::string& name,
                         const std::string& text) { self.include(AgentId{agent}, name, text); })
      .def("beliefs",
           [](PyInterpreter& self, std::uint32_t agent) { return self.beliefs(AgentId{agent}); })
      .def("intentions",
           [](PyInterpreter& self, std::uint32_t agent) { return self.intentions(AgentId{agent}); })
      .def("is_alive",
           [](PyInterpreter& self, std::uint32_t agent) { return self.is_alive(AgentId{agent}); })
      .def("agent_name",
           [](PyInterpreter& self, std::uint32_t agent) { return self.agent_name(AgentId{agent}); })
      .def("now_ms", &PyInterpreter::now_ms);
  module.def("check_program", &check_program);
}

}  // namespace jaywalk::python

// SPDX-License-Identifier: Apache-2.0
#include "python/module/values.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace jaywalk::python {
namespace {

/// Python's own limit of nesting: RecursionError instead of an overflowing stack.
class Nesting {
 public:
  Nesting() {
    if (Py_EnterRecursiveCall(" in a term") != 0) throw py::error_already_set();
  }
  ~Nesting() { Py_LeaveRecursiveCall(); }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;
};

py::object number_to_python(double number) {
  constexpr double kExact = 9007199254740992;  // 2^53
  if (std::floor(number) == number && std::fabs(number) <= kExact) {
    return py::int_(static_cast<std::int64_t>(number));
  }
  return py::float_(number);
}

py::list list_to_python(Terms terms, const std::vector<Value>& values) {
  py::list list(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) list[i] = to_python(terms, values[i]);
  return list;
}

std::vector<Value> values_from_python(Terms terms, py::handle sequence) {
  std::vector<Value> values;
  for (const py::handle each : sequence) values.push_back(from_python(terms, each));
  return values;
}

std::string literal_name(Terms terms, Value value) {
  return (terms.is_negated(value) ? "~" : "") + std::string(terms.functor(value));
}

}  // namespace

// The classes are looked up once; they live as long as Python does.
const py::object& atom_class() {
  static const auto* const found = new py::object(term_part("Atom"));
  return *found;
}

const py::object& structure_class() {
  static const auto* const found = new py::object(term_part("Structure"));
  return *found;
}

py::object as_literal(py::handle value) {
  static const auto* const found = new py::object(term_part("as_literal"));
  return (*found)(value);
}

py::object term_part(const char* name) { return py::module_::import("jaywalk.terms").attr(name); }

py::object to_python(Terms terms, Value term) {
  const Nesting nesting;
  const Value value = terms.value(term);
  if (value.is_number()) return number_to_python(value.as_number());
  if (value.is_text()) return py::str(std::string(terms.text(value)));
  if (value.is_list()) return list_to_python(terms, terms.elements(value));
  if (value.is_variable() || value.is_unset()) return py::none();
  if (!terms.is_literal(value)) return py::str(terms.printed(value));
  const std::string name = literal_name(terms, value);
  if (value.is_atom() && !terms.is_negated(value)) return atom_class()(name);
  return structure_class()(name, py::tuple(list_to_python(terms, terms.args(value))),
                           py::tuple(list_to_python(terms, terms.annotations(value))));
}

Value from_python(Terms terms, py::handle value) {
  const Nesting nesting;
  if (value.is_none()) return terms.variable();
  if (PyBool_Check(value.ptr())) return terms.atom(value.ptr() == Py_True ? "true" : "false");
  if (PyUnicode_Check(value.ptr())) return terms.string(value.cast<std::string>());
  if (py::isinstance(value, atom_class())) {
    return terms.atom(value.attr("name").cast<std::string>());
  }
  if (py::isinstance(value, structure_class())) {
    return terms.structure(value.attr("functor").cast<std::string>(),
                           values_from_python(terms, value.attr("args")),
                           values_from_python(terms, value.attr("annotations")));
  }
  if (PyList_Check(value.ptr()) || PyTuple_Check(value.ptr())) {
    return terms.list(values_from_python(terms, value));
  }
  // Numbers, those of numpy too.
  const double number = PyFloat_AsDouble(value.ptr());
  if (number == -1 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw py::type_error("expected a number, str, Atom, Structure, list or None, found " +
                         py::repr(value).cast<std::string>());
  }
  return Value::number(number);
}

py::list to_python(const Diagnostics& diagnostics) {
  const py::object diagnostic = term_part("Diagnostic");
  py::list list;
  for (const Diagnostic& each : diagnostics.items()) {
    py::object line = py::none();
    py::object column = py::none();
    std::string file = each.subject;
    if (each.where.source) {
      const Source::Position at = each.where.source->position(each.where.span.begin);
      line = py::int_(at.line);
      column = py::int_(at.column);
      file = each.where.source->name();
    }
    const char* const severity = each.severity == Severity::error     ? "error"
                                 : each.severity == Severity::warning ? "warning"
                                                                      : "note";
    list.append(
        diagnostic(severity, each.message, file, line, column, each.hint, each.code, render(each)));
  }
  return list;
}

std::string report(const std::string& where, const py::error_already_set& error) {
  if (error.trace()) PyException_SetTraceback(error.value().ptr(), error.trace().ptr());
  return term_part("report_exception")(where, error.value()).cast<std::string>();
}

void raise(const Diagnostics& diagnostics) {
  const py::object error = term_part("Error");
  PyErr_SetObject(error.ptr(), error(to_python(diagnostics)).ptr());
  throw py::error_already_set();
}

void Thrown::keep(std::exception_ptr exception) {
  const py::gil_scoped_acquire acquire;
  if (!first_) first_ = std::move(exception);
  is_there_ = true;
}

bool Thrown::is_interrupted() {
  constexpr std::uint64_t kBetweenSignals = 64;
  if (!is_there_ && asked_++ % kBetweenSignals == 0) {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) keep(std::make_exception_ptr(py::error_already_set()));
  }
  return is_there_;
}

void Thrown::rethrow() {
  is_there_ = false;
  if (first_) std::rethrow_exception(std::exchange(first_, nullptr));
}

std::function<void(std::string_view line)> line_printer(const py::object& print, Thrown& thrown) {
  if (print.is_none()) return {};
  return [kept = shared(print), &thrown](std::string_view line) {
    const py::gil_scoped_acquire acquire;
    try {
      (*kept)(py::str(line.data(), line.size()));
    } catch (py::error_already_set&) {
      thrown.keep_current();
    }
  };
}

void wait_for(const std::function<void()>& work, const std::function<void()>& progress,
              Thrown& thrown) {
  std::mutex mutex;
  std::condition_variable changed;
  bool is_done = false;
  std::thread worker([&] {
    try {
      work();
    } catch (...) {
      thrown.keep_current();
    }
    const std::lock_guard lock(mutex);
    is_done = true;
    changed.notify_all();
  });
  for (bool is_waiting = true; is_waiting;) {
    {
      const py::gil_scoped_release release;
      std::unique_lock lock(mutex);
      is_waiting = !changed.wait_for(lock, std::chrono::milliseconds(100), [&] { return is_done; });
    }
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (progress) progress();
    } catch (...) {
      thrown.keep_current();
    }
  }
  {
    const py::gil_scoped_release release;
    worker.join();
  }
  thrown.rethrow();
}

}  // namespace jaywalk::python

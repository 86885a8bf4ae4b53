// SPDX-License-Identifier: Apache-2.0
#pragma once

// Terms of the language as Python values, and what the parts of the module have in common.
//
//   number       int if it is whole, else float       (True and False become the atoms)
//   string       str
//   atom         jaywalk.Atom
//   structure    jaywalk.Structure
//   list         list
//   unbound variable, to Python and back: None

#include <atomic>
#include <functional>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <utility>

#include <jaywalk/diagnostics.h>
#include <jaywalk/value.h>

namespace jaywalk::python {

namespace py = pybind11;

[[nodiscard]] py::object to_python(Terms terms, Value value);
/// Throws TypeError for values that are none of the above.
[[nodiscard]] Value from_python(Terms terms, py::handle value);

/// jaywalk.Atom and jaywalk.Structure.
[[nodiscard]] const py::object& atom_class();
[[nodiscard]] const py::object& structure_class();
/// Anything else of the package's Python part.
[[nodiscard]] py::object python_class(const char* name);

/// Shows an exception with its traceback, each kind at each place once; returns it in one line.
[[nodiscard]] std::string report(const std::string& where, const py::error_already_set& error);

/// A list of jaywalk.Diagnostic.
[[nodiscard]] py::list to_python(const Diagnostics& diagnostics);
/// Throws jaywalk.Error with these.
[[noreturn]] void raise(const Diagnostics& diagnostics);

template <class T>
T value_of(Result<T> result) {
  if (!result) raise(result.diagnostics());
  return std::move(result).value();
}

/// Runs `work` on a thread of its own while this one, which holds Python's lock, waits: Ctrl-C is
/// heard, and `progress` is called about ten times a second. Both may end the work: `is_ended` is
/// set then, and what they have thrown is thrown again once the work has returned.
void wait_for(const std::function<void()>& work, const std::function<void()>& progress,
              std::atomic<bool>& is_ended);

// The parts of the module.
void add_agents(py::module_& module);
void add_bench(py::module_& module);
void add_search(py::module_& module);

}  // namespace jaywalk::python

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
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <string_view>
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
/// Anything else of jaywalk.terms.
[[nodiscard]] py::object term_part(const char* name);
/// An Atom, Structure or text as a Structure; throws if it is none.
[[nodiscard]] py::object as_literal(py::handle value);

/// A Python object that is kept, and let go, on threads that do not hold Python's lock.
template <class Object>
std::shared_ptr<Object> shared(Object object) {
  return {new Object(std::move(object)), [](const Object* kept) {
            const py::gil_scoped_acquire acquire;
            delete kept;
          }};
}

/// The first exception thrown while the libraries were at work. None may pass through them: the
/// work ends, and its caller gets it.
class Thrown {
 public:
  void keep(std::exception_ptr exception);
  /// REQUIRES: within a catch clause.
  void keep_current() { keep(std::current_exception()); }
  [[nodiscard]] bool is_there() const { return is_there_; }
  /// Listens for Ctrl-C now and then, and says whether there is one. REQUIRES: one thread calls it.
  [[nodiscard]] bool is_interrupted();
  /// Throws it, if there is something; then there is nothing. REQUIRES: the work has ended.
  void rethrow();

 private:
  std::exception_ptr first_;  // changed with Python's lock held
  std::atomic<bool> is_there_ = false;
  std::uint64_t asked_ = 0;
};

/// A function for what agents print; empty for None.
[[nodiscard]] std::function<void(std::string_view line)> line_printer(const py::object& print,
                                                                      Thrown& thrown);

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
/// heard, and `progress` is called about ten times a second. What they or `work` throw is kept in
/// `thrown`, by which the work has to see that it ends, and thrown again once it has ended.
void wait_for(const std::function<void()>& work, const std::function<void()>& progress,
              Thrown& thrown);

// The parts of the module.
void add_agents(py::module_& module);
void add_bench(py::module_& module);
void add_search(py::module_& module);

}  // namespace jaywalk::python

// SPDX-License-Identifier: Apache-2.0
// Search from Python: any function of a vector, and generators as classes.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "python/module/values.h"
#include <jaywalk/search.h>

namespace jaywalk::python {
namespace {

using search::RunnableSearch;

py::tuple to_tuple(std::span<const double> values) {
  py::tuple tuple(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) tuple[i] = values[i];
  return tuple;
}

/// `function(input)` returns a number. An exception errs the test; KeyboardInterrupt, SystemExit
/// and their like end the search.
class FunctionExecutor final : public search::SystemExecutor {
 public:
  FunctionExecutor(std::shared_ptr<py::object> function, Thrown& thrown)
      : function_(std::move(function)), thrown_(thrown) {}

  search::SystemOutcome run(std::span<const double> input, std::size_t /*test*/) override {
    const py::gil_scoped_acquire acquire;
    search::SystemOutcome outcome;
    try {
      outcome.measures = {(*function_)(to_tuple(input)).cast<double>()};
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_Exception)) thrown_.keep_current();
      outcome.error = thrown_.is_there() ? "interrupted" : report("the system", error);
    } catch (py::cast_error&) {
      outcome.error = "the system returns no number";
    }
    return outcome;
  }

 private:
  std::shared_ptr<py::object> function_;
  Thrown& thrown_;
};

/// A Python object with ask(is_valid, spent) and tell(input, fitness, has_failed).
class PyGenerator final : public search::InputGenerator {
 public:
  PyGenerator(std::shared_ptr<py::object> self, Thrown& thrown)
      : self_(std::move(self)), thrown_(thrown) {}

  std::vector<double> ask(const std::function<bool(std::span<const double>)>& is_valid,
                          double spent) override {
    const py::gil_scoped_acquire acquire;
    if (thrown_.is_there()) return {};
    try {
      const py::cpp_function valid(
          [&](const std::vector<double>& input) { return is_valid(input); });
      const py::object input = self_->attr("ask")(valid, spent);
      if (py::isinstance<py::sequence>(input) || py::hasattr(input, "__array__")) {
        return input.cast<std::vector<double>>();
      }
      throw py::type_error("ask() returns no list of numbers");
    } catch (py::error_already_set&) {
      thrown_.keep_current();
    } catch (py::type_error&) {
      thrown_.keep_current();
    } catch (py::cast_error&) {
      thrown_.keep(std::make_exception_ptr(py::type_error("ask() returns no list of numbers")));
    }
    return {};
  }
  void tell(std::span<const double> input, double fitness, bool has_failed) override {
    const py::gil_scoped_acquire acquire;
    if (thrown_.is_there()) return;
    try {
      self_->attr("tell")(to_tuple(input), fitness, has_failed);
    } catch (py::error_already_set&) {
      thrown_.keep_current();
    }
  }

 private:
  std::shared_ptr<py::object> self_;
  Thrown& thrown_;
};

py::list to_python(const search::SearchReport& report, const std::vector<std::string>& measures) {
  py::list rows;
  for (const search::SearchRunReport& run : report.runs) {
    std::uint64_t number = 0;
    for (const search::FoundTest& test : run.tests) {
      py::dict row;
      row["generator"] = run.generator;
      row["repetition"] = run.repetition;
      row["test"] = number++;
      row["input"] = to_tuple(test.input);
      row["points"] = to_tuple(test.points);
      row["fitness"] = test.fitness;
      row["failed"] = test.has_failed;
      row["error"] = test.error;
      row["refused"] = test.refused;
      for (std::size_t i = 0; i < measures.size(); ++i) {
        row[py::str(measures[i])] =
            i < test.measures.size() ? py::object(py::float_(test.measures[i])) : py::none();
      }
      row["simulated_s"] = test.simulated_s;
      rows.append(row);
    }
  }
  return rows;
}

py::dict run_search(const RunnableSearch& search, const std::optional<std::uint64_t>& seed,
                    const std::optional<std::uint32_t>& repetitions, unsigned threads,
                    const std::string& store, bool resume, const py::object& progress,
                    Thrown& thrown) {
  std::atomic<std::uint64_t> tests = 0;
  std::atomic<std::uint64_t> failures = 0;
  const search::SearchRunOptions options{.seed = seed,
                                         .repetitions = repetitions,
                                         .threads = threads,
                                         .store = store,
                                         .resume = resume,
                                         .progress = [&](const search::SearchProgressNow& now) {
                                           tests = now.tests;
                                           failures = now.failures;
                                           return !thrown.is_there();
                                         }};
  std::optional<Result<search::SearchReport>> report;
  wait_for([&] { report.emplace(search.run(options)); },
           [&] {
             if (!progress.is_none()) progress(tests.load(), failures.load());
           },
           thrown);
  const search::SearchReport found = value_of(*std::move(report));
  if (found.trouble.has_errors()) raise(found.trouble);
  py::dict said;
  said["rows"] = to_python(found, search.measures());
  said["is_complete"] = found.is_complete;
  return said;
}

py::dict search_file(const std::string& name, const std::optional<std::string>& text,
                     const std::vector<std::string>& sets,
                     const std::vector<std::string>& generators, const std::string& data_folder,
                     const std::optional<std::uint64_t>& seed,
                     const std::optional<std::uint32_t>& repetitions, unsigned threads,
                     const std::string& store, bool resume, const py::object& progress) {
  search::SearchChoice choice;
  choice.sets = sets;
  choice.generators = generators;
  choice.data_folder = data_folder;
  const RunnableSearch found = value_of(text ? RunnableSearch::parse(name, *text, choice)
                                             : RunnableSearch::read(name, choice));
  Thrown thrown;
  return run_search(found, seed, repetitions, threads, store, resume, progress, thrown);
}

/// `generators`: names, and tuples (name, make) where make(dimension, seed) makes one.
py::dict search_function(const py::object& function, const py::object& why_invalid,
                         std::size_t dimension, double harmless, double worst, double fails_at,
                         const py::list& generators, std::uint64_t tests, std::uint64_t seed,
                         std::uint32_t repetitions, unsigned threads, const py::object& progress) {
  Thrown thrown;
  search::SearchDescription description;
  description.name = "search";
  description.measure = "value";
  description.harmless = harmless;
  description.worst = worst;
  description.fails_at = fails_at;
  description.tests = tests;
  description.virtual_s = 0;
  description.overhead_s = 0;
  search::SystemUnderTest& system = description.system;
  system.name = "function";
  system.dimension = dimension;
  system.measures = {"value"};
  system.make_executor = [kept = shared(function), &thrown] {
    return std::make_unique<FunctionExecutor>(kept, thrown);
  };
  if (!why_invalid.is_none()) {
    system.why_invalid = [kept = shared(why_invalid), &thrown](std::span<const double> input) {
      const py::gil_scoped_acquire acquire;
      try {
        const py::object why = (*kept)(to_tuple(input));
        return why.is_none() ? std::string() : why.cast<std::string>();
      } catch (py::error_already_set&) {
        thrown.keep_current();
      } catch (py::cast_error&) {
        thrown.keep_current();
      }
      return std::string("the function that says what is invalid failed");
    };
  }
  for (const py::handle each : generators) {
    if (PyUnicode_Check(each.ptr())) {
      description.generators.push_back(each.cast<std::string>());
      continue;
    }
    const auto [name, make] = each.cast<std::pair<std::string, py::object>>();
    description.custom_generators.push_back(
        {.name = name,
         .make = [kept = shared(make), &thrown](std::size_t size, std::uint64_t own_seed) {
           const py::gil_scoped_acquire acquire;
           py::object made;
           try {
             made = (*kept)(size, own_seed);
           } catch (py::error_already_set&) {
             thrown.keep_current();
           }
           return std::make_unique<PyGenerator>(shared(made), thrown);
         }});
  }
  const RunnableSearch found = value_of(RunnableSearch::make(description));
  return run_search(found, seed, repetitions, threads, "", false, progress, thrown);
}

}  // namespace

void add_search(py::module_& module) {
  module.def("search_file", &search_file);
  module.def("search_function", &search_function);
  module.def("generators", [] {
    py::dict generators;
    for (const search::GeneratorInfo& each : search::generator_list()) {
      generators[py::str(std::string(each.name))] = std::string(each.summary);
    }
    return generators;
  });
}

}  // namespace jaywalk::python

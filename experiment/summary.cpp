#include "experiment/summary.h"

#include <vector>

namespace jaywalk {
namespace {

enum class Which { all, successful };

template <class Value>
Sample sample_of(std::span<const TestResult> tests, Which which, Value value) {
  std::vector<double> values;
  values.reserve(tests.size());
  for (const TestResult& test : tests) {
    if (which == Which::all || test.succeeded) values.push_back(static_cast<double>(value(test)));
  }
  return summarise(values);
}

}  // namespace

Summary summarise(std::span<const TestResult> tests) {
  const auto score = [](const TestResult& test) { return test.score; };
  const auto ticks = [](const TestResult& test) { return test.ticks; };
  Summary summary;
  summary.tests = tests.size();
  summary.score = sample_of(tests, Which::successful, score);
  summary.successes = summary.score.count;
  summary.ticks_success = sample_of(tests, Which::successful, ticks);
  summary.ticks_all = sample_of(tests, Which::all, ticks);
  summary.cpu_us = sample_of(tests, Which::all, [](const TestResult& test) { return test.cpu_us; });
  summary.wall_us =
      sample_of(tests, Which::all, [](const TestResult& test) { return test.wall_us; });
  return summary;
}

}  // namespace jaywalk

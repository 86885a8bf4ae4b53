// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/comparison/judging.h"

#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/text.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/shipped.h"

namespace jaywalk {

std::optional<Criteria> read_criteria(const Arguments& arguments,
                                      const std::vector<Assertion>& otherwise, Console& console) {
  Criteria criteria{.metrics = arguments.has(option::kMetrics)};
  Diagnostics diagnostics;
  std::vector<std::string> files = input_files(arguments.texts(option::kAssertions),
                                               std::array{InputKind::assertions}, diagnostics);
  for (std::string& file : files) file = portable_assertions(file);
  auto named = read_assertion_files(files, files_on_disk());
  if (!named) {
    diagnostics.append(std::move(named.diagnostics()));
  } else {
    criteria.assertions = std::move(named.value().assertions);
    criteria.files = std::move(named.value().sources);
  }
  if (!arguments.has(option::kAssertions)) criteria.assertions = otherwise;
  if (arguments.has(option::kJunit) && criteria.assertions.empty() && !diagnostics.has_errors()) {
    diagnostics.error(option::kJunit.dashed(), "there are no assertions to judge",
                      "--assertions names a file of them");
  }
  console.report(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return criteria;
}

std::vector<FailureCondition> read_conditions(const Arguments& arguments,
                                              Diagnostics& diagnostics) {
  std::vector<FailureCondition> conditions;
  for (const std::string& text : arguments.texts(option::kFailOn)) {
    auto condition = parse_failure_condition(text);
    if (condition) {
      conditions.push_back(std::move(condition).value());
    } else {
      diagnostics.append(std::move(condition.diagnostics()));
    }
  }
  return conditions;
}

bool check_conditions(const std::vector<FailureCondition>& conditions, const Criteria& criteria,
                      Console& console) {
  Diagnostics wrong;
  for (const FailureCondition& condition : conditions) {
    wrong.append(problems(condition, criteria.assertions));
  }
  console.report(wrong);
  return !wrong.has_errors();
}

bool report_failures(const std::vector<FailureCondition>& conditions, const Comparison& comparison,
                     Console& console) {
  bool any = false;
  for (const FailureCondition& condition : conditions) {
    for (std::size_t row = 0; row < comparison.summaries.size(); ++row) {
      if (!fails(condition, comparison, row)) continue;
      any = true;
      const Summary& summary = comparison.summaries[row];
      const auto value = value_of(condition, comparison, row);
      console.note(fmt::format("failed: {} with {}: {} {} ({})", summary.behaviour,
                               counted(summary.agents, "agent"), subject_of(condition),
                               value ? fmt::format("is {:.6g}", *value) : "has no value",
                               condition.text));
    }
  }
  return any;
}

}  // namespace jaywalk

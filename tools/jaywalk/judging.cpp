#include "tools/jaywalk/judging.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace jaywalk {
namespace {

/// Adds the assertions of a file to those read before.
void read_file(const std::string& path, std::vector<Assertion>& assertions,
               Diagnostics& diagnostics) {
  auto more = read_assertions(path);
  if (!more) {
    diagnostics.append(std::move(more.diagnostics()));
    return;
  }
  for (Assertion& assertion : more.value()) {
    if (std::ranges::find(assertions, assertion.id, &Assertion::id) != assertions.end()) {
      diagnostics.error(path, fmt::format("a second assertion with the id '{}'", assertion.id));
      continue;
    }
    assertions.push_back(std::move(assertion));
  }
}

}  // namespace

std::optional<Inquiry> read_inquiry(const Arguments& arguments, const Scenario& scenario,
                                    Console& console) {
  Inquiry inquiry{.metrics = arguments.has("metrics")};
  Diagnostics diagnostics;
  for (const std::string& path : arguments.texts("assertions")) {
    read_file(path, inquiry.assertions, diagnostics);
  }
  if (!arguments.has("assertions")) inquiry.assertions = scenario.assertions;
  if (arguments.has("junit") && inquiry.assertions.empty() && !diagnostics.has_errors()) {
    diagnostics.error("--junit", "there are no assertions to judge",
                      "--assertions names a file of them");
  }
  console.report(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return inquiry;
}

std::vector<FailureCondition> read_conditions(const Arguments& arguments,
                                              Diagnostics& diagnostics) {
  std::vector<FailureCondition> conditions;
  for (const std::string& text : arguments.texts("fail-on")) {
    auto condition = parse_failure_condition(text);
    if (condition) {
      conditions.push_back(std::move(condition).value());
    } else {
      diagnostics.append(std::move(condition.diagnostics()));
    }
  }
  return conditions;
}

bool check_conditions(const std::vector<FailureCondition>& conditions, const Inquiry& inquiry,
                      Console& console) {
  Diagnostics wrong;
  for (const FailureCondition& condition : conditions) {
    wrong.append(problems(condition, inquiry.assertions));
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
      console.note(fmt::format("failed: {} with {} agents: {} is {:.6g} ({})", summary.behaviour,
                               summary.agents, subject_of(condition),
                               *value_of(condition, comparison, row), condition.text));
    }
  }
  return any;
}

void add_findings(const Inquiry& inquiry, const FindingsTable& findings,
                  const std::vector<std::string>& behaviours, Comparison& comparison) {
  if (!asks(inquiry)) return;
  for (const Assertion& assertion : inquiry.assertions) {
    comparison.assertions.push_back(assertion.id);
  }
  for (const Summary& summary : comparison.summaries) {
    const auto behaviour = std::ranges::find(behaviours, summary.behaviour) - behaviours.begin();
    comparison.findings.push_back(
        findings.summary(static_cast<std::size_t>(behaviour), summary.agents));
  }
}

Result<TestFindings> stored_findings(const Inquiry& inquiry, const ResultsReader& store,
                                     std::int64_t id, const Ground& ground) {
  auto rows = store.assessments(id);
  if (!rows) return std::move(rows.diagnostics());
  std::vector<std::string> ids;
  for (const Assertion& assertion : inquiry.assertions) ids.push_back(assertion.id);
  const bool judged = std::ranges::all_of(ids, [&](const std::string& each) {
    return std::ranges::find(rows.value(), each, &Assessment::id) != rows.value().end();
  });
  TestFindings findings = from_assessments(rows.value(), ids);
  if (!inquiry.metrics) findings.metrics.clear();
  // Every test with road users has a minimum distance.
  const bool measured = !inquiry.metrics || !findings.metrics.empty();
  if (judged && measured) return findings;
  auto recording = store.recording(id);
  if (!recording) return std::move(recording.diagnostics());
  return assess(inquiry, recording.value(), ground);
}

}  // namespace jaywalk

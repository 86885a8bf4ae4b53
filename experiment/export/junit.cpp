// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "experiment/export/comparison_files.h"
#include "interpreter/support/markup.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

struct Case {
  std::string name;
  Verdict verdict = Verdict::pass;
  bool errored = false;
  std::string message;
};

/// For an attribute, on one line whatever the file's lines are.
std::string on_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  std::ranges::replace(text, '\t', '?');
  return escaped_xml(text);
}

std::string suite(const std::string& name, const std::vector<Case>& cases) {
  std::size_t failures = 0;
  std::size_t skipped = 0;
  std::size_t errors = 0;
  std::string text;
  for (const Case& each : cases) {
    text += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", on_one_line(name),
                        on_one_line(each.name));
    if (each.errored) {
      ++errors;
      text += fmt::format(">\n      <error message=\"{}\"/>\n    </testcase>\n",
                          on_one_line(each.message));
    } else if (each.verdict == Verdict::fail) {
      ++failures;
      text += fmt::format(">\n      <failure message=\"{}\"/>\n    </testcase>\n",
                          on_one_line(each.message));
    } else if (each.verdict == Verdict::vacuous || each.verdict == Verdict::unavoidable) {
      ++skipped;
      text += fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n",
                          on_one_line(each.message));
    } else {
      text += "/>\n";
    }
  }
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n{}"
      "  </testsuite>\n",
      on_one_line(name), cases.size(), failures, errors, skipped, text);
}

std::string document(std::string_view suites) {
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n{}</testsuites>\n",
                     suites);
}

Case case_of(const Summary& summary, const VerdictCounts& counts) {
  Case result{.name = fmt::format("{}, {}", summary.behaviour, counted(summary.agents, "agent"))};
  if (counts.of(Verdict::fail) > 0) {
    result.verdict = Verdict::fail;
    result.message =
        fmt::format("{} of {} violate it", counts.of(Verdict::fail), counted(counts.all(), "test"));
  } else if (counts.of(Verdict::pass) == 0) {
    result.verdict = Verdict::vacuous;
    result.message = counts.exercised() == 0 ? "no test exercised it"
                                             : "no test in which it could have been kept";
  }
  return result;
}

Case case_of(const Assertion& assertion, const Judgement& judgement) {
  Case result{.name = assertion.id, .verdict = judgement.verdict};
  if (judgement.verdict == Verdict::vacuous) result.message = "the precondition was not met";
  if (judgement.verdict == Verdict::unavoidable) result.message = "it could not have been kept";
  if (judgement.verdict == Verdict::fail) {
    result.message =
        fmt::format("violated at tick {}, robustness {:.6g}: {}", judgement.tick.value_or(0),
                    judgement.robustness.value_or(0), assertion.requirement.written.text);
  }
  return result;
}

/// A suite of the rows some of whose tests ended errored, whatever is judged.
std::string errored_suite(const Comparison& comparison) {
  std::vector<Case> cases;
  for (std::size_t row = 0; row < comparison.summaries.size(); ++row) {
    const Summary& summary = comparison.summaries[row];
    if (summary.errored == 0) continue;
    Case result{.name = fmt::format("{}, {}", summary.behaviour, counted(summary.agents, "agent")),
                .errored = true,
                .message = fmt::format("{} of {} ended errored", summary.errored,
                                       counted(summary.tests, "test"))};
    if (row < comparison.troubles.size() && !comparison.troubles[row].errors.empty()) {
      result.message += ": " + comparison.troubles[row].errors.front().message;
    }
    cases.push_back(std::move(result));
  }
  return cases.empty() ? std::string() : suite("errored", cases);
}

}  // namespace

std::string to_junit(const Comparison& comparison) {
  std::string suites;
  for (std::size_t i = 0; i < comparison.assertions.size(); ++i) {
    std::vector<Case> cases;
    for (std::size_t row = 0; row < comparison.assessments.size(); ++row) {
      cases.push_back(case_of(comparison.summaries[row], comparison.assessments[row].verdicts[i]));
    }
    suites += suite(comparison.assertions[i], cases);
  }
  return document(suites + errored_suite(comparison));
}

std::string to_junit(const std::string& name, const Criteria& criteria,
                     const TestAssessment& assessment) {
  std::vector<Case> cases;
  for (std::size_t i = 0; i < assessment.judgements.size(); ++i) {
    cases.push_back(case_of(criteria.assertions[i], assessment.judgements[i]));
  }
  return document(suite(name, cases));
}

}  // namespace jaywalk

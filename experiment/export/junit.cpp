#include "experiment/export/junit.h"

#include <vector>

#include <fmt/format.h>

namespace jaywalk {
namespace {

struct Case {
  std::string name;
  Verdict verdict = Verdict::pass;
  std::string message;
};

/// Text in an attribute; what XML does not allow becomes '?'.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
        result += ' ';
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  }
  return result;
}

std::string suite(std::string_view name, const std::vector<Case>& cases) {
  std::size_t failures = 0;
  std::size_t skipped = 0;
  std::string text;
  for (const Case& each : cases) {
    text += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", escaped(name),
                        escaped(each.name));
    if (each.verdict == Verdict::fail) {
      ++failures;
      text += fmt::format(">\n      <failure message=\"{}\"/>\n    </testcase>\n",
                          escaped(each.message));
    } else if (each.verdict == Verdict::vacuous || each.verdict == Verdict::unavoidable) {
      ++skipped;
      text += fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n",
                          escaped(each.message));
    } else {
      text += "/>\n";
    }
  }
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n{}"
      "  </testsuite>\n",
      escaped(name), cases.size(), failures, skipped, text);
}

std::string document(std::string_view suites) {
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n{}</testsuites>\n",
                     suites);
}

Case case_of(const Summary& summary, const VerdictCounts& counts) {
  Case result{.name = fmt::format("{}, {} agents", summary.behaviour, summary.agents)};
  if (counts.of(Verdict::fail) > 0) {
    result.verdict = Verdict::fail;
    result.message =
        fmt::format("{} of {} tests violate it", counts.of(Verdict::fail), counts.all());
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

}  // namespace

std::string to_junit(const Comparison& comparison) {
  std::string suites;
  for (std::size_t i = 0; i < comparison.assertions.size(); ++i) {
    std::vector<Case> cases;
    for (std::size_t row = 0; row < comparison.findings.size(); ++row) {
      cases.push_back(case_of(comparison.summaries[row], comparison.findings[row].verdicts[i]));
    }
    suites += suite(comparison.assertions[i], cases);
  }
  return document(suites);
}

std::string to_junit(const std::string& name, const Inquiry& inquiry,
                     const TestFindings& findings) {
  std::vector<Case> cases;
  for (std::size_t i = 0; i < findings.judgements.size(); ++i) {
    cases.push_back(case_of(inquiry.assertions[i], findings.judgements[i]));
  }
  return document(suite(name, cases));
}

}  // namespace jaywalk

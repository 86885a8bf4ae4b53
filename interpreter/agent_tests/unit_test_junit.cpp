// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/agent_tests/unit_tests.h"
#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

std::string test_case(const UnitTest& test, const UnitTestReport& report) {
  const auto line = test.where.source->position(test.where.span.begin).line;
  std::string xml = fmt::format(
      "    <testcase classname=\"{}\" name=\"{}\" file=\"{}\" line=\"{}\" "
      "assertions=\"{}\" time=\"{:g}\"",
      escaped_xml(test.file), escaped_xml(test.name), escaped_xml(test.where.source->name()), line,
      report.assertions, report.seconds);
  if (report.verdict == UnitTestVerdict::passed) return xml + "/>\n";
  xml += ">\n";
  if (report.verdict == UnitTestVerdict::no_assertions) {
    xml += "      <skipped message=\"the test asserts nothing\"/>\n";
  }
  for (const UnitTestReport::Failure& failure : report.failures) {
    const bool is_assertion = !failure.assertion.empty();
    const std::string_view element = is_assertion ? "failure" : "error";
    xml += fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n", element,
                       escaped_xml(is_assertion ? failure.assertion : "test"),
                       escaped_xml(failure.what.message), escaped_xml(render(failure.what)));
  }
  if (!report.output.empty()) {
    std::string output;
    for (const std::string& each : report.output) output += each + "\n";
    xml += fmt::format("      <system-out>{}</system-out>\n", escaped_xml(output));
  }
  return xml + "    </testcase>\n";
}

struct AssertionCounts {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::size_t skipped = 0;
  double seconds = 0;

  void add(const UnitTestReport& report) {
    ++tests;
    failures += report.verdict == UnitTestVerdict::failed ? 1 : 0;
    errors += report.verdict == UnitTestVerdict::broken ? 1 : 0;
    skipped += report.verdict == UnitTestVerdict::no_assertions ? 1 : 0;
    seconds += report.seconds;
  }
  [[nodiscard]] std::string attributes() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:g}\"",
                       tests, failures, errors, skipped, seconds);
  }
};

}  // namespace

std::string junit_xml(const std::vector<UnitTest>& tests,
                      const std::vector<UnitTestReport>& reports) {
  AssertionCounts all;
  std::string suites;
  for (std::size_t begin = 0; begin < tests.size();) {
    AssertionCounts counts;
    std::string cases;
    std::size_t end = begin;
    for (; end < tests.size() && tests[end].file == tests[begin].file; ++end) {
      counts.add(reports[end]);
      all.add(reports[end]);
      cases += test_case(tests[end], reports[end]);
    }
    suites += fmt::format("  <testsuite name=\"{}\" {}>\n{}  </testsuite>\n",
                          escaped_xml(tests[begin].file), counts.attributes(), cases);
    begin = end;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n{}</testsuites>\n",
      all.attributes(), suites);
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// `jaywalk test`: agents' own tests, in parallel.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/scenario/files/portable_names.h"
#include "interpreter/agent_tests/unit_tests.h"
#include "interpreter/support/start_threads.h"
#include "interpreter/support/text.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/console/progress_line.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk::command::test {
namespace {

namespace fs = std::filesystem;

constexpr auto kProgressInterval = std::chrono::milliseconds(100);

struct Options {
  IncludePath include_path;
  UnitTestLimits limits;
  std::string filter;
  unsigned threads = 1;
};

std::optional<Options> read_options(const Arguments& arguments, Console& console) {
  auto include_path = read_include_path(arguments, console);
  if (!include_path) return std::nullopt;
  Options options{.include_path = std::move(*include_path), .limits = {}, .filter = {}};
  Diagnostics diagnostics;
  options.limits.seed = arguments.number(option::kSeed, 0, diagnostics).value_or(0);
  options.limits.max_cycles =
      arguments.number(option::kMaxCycles, 1, diagnostics).value_or(options.limits.max_cycles);
  options.limits.timeout_s =
      arguments.positive(option::kTimeout, diagnostics).value_or(options.limits.timeout_s);
  options.threads = read_threads(arguments, diagnostics);
  options.filter = arguments.text(option::kFilter).value_or("");
  options.limits.coverage = arguments.has(option::kCoverage);
  check_coverage_options(arguments, diagnostics);
  if (!diagnostics.has_errors()) return options;
  console.report(diagnostics);
  return std::nullopt;
}

/// The programs in a folder and below it, sorted.
std::vector<std::string> programs_in(const std::string& folder, Diagnostics& diagnostics) {
  std::vector<std::string> files;
  std::error_code error;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, options, error), end; at != end && !error;
       at.increment(error)) {
    std::error_code ignored;
    if (at->path().extension() == ".asl" && at->is_regular_file(ignored)) {
      files.push_back(at->path().generic_string());
    }
  }
  if (error) diagnostics.error(folder, fmt::format("cannot be read: {}", error.message()));
  std::ranges::sort(files);
  return files;
}

/// The tests of all paths, each file once. Of a file that is named one expects that it has some.
std::vector<UnitTest> find_tests(const std::vector<std::string>& paths, const Options& options,
                                 Diagnostics& diagnostics) {
  std::vector<UnitTest> tests;
  std::set<std::string> seen;
  const auto add = [&](const std::string& file) {
    if (!seen.insert(fs::path(file).lexically_normal().string()).second) return true;
    auto found = find_unit_tests(file, options.include_path, diagnostics);
    const bool has_some = !found.empty();
    std::ranges::move(found, std::back_inserter(tests));
    return has_some;
  };
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      for (const std::string& file : programs_in(path, diagnostics)) (void)add(file);
      continue;
    }
    const std::size_t errors = diagnostics.error_count();
    if (!add(path) && diagnostics.error_count() == errors) {
      diagnostics.error(path, "has no tests", "a test is a plan with a label like @[test]");
    }
  }
  return tests;
}

/// Runs the tests over threads. What a worker throws is thrown from wait().
class Work {
 public:
  Work(const std::vector<UnitTest>& tests, const Options& options)
      : tests_(tests), options_(options), reports_(tests.size()) {}

  void run() {
    std::exception_ptr thrown;
    try {
      for (std::size_t i = next_.fetch_add(1); i < tests_.size() && !cancelled_;
           i = next_.fetch_add(1)) {
        reports_[i] = run_unit_test(tests_[i], options_.include_path, options_.limits,
                                    [this] { return cancelled_.load(); });
        ++done_;
      }
    } catch (...) {
      thrown = std::current_exception();
      cancelled_ = true;
    }
    const std::lock_guard lock(mutex_);
    // Any of several will do: the others are mostly its consequences.
    if (thrown) thrown_ = thrown;
    ++workers_done_;
    changed_.notify_one();
  }

  void wait(unsigned workers, const InterruptGuard& interrupt, ProgressLine& progress) {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, kProgressInterval, [&] { return workers_done_ == workers; })) {
      progress.show({.done = done_, .total = tests_.size()});
      if (interrupt.interrupted()) cancelled_ = true;
    }
  }

  std::vector<UnitTestReport> reports() {
    if (thrown_) std::rethrow_exception(thrown_);
    return std::move(reports_);
  }

 private:
  const std::vector<UnitTest>& tests_;
  const Options& options_;
  std::vector<UnitTestReport> reports_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> done_{0};
  std::atomic<bool> cancelled_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  unsigned workers_done_ = 0;
  std::exception_ptr thrown_;
};

/// Nothing if the user interrupts.
std::optional<std::vector<UnitTestReport>> run_tests(const std::vector<UnitTest>& tests,
                                                     const Options& options, Console& console) {
  const InterruptGuard interrupt;
  ProgressLine progress(console);
  Work work(tests, options);
  {
    std::vector<std::jthread> threads;
    const std::size_t workers = start_threads(
        threads, std::min<std::size_t>(options.threads, tests.size()), [&work] { work.run(); });
    work.wait(static_cast<unsigned>(workers), interrupt, progress);
  }
  progress.clear();
  auto reports = work.reports();
  if (interrupt.interrupted()) return std::nullopt;
  return reports;
}

std::string_view word_for(UnitTestVerdict verdict) {
  switch (verdict) {
    case UnitTestVerdict::passed:
      return "ok  ";
    case UnitTestVerdict::failed:
    case UnitTestVerdict::broken:
      return "FAIL";
    case UnitTestVerdict::no_assertions:
      return "??  ";
  }
  std::abort();
}

void print_report(const UnitTest& test, const UnitTestReport& report, Console& console) {
  const std::string what = report.verdict == UnitTestVerdict::no_assertions
                               ? "asserts nothing"
                               : counted(report.assertions, "assertion");
  console.print(
      fmt::format("{} {}: {} ({})\n", word_for(report.verdict), test.file, test.name, what));
  if (!report.is_failure()) return;
  for (const UnitTestReport::Failure& failure : report.failures) {
    console.print(render(failure.what, console.output_colour()));
  }
  for (const std::string& line : report.output) console.print(fmt::format("  | {}\n", line));
}

ExitCode print_reports(const std::vector<UnitTest>& tests,
                       const std::vector<UnitTestReport>& reports, Console& console) {
  std::size_t failed = 0;
  std::size_t without = 0;
  std::uint64_t assertions = 0;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    print_report(tests[i], reports[i], console);
    failed += reports[i].is_failure() ? 1 : 0;
    without += reports[i].verdict == UnitTestVerdict::no_assertions ? 1 : 0;
    assertions += reports[i].assertions;
  }
  std::string line =
      fmt::format("{}, {}: {} passed, {} failed", counted(tests.size(), "test"),
                  counted(assertions, "assertion"), tests.size() - failed - without, failed);
  if (without > 0) line += fmt::format(", {} without assertions", without);
  console.print(line + "\n");
  return failed > 0 ? ExitCode::failed : ExitCode::success;
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "PATH... [OPTIONS]",
      .description =
          "Runs the tests of agents: plans labelled @[test] or @name[test], in the files\n"
          "(.asl) or folders given. Each runs in an agent of its own, in virtual time.\n"
          "Assertions are goals: !assert_equals(Expected, Actual), with a tolerance as third\n"
          "argument, !assert_true(Formula), !assert_false(Formula), !assert_contains(List,\n"
          "Element), !assert_not_equals, !assert_not_contains, !assert_greater_than,\n"
          "!assert_greater_than_equals, !assert_between, !force_pass, !force_failure(Text).\n"
          "Jason's test files run as they are. Exits with 1 if a test fails.\n",
      .options =
          {
              {option::kFilter, "TEXT", "only tests whose 'file: name' contains the text"},
              {option::kJunit, "FILE", "write the results as JUnit XML", Written::file},
              kCoverageOption,
              {option::kThreads, "N", "run so many tests at a time (default: all cores)"},
              {option::kSeed, "N", "of the agents' random numbers (default 0)"},
              {option::kMaxCycles, "N", "reasoning cycles of an agent in a test (default 1000000)"},
              {option::kTimeout, "S", "seconds that a test may take (default 60)"},
          },
      .examples =
          "  jaywalk test agents/crossing/tests\n"
          "  jaywalk test tests/*.asl --filter distance --junit results.xml\n"};
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.operands().empty()) {
    console.error("expected files or folders with tests",
                  "jaywalk test --help shows how to write it");
    return ExitCode::usage;
  }
  const auto options = read_options(arguments, console);
  if (!options) return ExitCode::usage;
  Diagnostics diagnostics;
  const auto paths = input_files(arguments.operands(), kPrograms, diagnostics);
  std::vector<UnitTest> tests = find_tests(paths, *options, diagnostics);
  console.report(diagnostics);
  if (diagnostics.has_errors()) return ExitCode::usage;
  std::erase_if(tests, [&](const UnitTest& test) {
    return fmt::format("{}: {}", test.file, test.name).find(options->filter) == std::string::npos;
  });
  if (tests.empty()) {
    console.error("no tests found", options->filter.empty()
                                        ? "a test is a plan with a label like @[test]"
                                        : "--filter leaves none");
    return ExitCode::usage;
  }
  const auto reports = run_tests(tests, *options, console);
  if (!reports) {
    console.note("interrupted");
    return ExitCode::interrupted;
  }
  const ExitCode code = print_reports(tests, *reports, console);
  if (options->limits.coverage) {
    SourceCoverage coverage;
    for (const UnitTestReport& report : *reports) coverage.add(report.coverage);
    const PortableNames portable(arguments.operands(), {});
    const std::string subject =
        portable.in(fmt::format("the tests of {}", fmt::join(arguments.operands(), ", ")));
    if (!write_coverage(arguments, coverage, subject, console)) return ExitCode::failed;
  }
  if (const auto file = arguments.text(option::kJunit)) {
    if (!write_output(*file, junit_xml(tests, *reports), console)) return ExitCode::failed;
  }
  return code;
}

}  // namespace jaywalk::command::test

// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent_tests/unit_tests.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent_tests/unit_test_goals.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/embed/program_loader.h"
#include "interpreter/mas/mas.h"
#include "interpreter/support/markup.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// The steps after the test's goal at which everything else in the program under test ends.
constexpr std::uint64_t kStepsAfterTest = 10'000;
constexpr std::uint64_t kStepsBetweenLooksOfTests = 64;
constexpr std::size_t kMaxOutputLines = 1000;
constexpr std::uint64_t kMaxAgentBytes = std::uint64_t{256} << 20U;
constexpr std::uint64_t kMaxInferences = 10'000'000;

/// Jason's framework is built in, whatever path it is included by.
IncludePath with_framework(IncludePath include_path) {
  for (const std::string_view name :
       {"tester_agent.asl", "test_assert.asl", "test_performance.asl"}) {
    include_path.given.emplace_back(name, "");
  }
  include_path.given.emplace_back("mock_agent.asl", mock_agent());
  return include_path;
}

// --- Finding tests ---------------------------------------------------------------------------

bool is_test_label(const ast::Node* label) {
  if (label == nullptr) return false;
  const ast::Node* const annots = label->kind == ast::Kind::list ? label : label->annots;
  if (annots == nullptr) return false;
  return std::ranges::any_of(annots->args, [](const ast::Node* annot) {
    return annot->kind == ast::Kind::literal && annot->text == "test" && annot->args.empty();
  });
}

void collect_tests(std::span<const ast::Component> components, const std::string& program,
                   const SourcePtr& source, std::vector<UnitTest>& tests) {
  for (const ast::Component& component : components) {
    if (component.is_block) collect_tests(component.inner, program, source, tests);
    if (component.kind != ast::ComponentKind::plan) continue;
    const ast::Plan& plan = *component.plan;
    const ast::Trigger& trigger = plan.trigger;
    if (!is_test_label(plan.label) || trigger.op != ast::TriggerOperator::add ||
        trigger.kind != ast::TriggerKind::achieve || trigger.literal->kind != ast::Kind::literal) {
      continue;
    }
    const bool named = plan.label->kind == ast::Kind::literal;
    tests.push_back({.file = program,
                     .name = std::string(named ? plan.label->text : trigger.literal->text),
                     .goal = std::string(source->text(trigger.literal->span)),
                     .where = {source, trigger.span}});
  }
}

// --- Running one -----------------------------------------------------------------------------

/// The program under test with the assertion goals before it and the test's goal behind it.
SourcePtr extended_program(const UnitTest& test) {
  const fs::path path(test.file);
  std::string text(assertion_goals());
  text += fmt::format("{{ include(\"{}\") }}\n", path.filename().generic_string());
  text += fmt::format(
      "!{0}::run.\n"
      "+!{0}::run <- !{1}; +{0}::finished.\n"
      "-!{0}::run[error(E), error_msg(M), code(C), code_line(L), code_src(F)] : {0}::text(C, T)\n"
      "  <- +{0}::broken(E, M, T, L, F).\n"
      "-!{0}::run[error(E), error_msg(M)] <- +{0}::broken(E, M, \"\", 0, \"\").\n",
      kTestNamespace, test.goal);
  return std::make_shared<Source>((path.parent_path() / "jaywalk test").generic_string(),
                                  std::move(text));
}

/// The files of a program, to point into.
class Places {
 public:
  explicit Places(const SourceTree& tree) {
    for (const auto& file : tree.files) sources_[file->source->name()] = file->source;
  }

  /// The goal of that name on a line, or the line; nothing if the file is not known.
  [[nodiscard]] SourceSpan find(std::string_view file, std::uint32_t line,
                                std::string_view goal) const {
    if (file.starts_with("file:")) file.remove_prefix(5);
    const auto found = sources_.find(std::string(file));
    if (found == sources_.end() || line == 0) return {};
    const SourcePtr& source = found->second;
    const std::string_view text = source->line(line);
    const auto begin = static_cast<std::uint32_t>(text.data() - source->text().data());
    std::size_t at = goal.empty() ? std::string_view::npos : text.find(fmt::format("!{}", goal));
    std::size_t length = goal.size() + 1;
    if (at == std::string_view::npos) {
      at = std::min(text.find_first_not_of(" \t"), text.size());
      length = text.size() - at;
    }
    const auto from = begin + static_cast<std::uint32_t>(at);
    return {source, {from, from + static_cast<std::uint32_t>(length)}};
  }

 private:
  std::map<std::string, SourcePtr> sources_;
};

std::string text_of(Value value, const SymbolTable& symbols) {
  value = deref(value);
  return value.is_text() ? std::string(value.text()->view()) : term_text(value, symbols);
}

/// The names of the beliefs that tests leave.
struct FindingNames {
  explicit FindingNames(SymbolTable& symbols)
      : result(predicate(symbols, "result", 7)),
        finished(predicate(symbols, "finished", 0)),
        broken(predicate(symbols, "broken", 5)) {}

  Predicate result;
  Predicate finished;
  Predicate broken;

 private:
  static Predicate predicate(SymbolTable& symbols, std::string_view name, std::uint16_t arity) {
    return symbols.predicate(Signature{
        .ns = symbols.symbol(kTestNamespace), .functor = symbols.symbol(name), .arity = arity});
  }
};

/// The arguments of each belief of that name as texts, the oldest first.
std::vector<std::vector<std::string>> findings(const Agent& agent, Predicate name) {
  std::vector<std::vector<std::string>> found;
  const Relation* const relation = agent.beliefs().find(name);
  if (relation == nullptr) return found;
  for (auto seq = relation->first_seq(); seq < relation->end_seq(); ++seq) {
    const Value fact = relation->row(seq).fact;
    if (fact.is_unset()) continue;
    std::vector<std::string> args;
    for (const Value arg : literal_parts(fact).args) args.push_back(text_of(arg, agent.symbols()));
    found.push_back(std::move(args));
  }
  return found;
}

bool believes(const Agent& agent, Predicate name) {
  const Relation* const relation = agent.beliefs().find(name);
  return relation != nullptr && relation->size() > 0;
}

std::uint32_t line_of(const std::string& text) {
  return static_cast<std::uint32_t>(std::strtoul(text.c_str(), nullptr, 10));
}

std::string failure_message(const std::vector<std::string>& result) {
  const std::string& assertion = result[1];
  const std::string& expected = result[5];
  const std::string& actual = result[6];
  if (assertion == "force_failure") return fmt::format("force_failure: {}", expected);
  if (actual.empty()) return fmt::format("{}: expected {}", assertion, expected);
  return fmt::format("{}: expected {}, found {}", assertion, expected, actual);
}

class TestRun {
 public:
  TestRun(const UnitTest& test, IncludePath include_path, const UnitTestLimits& limits,
          std::function<bool()> cancelled)
      : test_(test),
        include_path_(std::move(include_path)),
        limits_(limits),
        cancelled_(std::move(cancelled)) {}

  UnitTestReport run() {
    Diagnostics diagnostics;
    const SourceTree tree = load_agent(extended_program(test_), include_path_, diagnostics);
    const auto symbols = std::make_shared<SymbolTable>();
    const auto program = compile(tree, *symbols, diagnostics);
    if (program == nullptr || diagnostics.has_errors()) {
      for (const Diagnostic& each : diagnostics.items()) {
        if (each.severity == Severity::error) report_.failures.push_back({"", each});
      }
      report_.verdict = UnitTestVerdict::broken;
      return std::move(report_);
    }
    names_.emplace(*symbols);
    Probes probes(symbols, Probes::Detail::counts);
    std::optional<CoverageObserver> observer;
    MasOptions mas_options = options();
    if (limits_.coverage) {
      probes.add(program);
      mas_options.observer = &observer.emplace(probes);
    }
    Mas mas(symbols, std::move(mas_options), nullptr);
    const AgentId agent = mas.add_agent(
        {.name = fs::path(test_.file).stem().string(), .program = program, .parameters = {}});
    const std::string problem = run_to_end(mas, agent);
    report_.seconds = mas.now_ms() / 1000;
    if (observer)
      report_.coverage = locate_in_files(probes, observer->counts(), include_path_.files);
    const Places places(tree);
    if (mas.is_alive(agent)) judge(mas, agent, problem, places);
    if (!mas.is_alive(agent)) break_off("the test's agent has been ended", test_.where);
    return std::move(report_);
  }

 private:
  MasOptions options() {
    MasOptions options;
    options.seed = limits_.seed;
    options.max_cycles = limits_.max_cycles;
    options.max_agent_bytes = kMaxAgentBytes;
    options.max_inferences = kMaxInferences;
    options.max_agents = 1000;
    options.interrupted = [this] { return has_timed_out() || (cancelled_ && cancelled_()); };
    const auto keep = [this](std::string_view line) {
      if (report_.output.size() < kMaxOutputLines) report_.output.emplace_back(line);
    };
    options.print = keep;
    options.log = keep;
    const fs::path folder = fs::path(test_.file).parent_path();
    options.load_program =
        [loader = std::make_shared<ProgramLoader>(folder.string(), include_path_)](
            const ProgramRequest& request, SymbolTable& symbols, LoadProblem& problem) {
          return loader->load(request, symbols, problem);
        };
    return options;
  }

  [[nodiscard]] bool has_ended(const Mas& mas, AgentId id) const {
    if (!mas.is_alive(id)) return true;
    const Agent& agent = mas.agent(id);
    return believes(agent, names_->finished) || believes(agent, names_->broken);
  }

  [[nodiscard]] bool has_timed_out() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    return passed.count() > limits_.timeout_s;
  }

  // Empty, or why it was stopped.
  std::string run_to_end(Mas& mas, AgentId agent) {
    std::optional<std::uint64_t> last_step;
    for (std::uint64_t step = 1; mas.step(); ++step) {
      if (last_step && step >= *last_step) return {};
      if (step % kStepsBetweenLooksOfTests != 0) continue;
      if (!last_step && has_ended(mas, agent)) last_step = step + kStepsAfterTest;
    }
    const RunOutcome& outcome = mas.outcome();
    if (outcome.end == RunEnd::interrupted) {
      return fmt::format("the test took longer than {:g} s", limits_.timeout_s);
    }
    const bool limited = outcome.end == RunEnd::limit || outcome.end == RunEnd::looping;
    return limited ? outcome.message : std::string();
  }

  void break_off(std::string message, SourceSpan where, std::string hint = {}) {
    report_.verdict = UnitTestVerdict::broken;
    report_.failures.push_back({"",
                                {.severity = Severity::error,
                                 .message = std::move(message),
                                 .where = std::move(where),
                                 .hint = std::move(hint),
                                 .code = {},
                                 .subject = test_.file}});
  }

  void judge(const Mas& mas, AgentId id, const std::string& problem, const Places& places) {
    const Agent& agent = mas.agent(id);
    for (const auto& result : findings(agent, names_->result)) {
      ++report_.assertions;
      if (result[2] == "failed") add_failed(result, places);
    }
    const auto broken = findings(agent, names_->broken);
    const bool finished = believes(agent, names_->finished);
    if (!report_.failures.empty()) report_.verdict = UnitTestVerdict::failed;
    if (!broken.empty()) {
      add_broken(broken.front(), places);
    } else if (!finished) {
      const std::vector<std::string> intentions = mas.describe_intentions(id);
      break_off(
          problem.empty() ? "the test's goal was not achieved: nothing goes on any more" : problem,
          test_.where, intentions.empty() ? std::string() : "it waits in " + intentions.front());
    } else if (report_.failures.empty() && report_.assertions == 0) {
      report_.verdict = UnitTestVerdict::no_assertions;
    }
  }

  void add_failed(const std::vector<std::string>& result, const Places& places) {
    SourceSpan where = places.find(result[4], line_of(result[3]), result[1]);
    if (where.source == nullptr) where = test_.where;
    report_.failures.push_back({result[1],
                                {.severity = Severity::error,
                                 .message = failure_message(result),
                                 .where = std::move(where),
                                 .hint = {},
                                 .code = {},
                                 .subject = test_.file}});
  }

  void add_broken(const std::vector<std::string>& broken, const Places& places) {
    SourceSpan where = places.find(broken[4], line_of(broken[3]), "");
    if (where.source == nullptr || where.source->name().ends_with("jaywalk test")) {
      where = test_.where;
    }
    std::string message = fmt::format("the test's goal failed: {}", broken[0]);
    if (!broken[1].empty()) message += fmt::format(": {}", broken[1]);
    break_off(std::move(message), std::move(where),
              broken[2].empty() ? std::string() : "in " + broken[2]);
  }

  const UnitTest& test_;
  IncludePath include_path_;
  const UnitTestLimits& limits_;
  std::function<bool()> cancelled_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::optional<FindingNames> names_;
  UnitTestReport report_;
};

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

std::vector<UnitTest> find_unit_tests(const std::string& path, const IncludePath& include_path,
                                      Diagnostics& diagnostics) {
  std::vector<UnitTest> tests;
  const SourceTree tree = load_agent(path, with_framework(include_path), diagnostics);
  for (const auto& file : tree.files) {
    collect_tests(file->components, path, file->source, tests);
  }
  if (!diagnostics.has_errors()) {
    SymbolTable symbols;
    (void)compile(tree, symbols, diagnostics);
  }
  return tests;
}

UnitTestReport run_unit_test(const UnitTest& test, const IncludePath& include_path,
                             const UnitTestLimits& limits, std::function<bool()> cancelled) {
  return TestRun(test, with_framework(include_path), limits, std::move(cancelled)).run();
}

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

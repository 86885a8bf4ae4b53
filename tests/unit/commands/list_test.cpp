// SPDX-License-Identifier: Apache-2.0
// `jaywalk list`: what it prints are the tables' rows, each once and in their order, in lines that
// fit into a terminal.

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/environments.h"
#include "env/lane/controller.h"
#include "env/vehicle/defects.h"
#include "env/vehicle/vehicle.h"
#include "experiment/compare/measures/measures.h"
#include "experiment/export/exporter.h"
#include "experiment/judge/metrics/metrics.h"
#include "experiment/judge/signals/signals.h"
#include "experiment/policy/learner.h"
#include "interpreter/check/check.h"
#include "interpreter/logic/action.h"
#include "search/generator.h"
#include "search/suts/suts.h"
#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using test::CommandRun;
using test::run_command;
using testing::ElementsAreArray;
using testing::HasSubstr;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

std::string first_word(const std::string& line) { return line.substr(0, line.find(' ')); }

/// What `list` prints of a kind; it fails the test if that is refused.
std::string listed(const std::string& kind) {
  const CommandRun run = run_command({"list", kind});
  EXPECT_EQ(run.code, ExitCode::success) << kind;
  EXPECT_EQ(run.errors, "") << kind;
  return run.output;
}

/// The names of the lines that are not the rest of the row above.
std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (const std::string& line : lines_of(text)) {
    if (!line.starts_with(' ')) names.push_back(first_word(line));
  }
  return names;
}

std::vector<std::string> kinds() { return names_in(run_command({"list"}).output); }

class ListOfEachKind : public testing::TestWithParam<std::string> {};

TEST_P(ListOfEachKind, HasRowsThatAHundredColumnsHold) {
  const std::vector<std::string> lines = lines_of(listed(GetParam()));
  // Behaviours are those installed beside the command, which a test is not.
  if (GetParam() != "behaviours") {
    EXPECT_GE(lines.size(), 2U);
  }
  for (const std::string& line : lines) {
    // Of UTF-8 the bytes that begin a character.
    const auto columns = std::ranges::count_if(
        line, [](char c) { return (static_cast<unsigned>(c) & 0xC0U) != 0x80U; });
    EXPECT_LE(columns, 100) << line;
  }
}

TEST_P(ListOfEachKind, EndsNoLineInABlank) {
  for (const std::string& line : lines_of(listed(GetParam()))) {
    EXPECT_FALSE(line.empty() || line.ends_with(' ')) << '\'' << line << '\'';
  }
}

TEST_P(ListOfEachKind, IsNamedInTheCommandsHelp) {
  const auto list = std::ranges::find(commands(), std::string_view("list"), &Command::name);
  EXPECT_THAT(std::string(list->help().description), HasSubstr(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(List, ListOfEachKind, testing::ValuesIn(kinds()), [](const auto& kind) {
  std::string name = kind.param;
  std::erase(name, '-');
  return name;
});

/// The names of a table's entries.
template <class Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}

TEST(ListCommand, HasEveryRowOfItsTables) {
  EXPECT_THAT(names_in(listed("checks")), ElementsAreArray(names_of(checks())));
  EXPECT_THAT(names_in(listed("measures")), ElementsAreArray(names_of(measures())));
  EXPECT_THAT(names_in(listed("metrics")), ElementsAreArray(names_of(metrics())));
  EXPECT_THAT(names_in(listed("signals")), ElementsAreArray(names_of(signals())));
  EXPECT_THAT(names_in(listed("exporters")), ElementsAreArray(names_of(exporters())));
  EXPECT_THAT(names_in(listed("vehicles")), ElementsAreArray(names_of(vehicle_models())));
  EXPECT_THAT(names_in(listed("defects")), ElementsAreArray(names_of(defect_models())));
  EXPECT_THAT(names_in(listed("learners")), ElementsAreArray(names_of(learner_kinds())));
  EXPECT_THAT(names_in(listed("generators")), ElementsAreArray(names_of(search::generators())));
  EXPECT_THAT(names_in(listed("suts")), ElementsAreArray(names_of(search::sut_kinds())));
  EXPECT_THAT(names_in(listed("controllers")), ElementsAreArray(names_of(lane::controllers())));
  EXPECT_THAT(names_in(listed("commands")), ElementsAreArray(names_of(commands())));
}

TEST(ListCommand, HasEveryInternalActionAndFunctionAsItIsCalled) {
  const std::string actions = listed("internal-actions");
  for (const ActionDefinition& action : standard_actions().actions()) {
    EXPECT_THAT(actions, HasSubstr(action.signature));
  }
  const std::string functions = listed("functions");
  for (const FunctionDefinition& function : standard_actions().functions()) {
    EXPECT_THAT(functions, HasSubstr(function.signature));
  }
}

TEST(ListCommand, HasTheWordsOfEachWorldBelowIt) {
  const std::string text = listed("environments");
  EXPECT_THAT(names_in(text), ElementsAreArray(names_of(environments())));
  std::size_t from = 0;
  for (const EnvironmentKind& world : environments()) {
    from = text.find(std::string(world.name) + "  ", from);
    for (const auto& words : {world.percepts, world.actions}) {
      for (const EnvironmentWord& word : words) {
        from = text.find("    " + std::string(word.form), from);
        ASSERT_NE(from, text.npos) << world.name << ": " << word.form;
      }
    }
  }
}

TEST(ListCommand, SaysInWhichUnitsAMetricAndASignalAre) {
  for (const Metric& metric : metrics()) {
    if (metric.unit.empty()) continue;
    EXPECT_THAT(listed("metrics"), HasSubstr('[' + std::string(metric.unit) + ']')) << metric.name;
  }
  EXPECT_THAT(listed("signals"), HasSubstr("[condition] "));
}

TEST(ListCommand, PutsTheSummaryOfALongNameBelowIt) {
  bool any = false;
  const std::vector<std::string> lines = lines_of(listed("internal-actions"));
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (lines[i].starts_with(' ') || lines[i].find("  ") != std::string::npos) continue;
    any = true;
    EXPECT_GT(lines[i].size(), 32U) << "a short name has its summary beside it";
    EXPECT_TRUE(lines[i + 1].starts_with("    ")) << lines[i + 1];
  }
  EXPECT_TRUE(any) << "there are long names";
}

TEST(ListCommand, SuggestsOnlyWhatIsNear) {
  const CommandRun near = run_command({"list", "defect"});
  EXPECT_EQ(near.code, ExitCode::usage);
  EXPECT_THAT(near.errors, HasSubstr("did you mean 'defects'?"));
  const CommandRun far = run_command({"list", "weather"});
  EXPECT_EQ(far.code, ExitCode::usage);
  EXPECT_THAT(far.errors,
              HasSubstr("unknown kind 'weather'\n  hint: jaywalk list names the kinds"));
  EXPECT_EQ(far.output, "");
}

TEST(ListCommand, TakesOneKindAtATime) {
  const CommandRun run = run_command({"list", "checks", "suts", "defects"});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_THAT(run.errors, HasSubstr("expected one kind, found 3"));
}

}  // namespace
}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// `jaywalk list`: the rows of the tables, for people.

#include <algorithm>
#include <array>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "env/environments.h"
#include "env/lane/controller.h"
#include "env/simulator/simulator.h"
#include "env/vehicle/defects.h"
#include "env/vehicle/vehicle.h"
#include "experiment/compare/measures/measures.h"
#include "experiment/export/exporter.h"
#include "experiment/judge/metrics/metrics.h"
#include "experiment/judge/signals/signals.h"
#include "experiment/policy/learner.h"
#include "experiment/scenario/scenario.h"
#include "interpreter/check/check.h"
#include "interpreter/logic/action.h"
#include "search/generator.h"
#include "search/suts/suts.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/options/shipped.h"

namespace jaywalk::command::list {
namespace {

struct Row {
  std::string name;
  std::string summary;
};

/// Lines of whole words that are at most `width` wide, the second and further ones indented.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string result;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (column > 0 && column + 1 + word.size() > width) {
      result += '\n' + std::string(indent, ' ');
      column = 0;
    } else if (column > 0) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result;
}

/// Names on the left, summaries on the right; the summary of a long name stands below it.
std::string columns(std::string_view indent, const std::vector<Row>& rows) {
  constexpr std::size_t kLineWidth = 100;
  constexpr std::size_t kWidestName = 32;
  std::size_t width = 0;
  for (const Row& row : rows) {
    if (row.name.size() <= kWidestName) width = std::max(width, row.name.size());
  }
  const std::size_t left = indent.size() + width + 2;
  std::string text;
  for (const Row& row : rows) {
    const std::string gap = row.name.size() > width ? '\n' + std::string(left, ' ') : "  ";
    text += fmt::format("{}{:<{}}{}{}\n", indent, row.name, width, gap,
                        wrapped(row.summary, kLineWidth - left, left));
  }
  return text;
}

/// The rows of a table whose entries have a name and a summary.
template <class Table>
std::string named_rows(const Table& table) {
  std::vector<Row> rows;
  for (const auto& entry : table) {
    rows.push_back({std::string(entry.name), std::string(entry.summary)});
  }
  return columns("", rows);
}

std::string words(std::string_view title, std::span<const EnvironmentWord> words) {
  std::vector<Row> rows;
  for (const EnvironmentWord& word : words) {
    rows.push_back({std::string(word.form), description(word)});
  }
  return fmt::format("  {}\n{}", title, columns("    ", rows));
}

std::string environment_text() {
  std::string text;
  for (const EnvironmentKind& environment : environments()) {
    text += columns("", {{std::string(environment.name), std::string(environment.summary)}});
    text += words("percepts", environment.percepts) + words("actions", environment.actions);
  }
  return text;
}

std::string action_text() {
  std::vector<Row> rows;
  for (const ActionDefinition& action : standard_actions().actions()) {
    rows.push_back({action.signature, action.summary});
  }
  return columns("", rows);
}

std::string function_text() {
  std::vector<Row> rows;
  for (const FunctionDefinition& function : standard_actions().functions()) {
    rows.push_back({function.signature, function.summary});
  }
  return columns("", rows);
}

std::string metric_text() {
  std::vector<Row> rows;
  for (const Metric& metric : metrics()) {
    const std::string unit = metric.unit.empty() ? "" : fmt::format(" [{}]", metric.unit);
    const std::string source = metric.source.empty() ? "" : fmt::format(" ({})", metric.source);
    rows.push_back({std::string(metric.name), fmt::format("{}{}{}", metric.formula, unit, source)});
  }
  return columns("", rows);
}

std::string signal_text() {
  std::vector<Row> rows;
  for (const Signal& signal : signals()) {
    const std::string_view unit = signal.kind == SignalKind::condition ? "condition" : signal.unit;
    rows.push_back({std::string(signal.name), unit.empty()
                                                  ? std::string(signal.summary)
                                                  : fmt::format("[{}] {}", unit, signal.summary)});
  }
  return columns("", rows);
}

std::string defect_text() {
  std::vector<Row> rows;
  for (const DefectModel& defect : defect_models()) {
    const std::string severities =
        defect.unit.empty()
            ? ""
            : fmt::format(" {} {}", fmt::join(defect.severities, ", "), defect.unit);
    rows.push_back(
        {std::string(defect.name), fmt::format("[{}{}] {} ({})", name(defect.family), severities,
                                               defect.summary, defect.source)});
  }
  return columns("", rows);
}

/// The values that a key can have: a range or words.
std::string range_of(const SettingKey& key) {
  if (key.kind == SettingKind::number) return fmt::format(" ({:g} to {:g})", key.least, key.most);
  return key.words.empty() ? "" : fmt::format(" ({})", key.words);
}

std::string simulator_text() {
  std::string text;
  for (const SimulatorKind& simulator : simulator_kinds()) {
    text += fmt::format("{}  {}\n", simulator.name, simulator.summary);
    std::vector<Row> rows;
    for (const SettingKey& key : simulator.keys) {
      rows.push_back({std::string(key.name), std::string(key.meaning) + range_of(key)});
    }
    text += columns("  ", rows);
  }
  return text;
}

/// The first comment of a program, up to its first full stop.
std::string first_words(const SourcePtr& source) {
  std::string words;
  for (std::uint32_t line = 1; source->line(line).starts_with("//"); ++line) {
    const std::string_view text = source->line(line).substr(2);
    words += words.empty() ? text.substr(std::min(text.find_first_not_of(' '), text.size())) : text;
  }
  return words.substr(0, words.find('.'));
}

std::string behaviour_text() {
  const SourceFiles files = files_on_disk();
  std::vector<Row> rows;
  for (const EnvironmentKind& world : environments()) {
    for (const std::string& name : installed_behaviours(world.name, files)) {
      const auto source = files.read(name);
      if (!source) continue;
      const std::size_t slash = name.rfind('/') + 1;
      rows.push_back({name.substr(slash, name.size() - slash - 4), first_words(source.value())});
    }
  }
  return columns("", rows);
}

struct Kind {
  std::string_view name;
  std::string_view summary;
  std::string (*text)();
};

constexpr std::array kKinds = {
    Kind{"environments", "worlds, with what agents perceive and do in them", environment_text},
    Kind{"behaviours", "installed pedestrians (and cyclist, signal), for --behaviours",
         behaviour_text},
    Kind{"internal-actions", "what agents can call as .name(...)", action_text},
    Kind{"functions", "what agents can use in expressions, as math.abs(X)", function_text},
    Kind{"checks", "what check warns of", [] { return named_rows(checks()); }},
    Kind{"measures", "what compare measures", [] { return named_rows(measures()); }},
    Kind{"exporters", "what stored tests can be exported as",
         [] { return named_rows(exporters()); }},
    Kind{"vehicles", "how automated vehicles drive, world.av.model",
         [] { return named_rows(vehicle_models()); }},
    Kind{"defects", "faults that can be put on an automated vehicle, world.av.defect", defect_text},
    Kind{"simulators", "who can move vehicles in the world's place, world.simulator",
         simulator_text},
    Kind{"metrics", "what --metrics measures of each test", metric_text},
    Kind{"signals", "what assertions can refer to", signal_text},
    Kind{"learners", "who can learn from agents' choices",
         [] { return named_rows(learner_kinds()); }},
    Kind{"generators", "what search can look for tests with",
         [] { return named_rows(jaywalk::search::generators()); }},
    Kind{"suts", "systems that search can test",
         [] { return named_rows(jaywalk::search::sut_kinds()); }},
    Kind{"controllers", "lane-keeping assistants", [] { return named_rows(lane::controllers()); }},
    Kind{"presets", "values that a scenario can begin with", [] { return named_rows(presets()); }},
    Kind{"commands", "what jaywalk can do", [] { return named_rows(commands()); }},
};

}  // namespace

CommandHelp help() {
  return {.usage = "KIND [OPTIONS]",
          .description =
              "Names what there is of a kind: environments, behaviours, internal-actions,\n"
              "functions, checks, measures, metrics, signals, exporters, vehicles, defects,\n"
              "simulators, learners, generators, suts, controllers, presets or commands.\n",
          .options = {},
          .examples =
              "  jaywalk list environments\n"
              "  jaywalk list presets\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  const auto& operands = arguments.operands();
  if (operands.empty()) {
    console.print(named_rows(kKinds));
    return ExitCode::success;
  }
  if (operands.size() > 1) {
    console.error(fmt::format("expected one kind, found {}", operands.size()));
    return ExitCode::usage;
  }
  const auto kind = std::ranges::find(kKinds, operands.front(), &Kind::name);
  if (kind != kKinds.end()) {
    console.print(kind->text());
    return ExitCode::success;
  }
  std::vector<std::string> known;
  for (const Kind& each : kKinds) known.emplace_back(each.name);
  std::string hint = did_you_mean(operands.front(), known);
  if (hint.empty()) hint = "jaywalk list names the kinds";
  console.error(fmt::format("unknown kind '{}'", operands.front()), hint);
  return ExitCode::usage;
}

}  // namespace jaywalk::command::list

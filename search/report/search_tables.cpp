// SPDX-License-Identifier: Apache-2.0
#include "search/report/search_tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/judge/csv_line.h"

namespace jaywalk::search {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string cell(const GeneratorResults& generator, const SummaryColumn& column) {
  const MeanAndDeviation value = mean_and_deviation(generator.values(column.value));
  if (std::isnan(value.mean)) return "-";
  return fmt::format("{:.{}f} ({:.{}f})", value.mean, column.decimals, value.deviation,
                     column.decimals);
}

/// Some search has a value in the column.
bool exists(const SummaryColumn& column, const std::vector<GeneratorResults>& generators) {
  return std::ranges::any_of(generators, [&](const GeneratorResults& generator) {
    return std::ranges::any_of(generator.summaries, [&](const RunSummary& summary) {
      return !std::isnan(summary.*column.value);
    });
  });
}

/// Generators with the same number of searches.
std::vector<GeneratorPair> pairs(const std::vector<GeneratorResults>& generators) {
  std::vector<GeneratorPair> result;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    for (std::size_t j = i + 1; j < generators.size(); ++j) {
      if (generators[i].runs.size() != generators[j].runs.size()) continue;
      if (!generators[i].runs.empty()) result.push_back({&generators[i], &generators[j]});
    }
  }
  return result;
}

}  // namespace

std::vector<double> GeneratorResults::values(double RunSummary::*value) const {
  std::vector<double> all;
  for (const RunSummary& summary : summaries) all.push_back(summary.*value);
  return all;
}

TestsTo GeneratorResults::tests_to_failure() const {
  return tests_to(values(&RunSummary::tests_to_failure), values(&RunSummary::tests));
}

TestsTo GeneratorResults::tests_to_violation(std::size_t requirement) const {
  std::vector<double> needed;
  for (const RunSummary& each : summaries) needed.push_back(each.tests_to_violation[requirement]);
  return tests_to(needed, values(&RunSummary::tests));
}

std::vector<GeneratorResults> group(const SearchExperiment& experiment,
                                    const SearchResults& results) {
  std::vector<GeneratorResults> generators;
  for (const GeneratorSpec& spec : experiment.plan.generators) {
    GeneratorResults generator{spec.name, {}, {}, {}};
    const std::span<const MeasureKind> measures = experiment.plan.model_of(spec).measures();
    for (const std::size_t index : requirements_of(measures)) {
      generator.requirements.emplace_back(measures[index].requirement);
    }
    for (const SearchRun& run : results.runs) {
      if (run.generator != spec.name || !run.complete) continue;
      generator.runs.push_back(&run);
      generator.summaries.push_back(summarise(run, experiment.plan.model_of(spec)));
    }
    generators.push_back(std::move(generator));
  }
  return generators;
}

std::vector<ResultRow> result_rows(const std::vector<GeneratorResults>& generators) {
  std::vector<ResultRow> rows;
  for (const SummaryColumn& column : summary_columns()) {
    if (!exists(column, generators)) continue;
    rows.push_back({column.title, {}});
    for (const GeneratorResults& generator : generators) {
      rows.back().cells.push_back(generator.runs.empty() ? "-" : cell(generator, column));
    }
  }
  return rows;
}

std::vector<ResultRow> first_rows(const std::vector<GeneratorResults>& generators) {
  std::vector<ResultRow> rows{{"a failing test", {}}};
  for (const GeneratorResults& generator : generators) {
    const bool ran = !generator.runs.empty();
    rows.front().cells.push_back(ran ? text_of(generator.tests_to_failure()) : "-");
  }
  if (generators.empty()) return rows;
  const std::vector<std::string>& requirements = generators.front().requirements;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    rows.push_back({requirements[i], {}});
    for (const GeneratorResults& generator : generators) {
      const bool ran = !generator.runs.empty();
      rows.back().cells.push_back(ran ? text_of(generator.tests_to_violation(i)) : "-");
    }
  }
  return rows;
}

std::vector<const SummaryColumn*> tested_columns(const std::vector<GeneratorResults>& generators) {
  std::vector<const SummaryColumn*> columns;
  for (const SummaryColumn& column : summary_columns()) {
    if (column.kind == SummaryColumn::Kind::tested && exists(column, generators))
      columns.push_back(&column);
  }
  return columns;
}

double GeneratorPair::p(double RunSummary::*value) const {
  return wilcoxon_signed_rank(first->values(value), second->values(value));
}

std::vector<GeneratorPair> compared(const std::vector<GeneratorResults>& generators) {
  std::vector<GeneratorPair> all = pairs(generators);
  if (!all.empty() && all.front().first->runs.size() < 2) all.clear();
  return all;
}

namespace {

std::string rendered_rows(std::string_view head, const std::vector<GeneratorResults>& generators,
                          const std::vector<ResultRow>& rows) {
  constexpr std::size_t kTitle = 28;
  std::string text = fmt::format("{:<{}}", head, kTitle);
  for (const GeneratorResults& generator : generators) {
    text += fmt::format("  {:>16}", generator.name);
  }
  text += '\n';
  for (const ResultRow& row : rows) {
    text += fmt::format("{:<{}}", row.title, kTitle);
    for (const std::string& cell : row.cells) text += fmt::format("  {:>16}", cell);
    text += '\n';
  }
  return text;
}

}  // namespace

std::string render_table(const std::vector<GeneratorResults>& generators) {
  std::string text =
      rendered_rows("mean (standard deviation)", generators, result_rows(generators)) + '\n' +
      rendered_rows("searches with, median tests", generators, first_rows(generators));
  const std::vector<GeneratorPair> tested = compared(generators);
  if (tested.empty()) return text;
  text += fmt::format("\n{:<32}", "Wilcoxon signed-rank, p");
  const std::vector<const SummaryColumn*> columns = tested_columns(generators);
  for (const SummaryColumn* column : columns) text += fmt::format("  {:>26}", column->title);
  text += '\n';
  for (const GeneratorPair& pair : tested) {
    text += fmt::format("{:<32}", fmt::format("{} / {}", pair.first->name, pair.second->name));
    for (const SummaryColumn* column : columns) {
      text += fmt::format("  {:>26.2g}", pair.p(column->value));
    }
    text += '\n';
  }
  return text;
}

std::string to_csv(const std::vector<GeneratorResults>& generators) {
  std::string text = "generator,repetition,seed";
  for (const SummaryColumn& column : summary_columns()) text += fmt::format(",{}", column.name);
  if (!generators.empty()) {
    for (const std::string& each : generators.front().requirements) {
      text += fmt::format(",tests_to_violate_{}", each);
    }
  }
  text += '\n';
  for (const GeneratorResults& generator : generators) {
    for (std::size_t i = 0; i < generator.runs.size(); ++i) {
      const SearchRun& run = *generator.runs[i];
      text += fmt::format("{},{},{}", csv_quoted(generator.name), run.repetition, run.seed);
      const RunSummary& summary = generator.summaries[i];
      std::vector<double> values;
      for (const SummaryColumn& column : summary_columns()) {
        values.push_back(summary.*column.value);
      }
      values.insert(values.end(), summary.tests_to_violation.begin(),
                    summary.tests_to_violation.end());
      for (const double value : values) {
        text += std::isnan(value) ? "," : fmt::format(",{:.6g}", value);
      }
      text += '\n';
    }
  }
  return text;
}

namespace {

OrderedJson test_json(const TestRow& row, const SutModel& model) {
  OrderedJson json{{"form", std::string(name(row.test.input.form))},
                   {"input", row.test.input.values},
                   {"fitness", row.test.fitness},
                   {"failed", row.test.failed},
                   {"simulated_s", row.test.outcome.simulated_s},
                   {"measures", row.test.outcome.measures},
                   {"candidates", row.candidates},
                   {"invalid", row.invalid}};
  if (model.road_space() == nullptr) json["described"] = model.space().describe(row.test.input);
  if (!row.test.outcome.error.empty()) json["error"] = row.test.outcome.error;
  if (!row.test.outcome.refused.empty()) json["refused"] = row.test.outcome.refused;
  return json;
}

OrderedJson tests_to_json(const TestsTo& found) {
  return {{"found", found.found},
          {"searches", found.searches},
          {"median_tests", found.median ? OrderedJson(*found.median) : OrderedJson(nullptr)}};
}

OrderedJson generator_json(const GeneratorResults& generator, const SutModel& model) {
  OrderedJson json{{"name", generator.name},
                   {"summary", OrderedJson::object()},
                   {"first_failure", tests_to_json(generator.tests_to_failure())},
                   {"requirements", OrderedJson::object()},
                   {"searches", OrderedJson::array()}};
  for (const SummaryColumn& column : summary_columns()) {
    const MeanAndDeviation value = mean_and_deviation(generator.values(column.value));
    json["summary"][std::string(column.name)] = {{"mean", value.mean}, {"sd", value.deviation}};
  }
  for (std::size_t i = 0; i < generator.requirements.size(); ++i) {
    json["requirements"][generator.requirements[i]] =
        tests_to_json(generator.tests_to_violation(i));
  }
  for (const SearchRun* run : generator.runs) {
    OrderedJson tests = OrderedJson::array();
    for (const TestRow& row : run->tests) tests.push_back(test_json(row, model));
    json["searches"].push_back({{"repetition", run->repetition},
                                {"seed", run->seed},
                                {"virtual_s", run->spent_s},
                                {"tests", std::move(tests)}});
  }
  return json;
}

}  // namespace

std::string to_json(const SearchExperiment& experiment,
                    const std::vector<GeneratorResults>& generators) {
  OrderedJson measures = OrderedJson::array();
  for (const MeasureKind& measure : experiment.plan.model->measures()) {
    measures.push_back(std::string(measure.name));
  }
  const Fitness& fitness = experiment.plan.fitness;
  OrderedJson json{{"experiment", experiment.name},
                   {"sut", experiment.sut},
                   {"seed", experiment.plan.seed},
                   {"repetitions", experiment.plan.repetitions},
                   {"fitness",
                    {{"measure", experiment.measure},
                     {"harmless", fitness.harmless},
                     {"worst", fitness.worst},
                     {"fails_at", fitness.fails_at}}},
                   {"measures", std::move(measures)},
                   {"generators", OrderedJson::array()},
                   {"comparisons", OrderedJson::array()}};
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const SutModel& model = experiment.plan.model_of(experiment.plan.generators[i]);
    json["generators"].push_back(generator_json(generators[i], model));
  }
  for (const GeneratorPair& pair : pairs(generators)) {
    OrderedJson comparison{{"first", pair.first->name}, {"second", pair.second->name}};
    for (const SummaryColumn* column : tested_columns(generators)) {
      comparison[fmt::format("p_{}", column->name)] = pair.p(column->value);
    }
    json["comparisons"].push_back(std::move(comparison));
  }
  return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

}  // namespace jaywalk::search

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

std::vector<GeneratorResults> group(const SearchExperiment& experiment,
                                    const SearchResults& results) {
  std::vector<GeneratorResults> generators;
  for (const GeneratorSpec& spec : experiment.plan.generators) {
    GeneratorResults generator{spec.name, {}, {}};
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

std::string render_table(const std::vector<GeneratorResults>& generators) {
  constexpr std::size_t kTitle = 28;
  std::string text = fmt::format("{:<{}}", "mean (standard deviation)", kTitle);
  for (const GeneratorResults& generator : generators) {
    text += fmt::format("  {:>16}", generator.name);
  }
  text += '\n';
  for (const ResultRow& row : result_rows(generators)) {
    text += fmt::format("{:<{}}", row.title, kTitle);
    for (const std::string& cell : row.cells) text += fmt::format("  {:>16}", cell);
    text += '\n';
  }
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
  text += '\n';
  for (const GeneratorResults& generator : generators) {
    for (std::size_t i = 0; i < generator.runs.size(); ++i) {
      const SearchRun& run = *generator.runs[i];
      text += fmt::format("{},{},{}", csv_quoted(generator.name), run.repetition, run.seed);
      for (const SummaryColumn& column : summary_columns()) {
        const double value = generator.summaries[i].*column.value;
        text += std::isnan(value) ? "," : fmt::format(",{:.6g}", value);
      }
      text += '\n';
    }
  }
  return text;
}

namespace {

OrderedJson test_json(const TestRow& row) {
  OrderedJson json{{"form", std::string(name(row.test.input.form))},
                   {"input", row.test.input.values},
                   {"fitness", row.test.fitness},
                   {"failed", row.test.failed},
                   {"simulated_s", row.test.outcome.simulated_s},
                   {"measures", row.test.outcome.measures},
                   {"candidates", row.candidates},
                   {"invalid", row.invalid}};
  if (!row.test.outcome.executed()) json["error"] = row.test.outcome.error;
  return json;
}

OrderedJson generator_json(const GeneratorResults& generator) {
  OrderedJson json{{"name", generator.name},
                   {"summary", OrderedJson::object()},
                   {"searches", OrderedJson::array()}};
  for (const SummaryColumn& column : summary_columns()) {
    const MeanAndDeviation value = mean_and_deviation(generator.values(column.value));
    json["summary"][std::string(column.name)] = {{"mean", value.mean}, {"sd", value.deviation}};
  }
  for (const SearchRun* run : generator.runs) {
    OrderedJson tests = OrderedJson::array();
    for (const TestRow& row : run->tests) tests.push_back(test_json(row));
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
  for (const GeneratorResults& generator : generators) {
    json["generators"].push_back(generator_json(generator));
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

// SPDX-License-Identifier: Apache-2.0
#include "search/report/search_page.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "interpreter/support/markup.h"
#include "search/failing_stretch.h"

namespace jaywalk::search {
namespace {

using Generators = std::vector<GeneratorResults>;

constexpr std::size_t kCurvePoints = 20;

std::vector<std::string> names_of(const Generators& generators) {
  std::vector<std::string> names;
  for (const GeneratorResults& each : generators) names.push_back(each.name);
  return names;
}

std::string results(const Generators& generators) {
  reporting::Table table;
  table.column("", reporting::Align::left);
  for (const std::string& name : names_of(generators)) table.column(escaped(name));
  for (const ResultRow& row : result_rows(generators)) {
    std::vector<std::string> cells{escaped(row.title)};
    cells.insert(cells.end(), row.cells.begin(), row.cells.end());
    table.row(std::move(cells));
  }
  std::string html =
      reporting::paragraph("Means and standard deviations; generation apart from execution.") +
      table.html();
  reporting::Table first;
  first.column("", reporting::Align::left);
  for (const std::string& name : names_of(generators)) first.column(escaped(name));
  for (const ResultRow& row : first_rows(generators)) {
    std::vector<std::string> cells{escaped(row.title)};
    cells.insert(cells.end(), row.cells.begin(), row.cells.end());
    first.row(std::move(cells));
  }
  html +=
      "<h3>Tests to the first failure</h3>\n" +
      reporting::paragraph(
          "How many searches found one, and the median number of tests to it over all searches: "
          "one that found none counts as longer than any.") +
      first.html();
  reporting::Table pairs;
  pairs.column("", reporting::Align::left);
  const std::vector<const SummaryColumn*> columns = tested_columns(generators);
  for (const SummaryColumn* column : columns) pairs.column(column->title);
  for (const GeneratorPair& pair : compared(generators)) {
    std::vector<std::string> cells{
        escaped(fmt::format("{} / {}", pair.first->name, pair.second->name))};
    for (const SummaryColumn* column : columns) {
      cells.push_back(reporting::p_value(pair.p(column->value)));
    }
    pairs.row(std::move(cells));
  }
  if (!pairs.empty()) {
    html += "<h3>Do two generators differ?</h3>\n" +
            reporting::paragraph("p-values of Wilcoxon’s signed-rank test.") + pairs.html();
  }
  return html;
}

/// A figure with a box for each generator.
std::string boxes(std::string_view x_title, const Generators& generators, double RunSummary::*value,
                  std::string_view caption) {
  std::vector<reporting::BoxGroup> groups;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    groups.push_back({.name = generators[i].name,
                      .number = i,
                      .boxes = {{"", distribution(generators[i].values(value))}}});
  }
  return reporting::figure(caption, reporting::box_plots(x_title, groups, "repetition"));
}

std::string failures(const SearchExperiment& experiment, const Generators& generators) {
  std::string figures =
      boxes("failing tests of a search", generators, &RunSummary::failures, "failing tests");
  std::string html =
      reporting::paragraph("Over the repetitions (the paper’s Figure 2): how many tests failed.");
  if (measures_stretches(*experiment.plan.model)) {
    figures += boxes("distinct failing stretches of a search, at 1 m", generators,
                     &RunSummary::distinct_1m, "distinct failing stretches");
    html += reporting::paragraph(
        "Tests that vary one failure fail often, but show little that is new. Stretches of road on "
        "which tests failed are distinct if they differ by more than 1 m somewhere from 40 m "
        "before "
        "to 10 m after the place where the car was farthest out of its lane.");
  }
  return html + reporting::legend(names_of(generators)) + reporting::gallery(figures);
}

std::string diversity(const SearchExperiment& experiment, const Generators& generators) {
  std::string html =
      reporting::paragraph("Median distance between failing tests (the paper’s Figure 3).");
  std::string figures = boxes("median distance between failing tests", generators,
                              &RunSummary::diversity, "diversity") +
                        boxes("median distance between failing tests", generators,
                              &RunSummary::unwrapped_diversity, "diversity, angles unwrapped");
  if (measures_stretches(*experiment.plan.model)) {
    html += reporting::paragraph(
        "The distance compares the directions of whole roads, so it grows with their length more "
        "than with different failures: compare generators of sequences with random sequences. The "
        "competition’s sparseness looks at the 30 m before and after each failure.");
    figures += boxes("mean of the largest edit distances", generators, &RunSummary::sparseness,
                     "sparseness of failing tests");
  }
  return html + reporting::legend(names_of(generators)) + reporting::gallery(figures);
}

/// The mean fitness in each of many equal parts of a search, over all repetitions.
reporting::PlotSeries fitness_curve(const GeneratorResults& generator, std::size_t number) {
  std::vector<double> sums(kCurvePoints);
  std::vector<double> counts(kCurvePoints);
  for (const SearchRun* run : generator.runs) {
    for (std::size_t i = 0; i < run->tests.size(); ++i) {
      const std::size_t part = i * kCurvePoints / run->tests.size();
      sums[part] += run->tests[i].test.fitness;
      counts[part] += 1;
    }
  }
  reporting::PlotSeries series{.name = generator.name, .number = number};
  for (std::size_t i = 0; i < kCurvePoints; ++i) {
    if (counts[i] == 0) continue;
    series.points.push_back(
        {.x = 100 * static_cast<double>(i + 1) / kCurvePoints, .y = sums[i] / counts[i]});
  }
  return series;
}

std::string fitness(const Generators& generators) {
  std::vector<reporting::PlotSeries> series;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    series.push_back(fitness_curve(generators[i], i));
  }
  const reporting::PlotAxes axes{.x_title = "% of the budget",
                                 .y_title = "mean fitness",
                                 .least = 0,
                                 .most = 1,
                                 .x_least = 0,
                                 .x_most = 100};
  return reporting::paragraph(fmt::format(
             "Mean over the repetitions, in each {} % of a search’s tests.", 100 / kCurvePoints)) +
         reporting::legend(names_of(generators)) +
         reporting::gallery(reporting::figure("mean fitness", reporting::curves(axes, series)));
}

/// One generator's part of the page: hidden where the legend's switch is off.
std::string of_generator(const GeneratorResults& generator, std::size_t number,
                         const std::string& html) {
  return fmt::format("<div data-series=\"{}\">\n<h3 {}>{}</h3>\n{}</div>\n", number,
                     reporting::series_attributes(number), escaped(generator.name), html);
}

std::string failing_roads(const GeneratorResults& generator, RoadPictures roads) {
  for (const SearchRun* run : generator.runs) {
    for (std::size_t i = 0; i < run->tests.size() && !roads.full(); ++i) {
      if (!run->tests[i].test.failed) continue;
      roads.add(run->tests[i], fmt::format("repetition {}, test {}", run->repetition, i));
    }
  }
  const std::string pictures = roads.html();
  return pictures.empty() ? reporting::paragraph("None.") : pictures;
}

std::string last_roads(const GeneratorResults& generator, RoadPictures roads) {
  if (generator.runs.empty()) return {};
  const std::vector<TestRow>& tests = generator.runs.front()->tests;
  const std::size_t shown = std::min(tests.size(), RoadPictures::kShown);
  for (std::size_t i = tests.size() - shown; i < tests.size(); ++i) {
    roads.add(tests[i], fmt::format("test {}, fitness {:.2f}", i, tests[i].test.fitness));
  }
  return roads.html();
}

/// The first failing tests of each generator, in words; nothing for roads, which have pictures.
std::string failing_inputs(const SearchExperiment& experiment, const Generators& generators) {
  constexpr std::size_t kShown = 8;
  const SearchPlan& plan = experiment.plan;
  if (plan.model->road_space() != nullptr) return {};
  std::string html = reporting::paragraph("The first ones of each generator.");
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const SearchSpace& space = plan.model_of(plan.generators[i]).space();
    reporting::Table table;
    table.columns({"repetition", "test"});
    table.column("input", reporting::Align::left);
    std::size_t shown = 0;
    for (const SearchRun* run : generators[i].runs) {
      for (std::size_t number = 0; number < run->tests.size() && shown < kShown; ++number) {
        const ExecutedTest& test = run->tests[number].test;
        if (!test.failed) continue;
        ++shown;
        table.row({std::to_string(run->repetition), std::to_string(number),
                   escaped(space.describe(test.input))});
      }
    }
    html +=
        of_generator(generators[i], i, shown == 0 ? reporting::paragraph("None.") : table.html());
  }
  return html;
}

/// `explanation`, then the roads of each generator.
std::string roads_of_all(std::string_view explanation, const SearchExperiment& experiment,
                         const Generators& generators,
                         std::string (*roads_of)(const GeneratorResults& generator,
                                                 RoadPictures roads)) {
  const SearchPlan& plan = experiment.plan;
  if (plan.model->road_space() == nullptr) return {};
  std::string html = reporting::paragraph(explanation);
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const SutModel& model = plan.model_of(plan.generators[i]);
    html += of_generator(generators[i], i, roads_of(generators[i], RoadPictures(model, i)));
  }
  return html;
}

std::string clusters(const SearchExperiment& experiment, const Generators& generators) {
  std::string html = reporting::paragraph(
      measures_stretches(*experiment.plan.model)
          ? "Failing tests of all repetitions, aligned in position and direction at the place "
            "where "
            "the car was farthest out of its lane: a test joins the first cluster whose founder’s "
            "road differs by 1 m at most from 40 m before that place to 10 m after it. Drawn are "
            "the founders of the largest clusters."
          : "Failing tests of all repetitions: a test joins the first cluster whose founder is "
            "nearer than half the median distance.");
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const SutModel& model = experiment.plan.model_of(experiment.plan.generators[i]);
    html += of_generator(generators[i], i, clusters_html(generators[i], model, i));
  }
  return html;
}

}  // namespace

std::string to_html(const SearchExperiment& experiment, const Generators& generators) {
  const std::array sections = {
      reporting::PageSection{"overview", "Overview", setup_html(experiment)},
      reporting::PageSection{"results", "Results", results(generators)},
      reporting::PageSection{"published", "Published", published_table(experiment)},
      reporting::PageSection{"failures", "Failing tests", failures(experiment, generators)},
      reporting::PageSection{"diversity", "Diversity", diversity(experiment, generators)},
      reporting::PageSection{"fitness", "Fitness over time", fitness(generators)},
      reporting::PageSection{
          "roads", "Failing roads",
          roads_of_all(
              "The first ones of each generator (the paper’s Figure 1). Tests are numbered "
              "from 0, as in stores and exported files; a dot marks where the car was "
              "farthest out of its lane.",
              experiment, generators, failing_roads)},
      reporting::PageSection{"inputs", "Failing inputs", failing_inputs(experiment, generators)},
      reporting::PageSection{
          "generated", "What the generators make",
          roads_of_all("The last tests of repetition 0 with their fitness; dots as above.",
                       experiment, generators, last_roads)},
      reporting::PageSection{"clusters", "Clusters of failures", clusters(experiment, generators)},
      reporting::PageSection{"reproduce", "How to reproduce", reproduce_html(experiment)},
  };
  return reporting::render_page("Jaywalk search report", experiment.name, sections);
}

}  // namespace jaywalk::search

#include "search/report/page.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/report/html.h"
#include "experiment/report/page.h"
#include "experiment/report/plot.h"
#include "interpreter/support/markup.h"
#include "search/report/published.h"
#include "search/report/roads.h"

namespace jaywalk::search {
namespace {

using Generators = std::vector<GeneratorResults>;

constexpr std::size_t kCurvePoints = 20;

std::vector<std::string> names_of(const Generators& generators) {
  std::vector<std::string> names;
  for (const GeneratorResults& each : generators) names.push_back(each.name);
  return names;
}

std::string settings(const SearchExperiment& experiment, const Generators& generators) {
  using reporting::term;
  const std::string names = fmt::format("{}", fmt::join(names_of(generators), ", "));
  return reporting::terms(term("system under test", escaped(experiment.sut)) +
                          term("generators", escaped(names)) +
                          term("repetitions", std::to_string(experiment.plan.repetitions)) +
                          term("seed", std::to_string(experiment.plan.seed)) +
                          term("a test fails", fmt::format("from a fitness of {} on ({})",
                                                           experiment.plan.fitness.fails_at,
                                                           escaped(experiment.measure))));
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
  reporting::Table pairs;
  pairs.column("", reporting::Align::left);
  pairs.column("failing tests");
  pairs.column("diversity");
  for (const GeneratorPair& pair : compared(generators)) {
    pairs.row({escaped(fmt::format("{} / {}", pair.first->name, pair.second->name)),
               fmt::format("{:.2g}", pair.p(&RunSummary::failures)),
               fmt::format("{:.2g}", pair.p(&RunSummary::diversity))});
  }
  if (!pairs.empty()) {
    html += "<h3>Do two generators differ?</h3>\n" +
            reporting::paragraph("p-values of Wilcoxon’s signed-rank test.") + pairs.html();
  }
  return html;
}

/// A figure with a box for each generator.
std::string boxes(std::string_view title, const Generators& generators, double RunSummary::*value) {
  std::vector<reporting::BoxGroup> groups;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    groups.push_back({.name = generators[i].name,
                      .number = i,
                      .boxes = {{"", distribution(generators[i].values(value))}}});
  }
  return reporting::figure(title, reporting::box_plots(title, groups, "repetition"));
}

std::string failures(const Generators& generators) {
  return reporting::paragraph("Over the repetitions (the paper’s Figure 2).") +
         reporting::legend(names_of(generators)) +
         reporting::gallery(boxes("failing tests", generators, &RunSummary::failures));
}

std::string diversity(const Generators& generators) {
  return reporting::paragraph("Median distance between failing tests (the paper’s Figure 3).") +
         reporting::legend(names_of(generators)) +
         reporting::gallery(
             boxes("diversity", generators, &RunSummary::diversity) +
             boxes("diversity, angles unwrapped", generators, &RunSummary::unwrapped_diversity));
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

/// What is said of one generator: hidden where the legend's switch is off.
std::string of_generator(const GeneratorResults& generator, std::size_t number,
                         const std::string& html) {
  return fmt::format("<div data-series=\"{}\">\n<h3 {}>{}</h3>\n{}</div>\n", number,
                     reporting::series_attributes(number), escaped(generator.name), html);
}

std::string failing_roads(const GeneratorResults& generator, RoadPictures roads) {
  for (const SearchRun* run : generator.runs) {
    for (std::size_t i = 0; i < run->tests.size() && !roads.full(); ++i) {
      if (!run->tests[i].test.failed) continue;
      roads.add(run->tests[i], fmt::format("run {}, test {}", run->repetition, i + 1));
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
    roads.add(tests[i], fmt::format("{:.2f}", tests[i].test.fitness));
  }
  return roads.html();
}

/// `explanation`, then the roads of each generator.
std::string roads_of_all(std::string_view explanation, const Generators& generators,
                         const RoadSpace* space,
                         std::string (*roads_of)(const GeneratorResults& generator,
                                                 RoadPictures roads)) {
  if (space == nullptr) return {};
  std::string html = reporting::paragraph(explanation);
  for (std::size_t i = 0; i < generators.size(); ++i) {
    html += of_generator(generators[i], i, roads_of(generators[i], RoadPictures(*space, i)));
  }
  return html;
}

std::string clusters_of(const GeneratorResults& generator, const SearchSpace& space,
                        std::optional<RoadPictures> roads) {
  if (generator.runs.empty()) return {};
  std::vector<const TestRow*> failing;
  std::vector<std::vector<double>> signatures;
  for (const TestRow& row : generator.runs.front()->tests) {
    if (!row.test.failed) continue;
    failing.push_back(&row);
    signatures.push_back(signature(row.test, space));
  }
  const double reach = median_distance(signatures) / 2;
  const auto groups = cluster(signatures, reach);
  std::vector<std::size_t> sizes;
  for (const auto& group : groups) {
    if (sizes.size() < 2 * RoadPictures::kShown) sizes.push_back(group.size());
  }
  std::string html = reporting::paragraph(fmt::format(
      "{} failing tests of repetition 0 in {} clusters{}.", failing.size(), groups.size(),
      sizes.empty() ? "" : fmt::format(", of {} tests", fmt::join(sizes, ", "))));
  if (!roads) return html;
  for (std::size_t i = 0; i < groups.size() && !roads->full(); ++i) {
    roads->add(*failing[groups[i].front()], fmt::format("{} tests", groups[i].size()));
  }
  return html + roads->html();
}

std::string clusters(const SearchExperiment& experiment, const Generators& generators,
                     const RoadSpace* space) {
  std::string html = reporting::paragraph(
      "A test joins the first cluster whose founder is nearer than half the median distance; the "
      "largest clusters’ founders are drawn.");
  for (std::size_t i = 0; i < generators.size(); ++i) {
    std::optional<RoadPictures> roads;
    if (space != nullptr) roads.emplace(*space, i);
    const SutModel& model = experiment.plan.model_of(experiment.plan.generators[i]);
    html += of_generator(generators[i], i, clusters_of(generators[i], model.space(), roads));
  }
  return html;
}

}  // namespace

std::string to_html(const SearchExperiment& experiment, const Generators& generators) {
  const RoadSpace* const roads = experiment.plan.model->road_space();
  const std::array sections = {
      reporting::PageSection{"overview", "Overview", settings(experiment, generators)},
      reporting::PageSection{"results", "Results", results(generators)},
      reporting::PageSection{"published", "Published", published_table(experiment)},
      reporting::PageSection{"failures", "Failing tests", failures(generators)},
      reporting::PageSection{"diversity", "Diversity", diversity(generators)},
      reporting::PageSection{"fitness", "Fitness over time", fitness(generators)},
      reporting::PageSection{
          "roads", "Failing roads",
          roads_of_all("The first ones of each generator (the paper’s Figure 1).", generators,
                       roads, failing_roads)},
      reporting::PageSection{"generated", "What the generators make",
                             roads_of_all("The last tests of repetition 0 with their fitness.",
                                          generators, roads, last_roads)},
      reporting::PageSection{"clusters", "Clusters of failures",
                             clusters(experiment, generators, roads)},
  };
  return reporting::render_page("Jaywalk search report", experiment.name, sections);
}

}  // namespace jaywalk::search

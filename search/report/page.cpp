#include "search/report/page.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "env/lane/road.h"
#include "interpreter/support/markup.h"
#include "search/report/svg.h"
#include "search/suts/road_space.h"

namespace jaywalk::search {
namespace {

constexpr std::size_t kShownRoads = 8;
constexpr std::size_t kCurvePoints = 40;

/// Table 1 of Peltomäki, Spencer and Porres 2022: means and standard deviations over 20 runs.
struct Published {
  std::string_view quantity;
  std::string_view random;
  std::string_view wogan;
  std::string_view frenetic;
};
constexpr std::array kPublished = {
    Published{"executed tests", "337.7 (2.28)", "253.8 (14.54)", "201.25 (11.56)"},
    Published{"failing tests", "8.70 (3.81)", "31.30 (11.61)", "21.50 (6.74)"},
    Published{"mean fitness, final 80 %", "0.25 (0.01)", "0.50 (0.04)", "0.65 (0.03)"},
    Published{"mean fitness, final 20 %", "0.26 (0.03)", "0.59 (0.03)", "0.68 (0.04)"},
    Published{"diversity of failing tests", "16.41 (4.66)", "11.51 (4.59)", "16.85 (2.05)"},
};

std::string section(std::string_view title, std::string_view text, const std::string& content) {
  return fmt::format("<h2>{}</h2>\n<p>{}</p>\n{}", escaped(title), escaped(text), content);
}

std::string published_table() {
  std::string html = "<table><tr><th></th><th>Random</th><th>WOGAN</th><th>Frenetic</th></tr>\n";
  for (const Published& row : kPublished) {
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", row.quantity,
                        row.random, row.wogan, row.frenetic);
  }
  return html + "</table>\n";
}

std::string boxes(std::string_view title, const std::vector<GeneratorResults>& generators,
                  double RunSummary::*value) {
  std::vector<Distribution> distributions;
  for (const GeneratorResults& each : generators) {
    distributions.push_back({each.name, each.values(value)});
  }
  return box_plots(title, distributions);
}

/// The mean fitness in each of many equal parts of a search, over all repetitions.
Curve fitness_curve(const GeneratorResults& generator) {
  std::vector<double> sums(kCurvePoints);
  std::vector<double> counts(kCurvePoints);
  for (const SearchRun* run : generator.runs) {
    for (std::size_t i = 0; i < run->tests.size(); ++i) {
      const std::size_t part = i * kCurvePoints / run->tests.size();
      sums[part] += run->tests[i].test.fitness;
      counts[part] += 1;
    }
  }
  for (std::size_t i = 0; i < kCurvePoints; ++i) sums[i] /= std::max(1.0, counts[i]);
  return {generator.name, std::move(sums)};
}

/// Pictures of tests.
class Roads {
 public:
  Roads(const RoadSpace& space, std::string_view stroke) : space_(space), stroke_(stroke) {}

  void add(const TestRow& row, std::string caption) {
    roads_.push_back(
        lane::interpolate(space_.road_points(row.test.input)).value_or(lane::Polyline{}));
    captions_.push_back(std::move(caption));
  }
  [[nodiscard]] bool full() const { return roads_.size() >= kShownRoads; }
  [[nodiscard]] std::string svg() const {
    return road_pictures(roads_, captions_, space_.settings().rules.map_m, stroke_);
  }

 private:
  const RoadSpace& space_;
  std::string_view stroke_;
  std::vector<std::vector<Point>> roads_;
  std::vector<std::string> captions_;
};

std::string failing_roads(const GeneratorResults& generator, const RoadSpace& space,
                          std::string_view stroke) {
  Roads roads(space, stroke);
  for (const SearchRun* run : generator.runs) {
    for (std::size_t i = 0; i < run->tests.size() && !roads.full(); ++i) {
      if (!run->tests[i].test.failed) continue;
      roads.add(run->tests[i], fmt::format("run {}, test {}", run->repetition, i + 1));
    }
  }
  return fmt::format("<h3>{}</h3>\n{}", escaped(generator.name), roads.svg());
}

std::string last_tests(const GeneratorResults& generator, const RoadSpace& space,
                       std::string_view stroke) {
  if (generator.runs.empty()) return {};
  Roads roads(space, stroke);
  const std::vector<TestRow>& tests = generator.runs.front()->tests;
  for (std::size_t i = tests.size() - std::min(tests.size(), kShownRoads); i < tests.size(); ++i) {
    roads.add(tests[i], fmt::format("{:.2f}", tests[i].test.fitness));
  }
  return fmt::format("<h3>{}</h3>\n{}", escaped(generator.name), roads.svg());
}

std::string clusters(const GeneratorResults& generator, const SearchSpace& space,
                     const RoadSpace* roads_space, std::string_view stroke) {
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
  std::string html = fmt::format("<h3>{}</h3>\n<p>{} failing tests of repetition 0 in {} clusters",
                                 escaped(generator.name), failing.size(), groups.size());
  html += groups.empty() ? ".</p>\n" : ", of";
  for (std::size_t i = 0; i < std::min(groups.size(), 2 * kShownRoads); ++i) {
    html += fmt::format(" {}", groups[i].size());
  }
  if (!groups.empty()) html += " tests.</p>\n";
  if (roads_space == nullptr) return html;
  Roads roads(*roads_space, stroke);
  for (std::size_t i = 0; i < groups.size() && !roads.full(); ++i) {
    roads.add(*failing[groups[i].front()], fmt::format("{} tests", groups[i].size()));
  }
  return html + roads.svg();
}

}  // namespace

std::string to_html(const SearchExperiment& experiment,
                    const std::vector<GeneratorResults>& generators) {
  const RoadSpace* roads = experiment.plan.model->road_space();
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Jaywalk: {0}</title>\n"
      "<style>body{{font-family:system-ui,sans-serif;max-width:1040px;margin:2em auto;"
      "padding:0 1em;color:#222}}svg{{max-width:100%;height:auto}}pre{{overflow-x:auto;"
      "font-size:12px}}table{{border-collapse:collapse}}td,th{{padding:.2em .8em;"
      "border-bottom:1px solid #ddd;text-align:left}}</style>\n"
      "<h1>{0}</h1>\n<p>System under test: {1}. {2} repetitions, seed {3}; a test fails from a "
      "fitness of {4} on ({5}).</p>\n",
      escaped(experiment.name), escaped(experiment.sut), experiment.plan.repetitions,
      experiment.plan.seed, experiment.plan.fitness.fails_at, escaped(experiment.measure));
  html += section("Results", "Means and standard deviations; generation apart from execution.",
                  fmt::format("<pre>{}</pre>\n", escaped(render_table(generators))));
  if (roads != nullptr) {
    html += section("Published",
                    "Table 1 of Peltomäki, Spencer and Porres, SBST 2022, for BeamNG.tech.",
                    published_table());
    std::string pictures;
    for (std::size_t i = 0; i < generators.size(); ++i) {
      pictures += failing_roads(generators[i], *roads, colour(i));
    }
    html += section("Failing roads", "The first ones of each generator (the paper's Figure 1).",
                    pictures);
  }
  html += section("Failing tests", "Over the repetitions (the paper's Figure 2).",
                  boxes("failing tests", generators, &RunSummary::failures));
  html += section(
      "Diversity", "Median distance between failing tests (the paper's Figure 3).",
      boxes("diversity", generators, &RunSummary::diversity) +
          boxes("diversity, angles unwrapped", generators, &RunSummary::unwrapped_diversity));
  std::vector<Curve> lines;
  for (const GeneratorResults& each : generators) lines.push_back(fitness_curve(each));
  html += section("Fitness over time", "Mean over the repetitions; the budget from left to right.",
                  curves("mean fitness", lines));
  if (roads != nullptr) {
    std::string pictures;
    for (std::size_t i = 0; i < generators.size(); ++i) {
      pictures += last_tests(generators[i], *roads, colour(i));
    }
    html += section("What the generators make",
                    "The last tests of repetition 0 with their fitness.", pictures);
  }
  std::string groups;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const GeneratorSpec& spec = experiment.plan.generators[i];
    groups += clusters(generators[i], experiment.plan.model_of(spec).space(), roads, colour(i));
  }
  html += section("Clusters of failures",
                  "A test joins the first cluster whose founder is nearer than half the median "
                  "distance; the largest clusters' founders are drawn.",
                  groups);
  return html + "</html>\n";
}

}  // namespace jaywalk::search

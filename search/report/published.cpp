// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "env/lane/drive.h"
#include "experiment/report/html.h"
#include "search/report/search_page.h"
#include "search/suts/road_space.h"

namespace jaywalk::search {
namespace {

/// Table 1 of Peltomäki, Spencer and Porres 2022: means and standard deviations over 20 runs.
struct PublishedRow {
  std::string_view quantity;
  std::string_view random;
  std::string_view wogan;
  std::string_view frenetic;
};
constexpr std::array kPublishedRows = {
    PublishedRow{"executed tests", "337.7 (2.28)", "253.8 (14.54)", "201.25 (11.56)"},
    PublishedRow{"failing tests", "8.70 (3.81)", "31.30 (11.61)", "21.50 (6.74)"},
    PublishedRow{"mean fitness, final 80 %", "0.25 (0.01)", "0.50 (0.04)", "0.65 (0.03)"},
    PublishedRow{"mean fitness, final 20 %", "0.26 (0.03)", "0.59 (0.03)", "0.68 (0.04)"},
    PublishedRow{"diversity of failing tests", "16.41 (4.66)", "11.51 (4.59)", "16.85 (2.05)"},
};

// Settings of the published experiment.
constexpr double kPublishedFailsAt = 0.95;
constexpr double kPublishedBudgetS = 7200;
// The car's program was configured with it, so that it limits nothing.
constexpr double kPublishedSpeedMps = 300 / 3.6;

bool equal(double left, double right) { return std::abs(left - right) < 1e-9; }

bool has_published_budget(const Budget& budget) {
  return budget.tests == 0 && budget.failures == 0 && equal(budget.virtual_s, kPublishedBudgetS);
}

bool drives_as_published(const SutModel& model) {
  const lane::DriveSettings* const drive = model.drive();
  return drive != nullptr && equal(drive->speed_limit_mps, kPublishedSpeedMps) &&
         equal(drive->tolerance, kPublishedFailsAt);
}

bool searches_published_roads(const SutModel& model) {
  const RoadSpace* const roads = model.road_space();
  return roads != nullptr && roads->settings() == RoadSpaceSettings{};
}

}  // namespace

bool is_as_published(const SearchExperiment& experiment) {
  const SearchPlan& plan = experiment.plan;
  const Fitness& fitness = plan.fitness;
  const bool models = std::ranges::all_of(plan.generators, [&](const GeneratorSpec& generator) {
    return drives_as_published(plan.model_of(generator));
  });
  return models && drives_as_published(*plan.model) && searches_published_roads(*plan.model) &&
         experiment.measure == "max_oob" && fitness.harmless == 0 && fitness.worst == 1 &&
         equal(fitness.fails_at, kPublishedFailsAt) && has_published_budget(plan.budget);
}

std::string published_table(const SearchExperiment& experiment) {
  if (experiment.plan.model->road_space() == nullptr) return {};
  if (!is_as_published(experiment)) {
    return reporting::paragraph(
        "Left out: the published results are of roads that fail from 95 % of the car out of its "
        "lane on, without a speed limit, within two hours; this search is set up otherwise.");
  }
  reporting::Table table;
  table.column("", reporting::Align::left);
  table.columns({"Random", "WOGAN", "Frenetic"});
  for (const PublishedRow& row : kPublishedRows) {
    table.row({std::string(row.quantity), std::string(row.random), std::string(row.wogan),
               std::string(row.frenetic)});
  }
  return reporting::paragraph(
             "Table 1 of Peltomäki, Spencer and Porres, SBST 2022, for BeamNG.tech.") +
         table.html();
}

}  // namespace jaywalk::search

// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "env/lane/validity.h"
#include "experiment/scenario/files/write_file.h"
#include "search/export/exports.h"
#include "search/suts/road_space.h"

namespace jaywalk::search {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson point_list(const lane::Polyline& points) {
  OrderedJson list = OrderedJson::array();
  for (const Point& point : points) list.push_back(OrderedJson::array({point.x_m, point.y_m}));
  return list;
}

}  // namespace

std::string to_competition_json(const TestRow& row, const lane::Polyline& points, std::size_t id) {
  const lane::RoadVerdict verdict = lane::validate(points);
  const ExecutedTest& test = row.test;
  const char* outcome = !test.outcome.executed() ? "ERROR" : test.failed ? "FAIL" : "PASS";
  const OrderedJson json{{"id", id},
                         {"is_valid", verdict.valid()},
                         {"validation_message", std::string(verdict.message)},
                         {"road_points", point_list(points)},
                         {"interpolated_points",
                          verdict.road ? point_list(verdict.road->middle) : OrderedJson::array()},
                         {"test_outcome", outcome},
                         {"description", fmt::format("fitness {:.4f}", test.fitness)},
                         {"execution_data", OrderedJson::array()}};
  return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

std::optional<std::string> export_failures(const std::string& folder,
                                           const SearchExperiment& experiment,
                                           const SearchResults& results) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fmt::format("cannot make the folder '{}': {}", folder, error.message());
  std::size_t index = 0;
  for (const SearchRun& run : results.runs) {
    const GeneratorSpec& spec = experiment.plan.generators[index++ / experiment.plan.repetitions];
    const RoadSpace* space = experiment.plan.model_of(spec).road_space();
    if (space == nullptr) return "only roads can be exported";
    const lane::DriveSettings* const simulated = experiment.plan.model_of(spec).drive();
    const lane::DriveSettings drive = simulated ? *simulated : lane::DriveSettings{};
    for (std::size_t i = 0; i < run.tests.size(); ++i) {
      if (!run.tests[i].test.failed) continue;
      const lane::Polyline points = space->road_points(run.tests[i].test.input);
      const std::string path =
          output_path(folder, fmt::format("{}-{:02}-{:04}", run.generator, run.repetition, i));
      const std::string stem = std::filesystem::path(path).filename().string();
      const std::pair<std::string, std::string> files[] = {
          {".xodr", to_opendrive(points, stem)},
          {".xosc", to_openscenario(points, stem + ".xodr", drive)},
          {".json", to_competition_json(run.tests[i], points, i)}};
      for (const auto& [ending, text] : files) {
        if (const auto why = write_file(path + ending, text, Links::replaced)) return why;
      }
    }
  }
  return std::nullopt;
}

}  // namespace jaywalk::search

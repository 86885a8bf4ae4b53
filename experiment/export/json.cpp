#include "experiment/export/json.h"

#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

#include "experiment/measures/measures.h"
#include "experiment/published/published.h"

namespace jaywalk {
namespace {

using Json = nlohmann::ordered_json;

void add_number(Json& object, std::string_view name, std::optional<double> value) {
  if (name.empty()) return;
  object[std::string(name)] = value ? Json(*value) : Json(nullptr);
}

void add_estimate(Json& object, const Measure& measure, const Estimate& estimate) {
  add_number(object, measure.column, estimate.value);
  add_number(object, measure.low_column, estimate.low);
  add_number(object, measure.high_column, estimate.high);
}

Json to_object(const Summary& summary) {
  Json object = {{"behaviour", summary.behaviour},
                 {"agents", summary.agents},
                 {"tests", summary.tests},
                 {"successes", summary.successes}};
  Json published = Json::object();
  for (const Measure& measure : measures()) {
    add_estimate(object, measure, measure.estimate(summary));
    const auto figure = published_figure(measure, summary.behaviour, summary.agents);
    if (figure) add_estimate(published, measure, *figure);
  }
  if (!published.empty()) object["published"] = std::move(published);
  return object;
}

}  // namespace

std::string to_json(const Comparison& comparison) {
  Json results = Json::array();
  for (const Summary& summary : comparison.summaries) results.push_back(to_object(summary));
  const Json document = {{"scenario", comparison.scenario},
                         {"seed", comparison.seed},
                         {"tests", comparison.tests},
                         {"complete", comparison.complete},
                         {"results", std::move(results)}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace jaywalk

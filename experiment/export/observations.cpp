// SPDX-License-Identifier: Apache-2.0
// Tests as rows and as objects: CSV and JSON.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/export/exporter.h"
#include "experiment/judge/csv_line.h"

namespace jaywalk {
namespace {

std::string rows(const StoredTest& test, const std::string& behaviour, const Recording& recording) {
  std::string text;
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    const auto scene = recording.scene(tick);
    for (std::size_t i = 0; i < scene.size(); ++i) {
      const Actor& actor = recording.actors()[i];
      text += fmt::format("{},{},{},{},{:.6g},{},{},{:.4f},{:.4f},{:.4f},{:.6f}\n",
                          csv_quoted(behaviour), test.test.agents, test.test.number, tick,
                          static_cast<double>(tick) * recording.tick_s(), csv_quoted(actor.name),
                          name(actor.kind), scene[i].x_m, scene[i].y_m, scene[i].speed_mps,
                          scene[i].heading_rad);
    }
  }
  return text;
}

nlohmann::json to_json(const StoredTest& test, const std::string& behaviour,
                       const Recording& recording) {
  nlohmann::json actors = nlohmann::json::array();
  for (const Actor& actor : recording.actors()) {
    actors.push_back({{"name", actor.name},
                      {"kind", std::string(name(actor.kind))},
                      {"length_m", actor.length_m},
                      {"width_m", actor.width_m}});
  }
  nlohmann::json scenes = nlohmann::json::array();
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    nlohmann::json scene = nlohmann::json::array();
    for (const ActorState& state : recording.scene(tick)) {
      scene.push_back({state.x_m, state.y_m, state.speed_mps, state.heading_rad});
    }
    scenes.push_back(std::move(scene));
  }
  nlohmann::json events = nlohmann::json::array();
  for (const RecordedEvent& event : recording.events()) {
    nlohmann::json entry{{"tick", event.tick}, {"kind", event.kind}, {"text", event.text}};
    if (event.actor) entry["actor"] = recording.actors()[*event.actor].name;
    events.push_back(std::move(entry));
  }
  return {{"behaviour", behaviour},
          {"agents", test.test.agents},
          {"test", test.test.number},
          {"tick_s", recording.tick_s()},
          {"precondition_met", test.result.succeeded},
          {"actors", std::move(actors)},
          {"state", {"x_m", "y_m", "speed_mps", "heading_rad"}},
          {"scenes", std::move(scenes)},
          {"events", std::move(events)}};
}

struct SeenTest {
  StoredTest test;
  std::string behaviour;
  Recording recording;
};

/// Nothing after adding an error.
std::optional<SeenTest> seen_test(const ResultsReader& store, std::int64_t id,
                                  Diagnostics& diagnostics) {
  auto test = store.test(id);
  auto recording = test ? store.recording(id) : Result<Recording>(test.diagnostics());
  if (!recording) {
    diagnostics.append(recording.diagnostics());
    return std::nullopt;
  }
  return SeenTest{.test = test.value(),
                  .behaviour = store.description().behaviours[test.value().test.behaviour].name,
                  .recording = std::move(recording).value()};
}

}  // namespace

ExportedFiles export_csv(const ExportRequest& request) {
  Exported exported;
  Diagnostics diagnostics;
  const auto text = [&](const TextSink& sink) {
    sink("behaviour,agents,test,tick,time_s,actor,kind,x_m,y_m,speed_mps,heading_rad\n");
    for (const std::int64_t id : request.tests) {
      const auto test = seen_test(request.store, id, diagnostics);
      if (!test) return false;
      sink(rows(test->test, test->behaviour, test->recording));
    }
    return true;
  };
  if (!write_export(request, "observations.csv", text, exported.files, diagnostics)) {
    return diagnostics;
  }
  return exported;
}

ExportedFiles export_json(const ExportRequest& request) {
  Exported exported;
  Diagnostics diagnostics;
  for (const std::int64_t id : request.tests) {
    const auto test = seen_test(request.store, id, diagnostics);
    if (!test) return diagnostics;
    const std::string text = to_json(test->test, test->behaviour, test->recording)
                                 .dump(1, ' ', false, nlohmann::json::error_handler_t::replace) +
                             '\n';
    const std::string name = file_stem(request.store, test->test.test) + ".json";
    if (!write_export(request, name, text, exported.files, diagnostics)) return diagnostics;
  }
  return exported;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/player/player.h"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/report/player/player.html.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/agent/agent.h"
#include "interpreter/support/markup.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

using nlohmann::json;

/// Enough digits for a picture: a millimetre.
double rounded(double value) { return std::round(value * 1000) / 1000; }

/// Stretches of cells whose surface differs from their band.
json patches(const GroundPlan& plan) {
  json result = json::array();
  for (int row = 0; row < plan.grid.rows; ++row) {
    const bool pavement = plan.band_of(row).kind == AreaKind::pavement;
    const Surface usual = pavement ? Surface::pavement : Surface::lane;
    for (int y = 0; y < plan.grid.cells;) {
      const Surface here = plan.at({row, y});
      int end = y + 1;
      while (end < plan.grid.cells && plan.at({row, end}) == here) ++end;
      if (here != usual) result.push_back({std::string(name(here)), row, y, 1, end - y});
      y = end;
    }
  }
  return result;
}

json world(const GroundPlan& plan) {
  json bands = json::array();
  for (const PlanBand& band : plan.bands) {
    bands.push_back(
        {{"kind", band.kind == AreaKind::pavement ? "pavement" : "lane"}, {"rows", band.rows}});
  }
  return {{"rows", plan.grid.rows},
          {"cells", plan.grid.cells},
          {"cell_m", plan.cell_m},
          {"bands", std::move(bands)},
          {"patches", patches(plan)}};
}

json scenes(const Recording& recording) {
  json result = json::array();
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    json scene = json::array();
    for (const ActorState& state : recording.scene(tick)) {
      scene.push_back({rounded(state.x_m), rounded(state.y_m), rounded(state.speed_mps),
                       rounded(state.heading_rad)});
    }
    result.push_back(std::move(scene));
  }
  return result;
}

json actors(const Recording& recording) {
  json result = json::array();
  for (const Actor& actor : recording.actors()) {
    result.push_back({{"name", actor.name},
                      {"kind", std::string(name(actor.kind))},
                      {"length_m", actor.length_m},
                      {"width_m", actor.width_m}});
  }
  return result;
}

json events(const Recording& recording) {
  json result = json::array();
  for (const RecordedEvent& event : recording.events()) {
    json entry{{"tick", event.tick}, {"kind", event.kind}, {"text", event.text}};
    if (event.actor) entry["actor"] = *event.actor;
    result.push_back(std::move(entry));
  }
  return result;
}

json to_json(const MindRecorder& recorder) {
  json result = json::array();
  for (const auto& tick : recorder.minds()) {
    json agents = json::array();
    for (const MindRecorder::Mind& mind : tick) {
      agents.push_back(
          {{"intentions", mind.intentions}, {"beliefs", mind.beliefs}, {"plans", mind.plans}});
    }
    result.push_back(std::move(agents));
  }
  return result;
}

}  // namespace

std::vector<std::size_t> MindRecorder::intern(const std::vector<std::string>& texts) {
  std::vector<std::size_t> result;
  for (const std::string& text : texts) {
    const auto [found, is_new] = numbers_.try_emplace(text, texts_.size());
    if (is_new) texts_.push_back(text);
    result.push_back(found->second);
  }
  return result;
}

void MindRecorder::observe(const Mas& mas) {
  std::vector<Mind>& minds = minds_.emplace_back();
  for (std::size_t i = 0; i < mas.agent_count(); ++i) {
    const auto id = static_cast<AgentId>(i);
    Mind& mind = minds.emplace_back();
    if (!mas.is_alive(id)) continue;
    mind.intentions = intern(mas.describe_intentions(id));
    mind.beliefs = intern(mas.describe_beliefs(id));
    mind.plans = intern(chosen_[static_cast<std::uint32_t>(i)]);
  }
  chosen_.clear();
}

void MindRecorder::plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                               const Intention&) {
  if (plan.is_standard) return;
  chosen_[agent.number()].push_back(
      fmt::format("{}: {}:{}", agent.trigger_text(event),
                  std::filesystem::path(plan.file).filename().string(), plan.line));
}

std::string render_player(const std::string& title, const GroundPlan& plan,
                          const Recording& recording, const MindRecorder& minds,
                          const std::optional<Recording>& twin) {
  const json data{{"title", title},
                  {"tick_s", recording.tick_s()},
                  {"world", world(plan)},
                  {"actors", actors(recording)},
                  {"scenes", scenes(recording)},
                  {"twin", twin ? scenes(*twin) : json::array()},
                  {"events", events(recording)},
                  {"texts", minds.texts()},
                  {"minds", to_json(minds)}};
  constexpr std::string_view kPlace = "/*DATA*/null";
  std::string page(kPlayerHtml);
  page.replace(page.find(kPlace), kPlace.size(),
               in_script(data.dump(-1, ' ', false, json::error_handler_t::replace)));
  return page;
}

std::string name_of(const ResultsReader& store, const StoredTest& test) {
  const ExperimentDescription& of = store.description();
  std::string name =
      fmt::format("{}, {}, seed {}, test {}", of.behaviours[test.test.behaviour].name,
                  counted(test.test.agents, "agent"), of.seed, test.test.number);
  if (of.vehicles.size() > 1) name += fmt::format(", AV {}", of.vehicles[test.test.vehicle]);
  return name;
}

Result<std::optional<Recording>> twin_recording(const ResultsReader& store,
                                                const StoredTest& test) {
  if (test.test.vehicle == 0) return std::optional<Recording>();
  auto twin = store.recording(twin_id(store.description(), test.test));
  if (!twin) return std::move(twin.diagnostics());
  return std::optional<Recording>(std::move(twin).value());
}

Result<std::string> replay_page(const ResultsReader& store, const StoredTest& test) {
  auto prepared = store.prepared();
  if (!prepared) return std::move(prepared.diagnostics());
  Recording recording;
  MindRecorder minds;
  TestOptions options;
  options.record = &recording;
  options.observer = &minds;
  options.observe = [&](const World&, const Mas& mas) { minds.observe(mas); };
  auto result = store.rerun(test.id, options);
  if (!result) return std::move(result.diagnostics());
  const auto twin = twin_recording(store, test);
  if (!twin) return twin.diagnostics();
  return render_player(name_of(store, test), prepared.value()->scenario().world->plan(), recording,
                       minds, twin.value());
}

}  // namespace jaywalk

#include "env/simulator/process/messages.h"

#include <string>
#include <string_view>
#include <utility>

#include "env/process/tidy.h"

namespace jaywalk {
namespace {

using nlohmann::json;

json state_json(const ActorState& state) {
  return {{"x", tidy(state.x_m)},
          {"y", tidy(state.y_m)},
          {"heading", tidy(state.heading_rad)},
          {"speed", tidy(state.speed_mps)}};
}

json actor_json(const Actor& actor, const ActorState& state) {
  json described = state_json(state);
  described["name"] = actor.name;
  described["kind"] = std::string(name(actor.kind));
  described["length"] = tidy(actor.length_m);
  described["width"] = tidy(actor.width_m);
  return described;
}

std::string_view word(AreaKind kind) { return kind == AreaKind::lane ? "lane" : "pavement"; }

json crosswalk_json(const GroundCrosswalk& crosswalk) {
  json parts = json::array();
  for (const Rectangle& each : crosswalk.parts) {
    parts.push_back(
        {{"across", tidy_pair(each.left, each.right)}, {"along", tidy_pair(each.near, each.far)}});
  }
  return {{"kind", crosswalk.zebra ? "zebra" : "signalled"},
          {"begins", tidy(crosswalk.begins_m)},
          {"parts", std::move(parts)},
          {"signals", crosswalk.signals}};
}

json road_json(const SimulatedRoad& road) {
  json described{{"length", tidy(road.length_m)},
                 {"bands", json::array()},
                 {"areas", json::array()},
                 {"obstacles", json::array()},
                 {"crosswalks", json::array()}};
  for (const RoadBand& each : road.bands) {
    described["bands"].push_back({{"kind", word(each.kind)},
                                  {"across", tidy_pair(each.left_m, each.right_m)},
                                  {"oncoming", each.oncoming}});
  }
  for (const Area& each : road.ground.areas) {
    json corners = json::array();
    for (const Point point : each.corners) corners.push_back(tidy_pair(point.x_m, point.y_m));
    described["areas"].push_back(
        {{"kind", word(each.kind)}, {"corners", std::move(corners)}, {"av_lane", each.of_av}});
  }
  for (const Rectangle& each : road.ground.obstacles) {
    described["obstacles"].push_back(
        {{"across", tidy_pair(each.left, each.right)}, {"along", tidy_pair(each.near, each.far)}});
  }
  for (const GroundCrosswalk& each : road.ground.crosswalks) {
    described["crosswalks"].push_back(crosswalk_json(each));
  }
  return described;
}

json av_json(const SimulatedTest& test) {
  json av = actor_json(test.av, test.av_start);
  av["cruise"] = tidy(test.cruise_mps);
  av["acceleration"] = test.vehicle.acceleration_mps2;
  av["standoff"] = test.vehicle.standoff_m;
  av["range"] = test.vehicle.range_m;
  if (test.vehicle.deceleration_mps2) av["deceleration"] = *test.vehicle.deceleration_mps2;
  if (test.vehicle.reaction_s) av["reaction"] = *test.vehicle.reaction_s;
  return av;
}

json options_json(const SimulatorParameters& parameters) {
  json options = json::object();
  if (const SettingValue* const given = parameters.find("options")) {
    for (const auto& map : given->maps) {
      for (const auto& [key, value] : map) options[key] = value;
    }
  }
  return options;
}

}  // namespace

json reset_message(const SimulatedTest& test, const SimulatorParameters& parameters, int steps) {
  json actors = json::array();
  for (std::size_t i = 0; i < test.actors.size(); ++i) {
    actors.push_back(actor_json(test.actors[i], test.starts[i]));
  }
  return {{"type", "reset"},
          {"seed", test.seed},
          {"behaviour", test.behaviour},
          {"agents", test.agents},
          {"tick", tidy(test.tick_s)},
          {"dt", tidy(test.tick_s / steps)},
          {"road", road_json(test.road)},
          {"av", av_json(test)},
          {"actors", std::move(actors)},
          {"options", options_json(parameters)}};
}

json step_message(const SimulatedTick& tick, double share, double period_s) {
  json actors = json::array();
  for (const SimulatedBody& body : tick.bodies) actors.push_back(state_json(body_at(body, share)));
  json signals = json::array();
  for (const ShownSignal& each : tick.signals) {
    signals.push_back({{"crosswalk", each.crosswalk}, {"colour", std::string(each.colour)}});
  }
  return {{"type", "step"},
          {"dt", tidy(period_s)},
          {"actors", std::move(actors)},
          {"signals", std::move(signals)}};
}

}  // namespace jaywalk

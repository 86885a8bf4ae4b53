// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/process/simulator_messages.h"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "env/process/message_reader.h"
#include "env/process/numbered_process.h"

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

ActorKind read_kind(std::string_view text, MessageReader& reader) {
  for (const auto kind : {ActorKind::vehicle, ActorKind::cyclist, ActorKind::pedestrian}) {
    if (text == name(kind)) return kind;
  }
  reader.reject(
      fmt::format("'{}' is no kind of traffic; vehicle, cyclist and pedestrian are", text));
  return ActorKind::vehicle;
}

Actor read_actor(const json& object, MessageReader& reader) {
  constexpr std::string_view kOf = "its traffic";
  Actor actor{.name = reader.text(object, "name", kOf),
              .kind = ActorKind::vehicle,
              .length_m = reader.number(object, "length", kOf),
              .width_m = reader.number(object, "width", kOf)};
  actor.kind = read_kind(reader.text(object, "kind", kOf), reader);
  return actor;
}

SimulatedVehicle read_vehicle(const json& object, std::string_view of, MessageReader& reader) {
  SimulatedVehicle vehicle;
  vehicle.present = reader.flag_or(object, "present", of, true);
  if (!vehicle.present) return vehicle;
  vehicle.state = {.x_m = reader.number(object, "x", of),
                   .y_m = reader.number(object, "y", of),
                   .speed_mps = reader.number(object, "speed", of),
                   .heading_rad = reader.number(object, "heading", of)};
  vehicle.acceleration_mps2 = reader.number_or(object, "acceleration", of, 0);
  return vehicle;
}

/// One state for each vehicle of the cast, in that order.
void read_traffic(const json& answer, const SimulatedCast& cast, SimulatedScene& scene,
                  MessageReader& reader) {
  const std::vector<std::string>& names = cast.traffic;
  const json* const traffic = reader.list(answer, "traffic", "its scene", !names.empty());
  const std::size_t count = traffic == nullptr ? 0 : traffic->size();
  if (count != names.size()) {
    reader.reject(
        fmt::format("there are {} states for the {} vehicles of its traffic", count, names.size()));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const json& each = (*traffic)[i];
    const std::string of = fmt::format("the traffic '{}'", names[i]);
    if (each.is_object() && each.contains("name") && reader.text(each, "name", of) != names[i]) {
      reader.reject(fmt::format("the traffic's vehicle {} is not '{}' any more", i, names[i]));
    }
    scene.traffic.push_back(read_vehicle(each, of, reader));
  }
}

void read_contacts(const json& answer, const SimulatedCast& cast, SimulatedScene& scene,
                   MessageReader& reader) {
  const json* const contacts = reader.list(answer, "contacts", "its scene", false);
  if (contacts == nullptr) return;
  scene.contacts.emplace();
  for (const json& each : *contacts) {
    const bool is_actor =
        each.is_number_unsigned() && each.get<std::uint64_t>() < cast.actors + cast.traffic.size();
    if (is_actor) {
      scene.contacts->push_back(each.get<std::size_t>());
    } else {
      reader.reject(fmt::format("the contact {} is the index of no actor", each.dump()));
    }
  }
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

std::string read_hello(const json& answer, SimulatorIdentity& identity) {
  constexpr std::string_view kOf = "its hello";
  MessageReader reader;
  const double protocol = reader.number(answer, "protocol", kOf);
  if (reader.problem().empty() && protocol != kSimulatorProtocol) {
    return fmt::format("it speaks version {:g} of the protocol, this is version {}", protocol,
                       kSimulatorProtocol);
  }
  identity.name = reader.text(answer, "name", kOf);
  identity.version = reader.text(answer, "version", kOf);
  identity.network = answer.contains("network") ? reader.text(answer, "network", kOf) : "";
  identity.deterministic = reader.flag_or(answer, "deterministic", kOf, false);
  return reader.problem();
}

std::string check_echo(const json& answer, std::uint64_t test) {
  MessageReader reader;
  (void)reader.number(answer, "step", "its answer");  // which one, the process has checked
  const double found = reader.number(answer, "test", "its answer");
  if (!reader.problem().empty() || found == static_cast<double>(test)) return reader.problem();
  return fmt::format("it answers for test {:g}, expected {}", found, test);
}

std::string read_start(const json& answer, SimulatedCast& cast, SimulatedStart& start) {
  MessageReader reader;
  if (const json* const traffic = reader.list(answer, "traffic", "its scene", false)) {
    for (const json& each : *traffic) {
      start.traffic.push_back(read_actor(each, reader));
      cast.traffic.push_back(start.traffic.back().name);
    }
  }
  if (!reader.problem().empty()) return reader.problem();
  return read_scene(answer, cast, 0, start.scene);
}

std::string read_scene(const json& answer, const SimulatedCast& cast, double time_s,
                       SimulatedScene& scene) {
  constexpr double kSameS = 1e-6;
  MessageReader reader;
  scene.time_s = reader.number(answer, "time", "its scene");
  if (const json* const av = reader.object(answer, "av", "its scene")) {
    scene.av = read_vehicle(*av, "its AV", reader);
  }
  read_traffic(answer, cast, scene, reader);
  read_contacts(answer, cast, scene, reader);
  if (!reader.problem().empty() || std::fabs(scene.time_s - time_s) <= kSameS) {
    return reader.problem();
  }
  return fmt::format("its time is {:g} s, expected {:g} s", scene.time_s, time_s);
}

}  // namespace jaywalk

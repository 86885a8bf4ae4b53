#include "env/simulator/process/answers.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "env/simulator/process/message_reader.h"

namespace jaywalk {
namespace {

using nlohmann::json;

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

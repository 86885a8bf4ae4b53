// A simulator outside of this program, which speaks the simulator protocol, version 1: one line of
// JSON for each question, one for each answer. scenarios/simulators/README.md describes it, and
// scenarios/simulators/protocol.schema.json every message.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "env/process/numbered_process.h"
#include "env/simulator/simulators.h"

namespace jaywalk {
namespace {

using nlohmann::json;

constexpr int kProtocol = 1;
/// How long an answer may take unless the scenario says so; and the first one, which loads all.
constexpr double kAnswerS = 10;
constexpr double kStartS = 60;
/// How long a simulator is watched for lines that nobody asked for before a test ends.
constexpr std::chrono::milliseconds kSettle{1};

constexpr std::array kKeys{
    SettingKey{.name = "command",
               .kind = SettingKind::command,
               .meaning = "the program and its arguments"},
    SettingKey{.name = "timeout",
               .kind = SettingKind::number,
               .meaning = "seconds that an answer may take; 10 unless given",
               .least = 0.01,
               .most = 3600},
    SettingKey{.name = "start_timeout",
               .kind = SettingKind::number,
               .meaning = "seconds until it answers for the first time; 60 unless given",
               .least = 0.01,
               .most = 3600},
    SettingKey{.name = "options",
               .kind = SettingKind::map,
               .meaning = "names and values that it is told when a test begins"},
};

/// Nanometres are noise of the arithmetic, and -0 is 0.
double tidied(double value) {
  constexpr double kDigits = 1e9;
  return std::round(value * kDigits) / kDigits + 0.0;
}

json interval_json(double from, double to) { return {tidied(from), tidied(to)}; }

json state_json(const ActorState& state) {
  return {{"x", tidied(state.x_m)},
          {"y", tidied(state.y_m)},
          {"heading", tidied(state.heading_rad)},
          {"speed", tidied(state.speed_mps)}};
}

json actor_json(const Actor& actor, const ActorState& state) {
  json described = state_json(state);
  described["name"] = actor.name;
  described["kind"] = std::string(name(actor.kind));
  described["length"] = tidied(actor.length_m);
  described["width"] = tidied(actor.width_m);
  return described;
}

std::string_view word(AreaKind kind) { return kind == AreaKind::lane ? "lane" : "pavement"; }

json crosswalk_json(const GroundCrosswalk& crosswalk) {
  json parts = json::array();
  for (const Rectangle& each : crosswalk.parts) {
    parts.push_back({{"across", interval_json(each.left, each.right)},
                     {"along", interval_json(each.near, each.far)}});
  }
  return {{"kind", crosswalk.zebra ? "zebra" : "signalled"},
          {"begins", tidied(crosswalk.begins_m)},
          {"parts", std::move(parts)},
          {"signals", crosswalk.signals}};
}

json road_json(const SimulatedRoad& road) {
  json described{{"length", tidied(road.length_m)},
                 {"bands", json::array()},
                 {"areas", json::array()},
                 {"obstacles", json::array()},
                 {"crosswalks", json::array()}};
  for (const RoadBand& each : road.bands) {
    described["bands"].push_back({{"kind", word(each.kind)},
                                  {"across", interval_json(each.left_m, each.right_m)},
                                  {"oncoming", each.oncoming}});
  }
  for (const Area& each : road.ground.areas) {
    json corners = json::array();
    for (const Point point : each.corners) corners.push_back(interval_json(point.x_m, point.y_m));
    described["areas"].push_back(
        {{"kind", word(each.kind)}, {"corners", std::move(corners)}, {"av_lane", each.of_av}});
  }
  for (const Rectangle& each : road.ground.obstacles) {
    described["obstacles"].push_back({{"across", interval_json(each.left, each.right)},
                                      {"along", interval_json(each.near, each.far)}});
  }
  for (const GroundCrosswalk& each : road.ground.crosswalks) {
    described["crosswalks"].push_back(crosswalk_json(each));
  }
  return described;
}

/// Reads what a message has to have; the first thing that is wrong is kept, as words for people.
class MessageReader {
 public:
  explicit MessageReader(std::string& why) : why_(why) {}

  double number(const json& object, const char* key, std::string_view of) {
    const json* const found = field(object, key, of);
    if (found == nullptr) return 0;
    if (!found->is_number()) return complain(key, of, "a number"), 0;
    return found->get<double>();
  }
  double number_or(const json& object, const char* key, std::string_view of, double otherwise) {
    return object.contains(key) ? number(object, key, of) : otherwise;
  }
  std::string text(const json& object, const char* key, std::string_view of) {
    const json* const found = field(object, key, of);
    if (found == nullptr) return {};
    if (!found->is_string()) return complain(key, of, "a text"), std::string();
    return found->get<std::string>();
  }
  bool flag(const json& object, const char* key, std::string_view of, bool otherwise) {
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    if (!found->is_boolean()) return complain(key, of, "true or false"), otherwise;
    return found->get<bool>();
  }
  /// Null where there is none, which is a mistake if it is needed.
  const json* list(const json& object, const char* key, std::string_view of, bool needed) {
    const json* const found = needed ? field(object, key, of) : optional(object, key);
    if (found == nullptr) return nullptr;
    if (!found->is_array()) return complain(key, of, "a list"), nullptr;
    return found;
  }
  const json* object(const json& object, const char* key, std::string_view of) {
    const json* const found = field(object, key, of);
    if (found == nullptr) return nullptr;
    if (!found->is_object()) return complain(key, of, "an object"), nullptr;
    return found;
  }
  void say(std::string why) {
    if (why_.empty()) why_ = std::move(why);
  }

 private:
  static const json* optional(const json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }
  const json* field(const json& object, const char* key, std::string_view of) {
    const json* const found = object.is_object() ? optional(object, key) : nullptr;
    if (found == nullptr) say(fmt::format("there is no '{}' in {}", key, of));
    return found;
  }
  void complain(const char* key, std::string_view of, std::string_view expected) {
    say(fmt::format("'{}' in {} is not {}", key, of, expected));
  }

  std::string& why_;
};

class ProcessSimulator final : public Simulator {
 public:
  explicit ProcessSimulator(const SimulatorParameters& parameters)
      : parameters_(parameters),
        process_({.command = parameters.settings.at("command").command, .key = "step"}) {}
  ~ProcessSimulator() override {
    if (identity_) process_.tell({{"type", "bye"}}, std::chrono::milliseconds(100));
  }
  ProcessSimulator(const ProcessSimulator&) = delete;
  ProcessSimulator& operator=(const ProcessSimulator&) = delete;

  std::string identify(SimulatorIdentity& identity) override {
    if (std::string why = say_hello(); !why.empty()) return why;
    identity = *identity_;
    return {};
  }

  std::string begin(const SimulatedTest& test, SimulatedStart& start) override {
    if (std::string why = say_hello(); !why.empty()) return why;
    test_ = test.test;
    step_ = 0;
    steps_ = steps_of(test.tick_s, parameters_.step_s);
    actors_ = test.actors.size();
    names_.clear();
    json answer;
    if (std::string why = ask(reset_message(test), answer); !why.empty()) return why;
    return accepted(read_start(answer, start));
  }

  std::string advance(const SimulatedTick& tick, std::vector<SimulatedScene>& scenes) override {
    const double period_s = tick.length_s / steps_;
    for (int step = 1; step <= steps_; ++step) {
      const double share = static_cast<double>(step) / steps_;
      const double until_s = tick.begin_s + step * period_s;
      json answer;
      if (std::string why = ask(step_message(tick, share, period_s), answer); !why.empty()) {
        return why;
      }
      SimulatedScene scene;
      std::string why;
      read_scene(answer, scene, why);
      if (why.empty()) why = wrong_time(scene.time_s, until_s);
      if (why = accepted(std::move(why)); !why.empty()) return why;
      scenes.push_back(std::move(scene));
    }
    return {};
  }

  std::string end(const DriveEnd& /*end*/) override {
    std::string more = process_.said_more(kSettle);
    if (!more.empty()) identity_.reset();
    return more;
  }

  [[nodiscard]] std::string note() const override {
    if (!identity_ || identity_->deterministic) return {};
    return fmt::format("the simulator '{}' does not promise the same results for the same seed",
                       identity_->name);
  }

 private:
  static std::chrono::milliseconds milliseconds(double seconds) {
    return std::chrono::milliseconds(std::lround(seconds * 1000));
  }

  std::string say_hello() {
    if (identity_) return {};
    const double limit_s = parameters_.number("start_timeout", kStartS);
    JsonAnswer answer =
        process_.ask({{"type", "hello"}, {"protocol", kProtocol}, {"name", "jaywalk"}}, 0,
                     milliseconds(limit_s));
    if (!answer.error.empty()) return answer.error;
    if (std::string why = complaint(answer.json); !why.empty()) return why;
    return accepted(read_hello(answer.json));
  }

  std::string read_hello(const json& answer) {
    std::string why;
    MessageReader reader(why);
    const double protocol = reader.number(answer, "protocol", "its hello");
    if (why.empty() && protocol != kProtocol) {
      return fmt::format("it speaks version {:g} of the protocol, this is version {}", protocol,
                         kProtocol);
    }
    SimulatorIdentity identity;
    identity.name = reader.text(answer, "name", "its hello");
    identity.version = reader.text(answer, "version", "its hello");
    if (answer.contains("network")) identity.network = reader.text(answer, "network", "its hello");
    identity.deterministic = reader.flag(answer, "deterministic", "its hello", false);
    if (why.empty()) identity_ = std::move(identity);
    return why;
  }

  json reset_message(const SimulatedTest& test) {
    json actors = json::array();
    for (std::size_t i = 0; i < test.actors.size(); ++i) {
      actors.push_back(actor_json(test.actors[i], test.starts[i]));
    }
    json av = actor_json(test.av, test.av_start);
    av["cruise"] = tidied(test.cruise_mps);
    av["acceleration"] = test.vehicle.acceleration_mps2;
    av["standoff"] = test.vehicle.standoff_m;
    av["range"] = test.vehicle.range_m;
    if (test.vehicle.deceleration_mps2) av["deceleration"] = *test.vehicle.deceleration_mps2;
    if (test.vehicle.reaction_s) av["reaction"] = *test.vehicle.reaction_s;
    json options = json::object();
    if (const SettingValue* const given = parameters_.find("options")) {
      for (const auto& map : given->maps) {
        for (const auto& [key, value] : map) options[key] = value;
      }
    }
    return {{"type", "reset"},
            {"seed", test.seed},
            {"behaviour", test.behaviour},
            {"agents", test.agents},
            {"tick", tidied(test.tick_s)},
            {"dt", tidied(test.tick_s / steps_)},
            {"road", road_json(test.road)},
            {"av", std::move(av)},
            {"actors", std::move(actors)},
            {"options", std::move(options)}};
  }

  static json step_message(const SimulatedTick& tick, double share, double period_s) {
    json actors = json::array();
    for (const SimulatedBody& body : tick.bodies)
      actors.push_back(state_json(body_at(body, share)));
    json signals = json::array();
    for (const ShownSignal& each : tick.signals) {
      signals.push_back({{"crosswalk", each.crosswalk}, {"colour", std::string(each.colour)}});
    }
    return {{"type", "step"},
            {"dt", tidied(period_s)},
            {"actors", std::move(actors)},
            {"signals", std::move(signals)}};
  }

  std::string ask(json question, json& answer) {
    question["test"] = test_;
    JsonAnswer said = process_.ask(std::move(question), step_,
                                   milliseconds(parameters_.number("timeout", kAnswerS)));
    if (!said.error.empty()) {
      identity_.reset();  // the next one is another process
      return said.error;
    }
    answer = std::move(said.json);
    ++step_;
    if (std::string why = complaint(answer); !why.empty()) return why;
    return accepted(echo(answer));
  }

  /// What it reports about itself; then it is ended, too.
  std::string complaint(const json& answer) {
    const auto error = answer.find("error");
    if (error == answer.end()) return {};
    identity_.reset();
    (void)process_.refuse({});
    return fmt::format("it reports '{}'",
                       error->is_string() ? error->get<std::string>() : error->dump());
  }

  /// Every answer says to which question it belongs.
  [[nodiscard]] std::string echo(const json& answer) const {
    std::string why;
    MessageReader reader(why);
    (void)reader.number(answer, "step", "its answer");  // the process has checked which
    const double test = reader.number(answer, "test", "its answer");
    if (!why.empty()) return why;
    if (test == static_cast<double>(test_)) return {};
    return fmt::format("it answers for test {:g}, asked was {}", test, test_);
  }

  /// Ends the process if something is wrong: its other answers mean nothing either.
  std::string accepted(std::string why) {
    if (why.empty()) return {};
    identity_.reset();
    return process_.refuse(why);
  }

  static std::string wrong_time(double found_s, double wanted_s) {
    constexpr double kSame = 1e-6;
    if (std::fabs(found_s - wanted_s) <= kSame) return {};
    return fmt::format("its time is {:g} s, asked was {:g} s", found_s, wanted_s);
  }

  std::string read_start(const json& answer, SimulatedStart& start) {
    std::string why;
    MessageReader reader(why);
    if (const json* const traffic = reader.list(answer, "traffic", "its scene", false)) {
      for (const json& each : *traffic) {
        Actor actor{.name = reader.text(each, "name", "its traffic"),
                    .kind = ActorKind::vehicle,
                    .length_m = reader.number(each, "length", "its traffic"),
                    .width_m = reader.number(each, "width", "its traffic")};
        actor.kind = kind_of(reader.text(each, "kind", "its traffic"), reader);
        names_.push_back(actor.name);
        start.traffic.push_back(std::move(actor));
      }
    }
    read_scene(answer, start.scene, why);
    if (why.empty()) why = wrong_time(start.scene.time_s, 0);
    return why;
  }

  static ActorKind kind_of(std::string_view text, MessageReader& reader) {
    for (const auto kind : {ActorKind::vehicle, ActorKind::cyclist, ActorKind::pedestrian}) {
      if (text == name(kind)) return kind;
    }
    reader.say(
        fmt::format("'{}' is no kind of traffic; vehicle, cyclist and pedestrian are", text));
    return ActorKind::vehicle;
  }

  void read_scene(const json& answer, SimulatedScene& scene, std::string& why) {
    MessageReader reader(why);
    scene.time_s = reader.number(answer, "time", "its scene");
    if (const json* const av = reader.object(answer, "av", "its scene")) {
      scene.av = read_vehicle(*av, "its AV", reader);
    }
    read_traffic(answer, scene, reader);
    if (const json* const contacts = reader.list(answer, "contacts", "its scene", false)) {
      scene.contacts.emplace();
      for (const json& each : *contacts) read_contact(each, *scene.contacts, reader);
    }
  }

  static SimulatedVehicle read_vehicle(const json& object, std::string_view of,
                                       MessageReader& reader) {
    SimulatedVehicle vehicle;
    vehicle.present = reader.flag(object, "present", of, true);
    if (!vehicle.present) return vehicle;
    vehicle.state = {.x_m = reader.number(object, "x", of),
                     .y_m = reader.number(object, "y", of),
                     .speed_mps = reader.number(object, "speed", of),
                     .heading_rad = reader.number(object, "heading", of)};
    vehicle.acceleration_mps2 = reader.number_or(object, "acceleration", of, 0);
    return vehicle;
  }

  /// One state for each vehicle that the reset has named, in that order.
  void read_traffic(const json& answer, SimulatedScene& scene, MessageReader& reader) {
    const json* const traffic = reader.list(answer, "traffic", "its scene", !names_.empty());
    const std::size_t count = traffic == nullptr ? 0 : traffic->size();
    if (count != names_.size()) {
      reader.say(fmt::format("there are {} states for the {} vehicles of its traffic", count,
                             names_.size()));
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const json& each = (*traffic)[i];
      const std::string of = fmt::format("the traffic '{}'", names_[i]);
      if (each.is_object() && each.contains("name") && reader.text(each, "name", of) != names_[i]) {
        reader.say(fmt::format("the traffic's vehicle {} is not '{}' any more", i, names_[i]));
      }
      scene.traffic.push_back(read_vehicle(each, of, reader));
    }
  }

  void read_contact(const json& each, std::vector<std::size_t>& contacts, MessageReader& reader) {
    if (each.is_number_unsigned() && each.get<std::uint64_t>() < actors_ + names_.size()) {
      contacts.push_back(each.get<std::size_t>());
      return;
    }
    reader.say(fmt::format("the contact {} is the index of no actor", each.dump()));
  }

  SimulatorParameters parameters_;
  NumberedProcess process_;
  std::optional<SimulatorIdentity> identity_;  // once it has said hello
  std::uint64_t test_ = 0;
  std::size_t step_ = 0;
  int steps_ = 1;
  std::size_t actors_ = 0;
  std::vector<std::string> names_;  // of the traffic
};

}  // namespace

std::span<const SettingKey> process_keys() { return kKeys; }

std::vector<SettingProblem> check_process(const SimulatorParameters& parameters) {
  const SettingValue* const command = parameters.find("command");
  if (command != nullptr && !command->command.empty()) return {};
  return {{.key = {},
           .message = "no 'command' to start the simulator with",
           .hint = "for example command: [python3, simulator.py]"}};
}

std::unique_ptr<Simulator> make_process(const SimulatorParameters& parameters) {
  return std::make_unique<ProcessSimulator>(parameters);
}

}  // namespace jaywalk

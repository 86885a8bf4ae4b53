// SPDX-License-Identifier: Apache-2.0
#pragma once

// The wire format of TraCI, by which SUMO is driven (sumo.dlr.de/docs/TraCI/Protocol.html). A
// message is its length in four bytes and commands; a command is its length in a byte (0 and four
// more bytes if that is too small), its identifier and what belongs to it. Numbers are big-endian.
// SUMO answers each command by a status, and some by a result after it, in the order of the
// commands: so all commands of a step go into one message.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

/// Identifiers of commands.
enum class TraciCommand : std::uint8_t {
  version = 0x00,
  load = 0x01,
  step = 0x02,
  close = 0x7f,
  lane_get = 0xa3,
  vehicle_get = 0xa4,
  vehicle_type_get = 0xa5,
  edge_get = 0xaa,
  simulation_get = 0xab,
  person_get = 0xae,
  traffic_light_set = 0xc2,
  vehicle_set = 0xc4,
  person_set = 0xce,
  vehicle_subscribe = 0xd4,
  vehicle_context = 0x84,
};

/// Identifiers of the variables to read or change; each is valid for some commands only.
enum class TraciVariable : std::uint8_t {
  ids = 0x00,
  lamps = 0x20,
  speed = 0x40,
  max_speed = 0x41,
  position = 0x42,
  angle = 0x43,
  shape = 0x4e,
  links = 0x33,
  allowed = 0x34,
  lane_count = 0x52,
  lane_position = 0x56,
  acceleration = 0x72,
  speed_mode = 0xb3,
  move_to_xy = 0xb4,
};

/// Identifiers of values' types.
enum class TraciType : std::uint8_t {
  position_2d = 0x01,
  position_3d = 0x03,
  polygon = 0x06,
  unsigned_byte = 0x07,
  byte = 0x08,
  integer = 0x09,
  real = 0x0b,
  text = 0x0c,
  texts = 0x0e,
  compound = 0x0f,
};

struct TraciPoint {
  double x_m = 0;
  double y_m = 0;

  friend bool operator==(const TraciPoint&, const TraciPoint&) = default;
};

/// A value as its type says it: a number, a text, texts, points or values within a value.
struct TraciValue {
  TraciType type = TraciType::real;
  double number = 0;
  std::string text;
  std::vector<std::string> texts;
  /// The points of a polygon; a position has one.
  std::vector<TraciPoint> points;
  std::vector<TraciValue> items;
};

[[nodiscard]] TraciValue traci_real(double value);
[[nodiscard]] TraciValue traci_integer(std::int32_t value);
[[nodiscard]] TraciValue traci_byte(std::int8_t value);
[[nodiscard]] TraciValue traci_text(std::string value);
[[nodiscard]] TraciValue traci_compound(std::vector<TraciValue> items);

/// Commands that are sent together.
class TraciMessage {
 public:
  void version();
  /// Begins a new simulation with these options of SUMO's command line.
  void load(std::span<const std::string> options);
  /// One step of the length that SUMO was started with. SUMO carries it out after all other
  /// commands of the message, so add it last.
  void step();
  void close();
  void get(TraciCommand command, TraciVariable variable, std::string_view object);
  void set(TraciCommand command, TraciVariable variable, std::string_view object,
           const TraciValue& value);
  /// The variables of an object are part of each step's answer from then on.
  void subscribe(TraciCommand command, std::string_view object,
                 std::span<const TraciVariable> variables);
  /// Adds the variables of all vehicles within a distance of a vehicle to each step's answer.
  void subscribe_around(std::string_view vehicle, double range_m,
                        std::span<const TraciVariable> variables);

  /// The message's commands, in order.
  [[nodiscard]] const std::vector<TraciCommand>& commands() const { return commands_; }
  /// The message with its length.
  [[nodiscard]] std::string bytes() const;

 private:
  void add(TraciCommand command, const std::string& content);

  std::vector<TraciCommand> commands_;
  std::string content_;
};

/// Values of one object, in an answer to `get`, to a subscription or to a step.
struct TraciObject {
  std::string id;
  struct Entry {
    TraciVariable variable = TraciVariable::ids;
    TraciValue value;
  };
  std::vector<Entry> entries;

  /// Null if it has none of that variable and type.
  [[nodiscard]] const TraciValue* find(TraciVariable variable, TraciType type) const;
};

/// SUMO's answer to a message.
struct TraciAnswer {
  /// SUMO's own words about a command that it refused, or an error in the answer's bytes. Empty if
  /// all commands were carried out.
  std::string error;
  /// In the order of the answer. Those around a vehicle are objects of their own.
  std::vector<TraciObject> objects;
  /// The answer to the command `version`.
  std::string version;
  std::int32_t api = 0;
};

/// Reads the answer, without its length, to commands. Any bytes may be given.
[[nodiscard]] TraciAnswer read_traci_answer(std::span<const TraciCommand> commands,
                                            std::string_view bytes);

/// The number of bytes that follow the first four of a message; an answer of more than kMostBytes
/// or of less than none gives -1. REQUIRES: four bytes.
inline constexpr std::int64_t kMostTraciBytes = std::int64_t{64} << 20;
[[nodiscard]] std::int64_t traci_rest(std::string_view length);

}  // namespace jaywalk

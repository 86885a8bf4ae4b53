// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/sumo/traci_message.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace jaywalk {
namespace {

// The end of a subscription that lasts until the simulation ends.
constexpr double kForever = 1'073'741'824;
// Values within values: no answer has more, and a stack has an end.
constexpr int kDeepest = 8;
constexpr std::uint8_t kStatusOk = 0;

template <class Unsigned>
void put_unsigned(Unsigned value, std::string& bytes) {
  for (int shift = static_cast<int>(sizeof value) * 8 - 8; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>(static_cast<std::uint8_t>(value >> shift)));
  }
}

template <class Enumerator>
void put_name(Enumerator name, std::string& bytes) {
  put_unsigned(static_cast<std::uint8_t>(name), bytes);
}

void put_count(std::size_t count, std::string& bytes) {
  put_unsigned(static_cast<std::uint32_t>(count), bytes);
}

void put_real(double value, std::string& bytes) {
  put_unsigned(std::bit_cast<std::uint64_t>(value), bytes);
}

void put_text(std::string_view text, std::string& bytes) {
  put_count(text.size(), bytes);
  bytes += text;
}

void put_point(TraciPoint point, std::string& bytes) {
  put_real(point.x_m, bytes);
  put_real(point.y_m, bytes);
}

void put_value(const TraciValue& value, std::string& bytes) {
  put_name(value.type, bytes);
  switch (value.type) {
    case TraciType::unsigned_byte:
    case TraciType::byte:
      return put_unsigned(static_cast<std::uint8_t>(static_cast<int>(value.number)), bytes);
    case TraciType::integer:
      return put_unsigned(static_cast<std::uint32_t>(static_cast<std::int32_t>(value.number)),
                          bytes);
    case TraciType::real:
      return put_real(value.number, bytes);
    case TraciType::text:
      return put_text(value.text, bytes);
    case TraciType::texts:
      put_count(value.texts.size(), bytes);
      for (const std::string& each : value.texts) put_text(each, bytes);
      return;
    case TraciType::position_3d:
      put_point(value.points.front(), bytes);
      return put_real(0, bytes);
    case TraciType::position_2d:
      return put_point(value.points.front(), bytes);
    case TraciType::polygon:
      put_unsigned(static_cast<std::uint8_t>(value.points.size()), bytes);
      for (const TraciPoint& each : value.points) put_point(each, bytes);
      return;
    case TraciType::compound:
      put_count(value.items.size(), bytes);
      for (const TraciValue& each : value.items) put_value(each, bytes);
      return;
  }
}

/// Reads values one after another. After the first that is not there all others are 0 or empty, and
/// `failed` says so.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  void fail() {
    failed_ = true;
    rest_ = {};
  }

  std::string_view take(std::size_t count) {
    if (count > rest_.size()) {
      fail();
      return {};
    }
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  template <class Unsigned>
  Unsigned unsigned_number() {
    Unsigned value = 0;
    for (const char each : take(sizeof value)) {
      value = static_cast<Unsigned>(value << 8U | static_cast<std::uint8_t>(each));
    }
    return value;
  }
  std::uint8_t byte() { return unsigned_number<std::uint8_t>(); }
  std::int32_t integer() { return static_cast<std::int32_t>(unsigned_number<std::uint32_t>()); }
  double real() { return std::bit_cast<double>(unsigned_number<std::uint64_t>()); }
  std::string text() { return std::string(take(unsigned_number<std::uint32_t>())); }

  /// The number of items that follow; fails if the remaining bytes cannot hold that many items of
  /// at least `bytes_each` bytes.
  std::size_t count(std::size_t bytes_each) {
    const std::size_t count = unsigned_number<std::uint32_t>();
    if (count > rest_.size() / bytes_each) fail();
    return failed_ ? 0 : count;
  }

  /// The content of the command that begins here, without its length.
  Bytes command() {
    std::size_t length = byte();
    std::size_t read = 1;
    if (length == 0) {
      length = unsigned_number<std::uint32_t>();
      read = 5;
    }
    if (length <= read) fail();
    Bytes inner(failed_ ? std::string_view() : take(length - read));
    if (failed_) inner.fail();
    return inner;
  }

 private:
  std::string_view rest_;
  bool failed_ = false;
};

TraciPoint point_of(Bytes& bytes) {
  const double x_m = bytes.real();
  return {x_m, bytes.real()};
}

void read_points(Bytes& bytes, TraciValue& value) {
  // More than 255 points are counted by four bytes.
  std::size_t points = bytes.byte();
  if (points == 0) points = bytes.count(2 * sizeof(double));
  for (std::size_t i = 0; i < points && !bytes.failed(); ++i) {
    value.points.push_back(point_of(bytes));
  }
}

TraciValue value_of(Bytes& bytes, int depth = 0) {
  TraciValue value{.type = static_cast<TraciType>(bytes.byte())};
  switch (value.type) {
    case TraciType::unsigned_byte:
      value.number = bytes.byte();
      return value;
    case TraciType::byte:
      value.number = static_cast<std::int8_t>(bytes.byte());
      return value;
    case TraciType::integer:
      value.number = bytes.integer();
      return value;
    case TraciType::real:
      value.number = bytes.real();
      return value;
    case TraciType::text:
      value.text = bytes.text();
      return value;
    case TraciType::texts:
      for (std::size_t left = bytes.count(4); left > 0 && !bytes.failed(); --left) {
        value.texts.push_back(bytes.text());
      }
      return value;
    case TraciType::position_2d:
      value.points.push_back(point_of(bytes));
      return value;
    case TraciType::position_3d:
      value.points.push_back(point_of(bytes));
      (void)bytes.real();
      return value;
    case TraciType::polygon:
      read_points(bytes, value);
      return value;
    case TraciType::compound:
      if (depth == kDeepest) break;
      for (std::size_t left = bytes.count(1); left > 0 && !bytes.failed(); --left) {
        value.items.push_back(value_of(bytes, depth + 1));
      }
      return value;
  }
  bytes.fail();
  return value;
}

/// The variables of one object, each with a status of its own. Why one could not be read.
std::string read_entries(Bytes& bytes, std::size_t count, TraciObject& object) {
  for (std::size_t i = 0; i < count && !bytes.failed(); ++i) {
    const auto variable = static_cast<TraciVariable>(bytes.byte());
    const std::uint8_t status = bytes.byte();
    TraciValue value = value_of(bytes);
    if (!bytes.failed() && status != kStatusOk) {
      return value.text.empty() ? fmt::format("status {}", status) : value.text;
    }
    object.entries.push_back({variable, std::move(value)});
  }
  return {};
}

bool is_context(TraciCommand command) { return command == TraciCommand::vehicle_context; }
bool is_subscription(TraciCommand command) {
  return command == TraciCommand::vehicle_subscribe || is_context(command);
}
bool is_get(TraciCommand command) {
  const auto id = static_cast<std::uint8_t>(command);
  return id >= 0xa0 && id <= 0xaf;
}

/// A subscription's result: of one object, or of all around it.
std::string read_subscription(Bytes command, TraciAnswer& answer) {
  const auto asked = static_cast<TraciCommand>(command.byte() - 0x10);
  TraciObject object{.id = command.text(), .entries = {}};
  if (!is_context(asked)) {
    if (!is_subscription(asked)) command.fail();
    const std::size_t count = command.byte();
    if (std::string why = read_entries(command, count, object); !why.empty()) return why;
    answer.objects.push_back(std::move(object));
    return command.failed() ? "malformed" : "";
  }
  (void)command.byte();  // what kind of objects: those that were asked for
  const std::size_t variables = command.byte();
  std::size_t objects = command.count(4);
  for (; objects > 0 && !command.failed(); --objects) {
    TraciObject each{.id = command.text(), .entries = {}};
    if (std::string why = read_entries(command, variables, each); !why.empty()) return why;
    answer.objects.push_back(std::move(each));
  }
  return command.failed() ? "malformed" : "";
}

/// Reads the result that comes after a command's status. Returns an error or an empty text.
std::string read_result(TraciCommand asked, Bytes& bytes, TraciAnswer& answer) {
  if (asked == TraciCommand::version) {
    Bytes command = bytes.command();
    if (command.byte() != static_cast<std::uint8_t>(asked)) command.fail();
    answer.api = command.integer();
    answer.version = command.text();
    return command.failed() ? "malformed" : "";
  }
  if (is_get(asked)) {
    Bytes command = bytes.command();
    if (command.byte() != static_cast<std::uint8_t>(asked) + 0x10) command.fail();
    const auto variable = static_cast<TraciVariable>(command.byte());
    TraciObject object{.id = command.text(), .entries = {}};
    object.entries.push_back({variable, value_of(command)});
    answer.objects.push_back(std::move(object));
    return command.failed() ? "malformed" : "";
  }
  if (is_subscription(asked)) return read_subscription(bytes.command(), answer);
  if (asked != TraciCommand::step) return {};
  for (std::size_t left = bytes.count(1); left > 0 && !bytes.failed(); --left) {
    if (std::string why = read_subscription(bytes.command(), answer); !why.empty()) return why;
  }
  return {};
}

TraciAnswer refusal(std::string why) {
  TraciAnswer answer;
  answer.error = std::move(why);
  return answer;
}

TraciAnswer nonsense(std::size_t position) {
  return refusal(fmt::format("its answer to command {} of a message is no TraCI", position + 1));
}

}  // namespace

TraciValue traci_real(double value) { return {.type = TraciType::real, .number = value}; }

TraciValue traci_integer(std::int32_t value) {
  return {.type = TraciType::integer, .number = static_cast<double>(value)};
}

TraciValue traci_byte(std::int8_t value) {
  return {.type = TraciType::byte, .number = static_cast<double>(value)};
}

TraciValue traci_text(std::string value) {
  return {.type = TraciType::text, .text = std::move(value)};
}

TraciValue traci_compound(std::vector<TraciValue> items) {
  return {.type = TraciType::compound, .items = std::move(items)};
}

void TraciMessage::add(TraciCommand command, const std::string& content) {
  constexpr std::size_t kMostInAByte = 255;
  const std::size_t length = content.size() + 2;
  if (length <= kMostInAByte) {
    put_unsigned(static_cast<std::uint8_t>(length), content_);
  } else {
    put_unsigned(std::uint8_t{0}, content_);
    put_count(length + 4, content_);
  }
  put_name(command, content_);
  content_ += content;
  commands_.push_back(command);
}

void TraciMessage::version() { add(TraciCommand::version, {}); }

void TraciMessage::load(std::span<const std::string> options) {
  std::string content;
  put_value({.type = TraciType::texts, .texts = {options.begin(), options.end()}}, content);
  add(TraciCommand::load, content);
}

void TraciMessage::step() {
  std::string content;
  put_real(0, content);
  add(TraciCommand::step, content);
}

void TraciMessage::close() { add(TraciCommand::close, {}); }

void TraciMessage::get(TraciCommand command, TraciVariable variable, std::string_view object) {
  std::string content;
  put_name(variable, content);
  put_text(object, content);
  add(command, content);
}

void TraciMessage::set(TraciCommand command, TraciVariable variable, std::string_view object,
                       const TraciValue& value) {
  std::string content;
  put_name(variable, content);
  put_text(object, content);
  put_value(value, content);
  add(command, content);
}

void TraciMessage::subscribe(TraciCommand command, std::string_view object,
                             std::span<const TraciVariable> variables) {
  std::string content;
  put_real(-kForever, content);
  put_real(kForever, content);
  put_text(object, content);
  put_unsigned(static_cast<std::uint8_t>(variables.size()), content);
  for (const TraciVariable each : variables) put_name(each, content);
  add(command, content);
}

void TraciMessage::subscribe_around(std::string_view vehicle, double range_m,
                                    std::span<const TraciVariable> variables) {
  std::string content;
  put_real(-kForever, content);
  put_real(kForever, content);
  put_text(vehicle, content);
  put_name(TraciCommand::vehicle_get, content);
  put_real(range_m, content);
  put_unsigned(static_cast<std::uint8_t>(variables.size()), content);
  for (const TraciVariable each : variables) put_name(each, content);
  add(TraciCommand::vehicle_context, content);
}

std::string TraciMessage::bytes() const {
  std::string bytes;
  put_count(content_.size() + 4, bytes);
  return bytes + content_;
}

const TraciValue* TraciObject::find(TraciVariable variable, TraciType type) const {
  const auto found = std::ranges::find_if(entries, [&](const Entry& each) {
    return each.variable == variable && each.value.type == type;
  });
  return found == entries.end() ? nullptr : &found->value;
}

TraciAnswer read_traci_answer(std::span<const TraciCommand> commands, std::string_view text) {
  TraciAnswer answer;
  Bytes bytes(text);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    Bytes status = bytes.command();
    const std::uint8_t of = status.byte();
    const std::uint8_t code = status.byte();
    const std::string words = status.text();
    if (status.failed() || of != static_cast<std::uint8_t>(commands[i])) return nonsense(i);
    if (code != kStatusOk) {
      return refusal(fmt::format("it refused command 0x{:02x}: {}", of,
                                 words.empty() ? fmt::format("status {}", code) : words));
    }
    const std::string why = read_result(commands[i], bytes, answer);
    if (bytes.failed() || why == "malformed") return nonsense(i);
    if (!why.empty()) return refusal(fmt::format("it refused command 0x{:02x}: {}", of, why));
  }
  if (!bytes.empty()) {
    return refusal(fmt::format("its answer has {} bytes more than commands", bytes.left()));
  }
  return answer;
}

std::int64_t traci_rest(std::string_view length) {
  const std::int64_t whole = Bytes(length).unsigned_number<std::uint32_t>();
  return whole < 4 || whole - 4 > kMostTraciBytes ? -1 : whole - 4;
}

}  // namespace jaywalk

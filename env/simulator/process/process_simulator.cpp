// SPDX-License-Identifier: Apache-2.0
// A simulator outside of this program, which speaks the simulator protocol, version 1: one line of
// JSON for each question, one for each answer. docs/reference/simulator_protocol.md describes
// it, and scenarios/simulators/protocol.schema.json every message.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "env/process/numbered_process.h"
#include "env/simulator/process/simulator_messages.h"
#include "env/simulator/simulator.h"

namespace jaywalk {
namespace {

using nlohmann::json;

/// How long an answer may take unless the scenario says so; and the first one, which loads all.
constexpr double kAnswerS = 10;
constexpr double kStartS = 60;
/// How long a simulator is watched for unexpected lines before a test ends.
constexpr std::chrono::milliseconds kSettle{1};

constexpr std::array kProcessKeys{
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
               .meaning = "names and values that it receives when a test begins"},
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
    cast_ = {.actors = test.actors.size(), .traffic = {}};
    json answer;
    if (std::string why = ask(reset_message(test, parameters_, steps_), answer); !why.empty())
      return why;
    return accepted(read_start(answer, cast_, start));
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
      if (std::string why = accepted(read_scene(answer, cast_, until_s, scene)); !why.empty()) {
        return why;
      }
      scenes.push_back(std::move(scene));
    }
    return {};
  }

  std::string end(const DriveEnd& /*end*/) override {
    std::string more = process_.said_more(kSettle);
    if (!more.empty()) identity_.reset();
    return more;
  }

  [[nodiscard]] std::vector<std::string> take_notes() override {
    std::vector<std::string> notes;
    if (identity_ && !identity_->deterministic) {
      notes.push_back(
          fmt::format("the simulator '{}' does not promise the same results for the same seed",
                      identity_->name));
    }
    if (std::string errors = process_.take_errors(); !errors.empty()) {
      notes.push_back(fmt::format("the simulator wrote to standard error:\n{}", errors));
    }
    return notes;
  }

 private:
  static std::chrono::milliseconds milliseconds(double seconds) {
    return std::chrono::milliseconds(std::lround(seconds * 1000));
  }

  std::string say_hello() {
    if (identity_) return {};
    const double limit_s = parameters_.number("start_timeout", kStartS);
    JsonAnswer answer =
        process_.ask({{"type", "hello"}, {"protocol", kSimulatorProtocol}, {"name", "jaywalk"}}, 0,
                     milliseconds(limit_s));
    if (!answer.error.empty()) return answer.error;
    if (std::string why = complaint(answer.json); !why.empty()) return why;
    SimulatorIdentity identity;
    std::string why = accepted(read_hello(answer.json, identity));
    if (why.empty()) identity_ = std::move(identity);
    return why;
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
    return accepted(check_echo(answer, test_));
  }

  /// The simulator's own error message, after which its process is ended; empty if it reports none.
  std::string complaint(const json& answer) {
    const auto error = answer.find("error");
    if (error == answer.end()) return {};
    identity_.reset();
    (void)process_.refuse({});
    return fmt::format("it reports '{}'",
                       error->is_string() ? error->get<std::string>() : error->dump());
  }

  /// Ends the process if something is wrong: its other answers mean nothing either.
  std::string accepted(std::string why) {
    if (why.empty()) return {};
    identity_.reset();
    return process_.refuse(why);
  }

  SimulatorParameters parameters_;
  NumberedProcess process_;
  std::optional<SimulatorIdentity> identity_;  // once it has said hello
  std::uint64_t test_ = 0;
  std::size_t step_ = 0;
  int steps_ = 1;
  SimulatedCast cast_;
};

}  // namespace

std::span<const SettingKey> process_keys() { return kProcessKeys; }

std::vector<SettingProblem> check_process(const SimulatorParameters& parameters,
                                          const SimulatedSite* /*site*/) {
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

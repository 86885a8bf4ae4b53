// SPDX-License-Identifier: Apache-2.0
#pragma once

// A world that is a program of the user's own, in any language, and speaks the environment
// protocol: docs/reference/environment_protocol.md describes it. The program is started by start(),
// gets the agents' names from begin_run(), and is asked once a tick. It ends with this object.

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "env/environment_process/environment_messages.h"
#include "env/environment_process/percept_texts.h"
#include "env/process/numbered_process.h"
#include "interpreter/support/diagnostics.h"
#include <jaywalk/environment.h>

namespace jaywalk {

class ProcessEnvironment final : public Environment {
 public:
  static constexpr double kAnswerS = 10;

  struct Settings {
    /// A program, found as the shell does, and its arguments; the folder where it runs.
    std::vector<std::string> command;
    std::string folder;
    /// Terms for the program, as text.
    std::vector<std::string> arguments;
    /// Seconds that the first answer, and each other one, may take.
    double start_s = 60;
    double answer_s = kAnswerS;
    /// Receives what the world shows to the user, and what it wrote to standard error.
    std::function<void(std::string_view text)> show;
    std::function<void(std::string_view text)> show_errors;
  };

  /// The agents of a run.
  struct Agents {
    /// How many there are when the run begins.
    std::size_t count = 0;
    std::function<std::string(AgentId)> name;
    /// When the next timer of an agent is due, in milliseconds of virtual time; nothing if none is.
    std::function<std::optional<double>()> next_timer_ms;
  };

  explicit ProcessEnvironment(Settings settings);
  /// Tells the program to end; it is killed if it has not ended after a second.
  ~ProcessEnvironment() override;
  ProcessEnvironment(const ProcessEnvironment&) = delete;
  ProcessEnvironment& operator=(const ProcessEnvironment&) = delete;

  /// Starts the program and asks who it is. False: failure() says why not.
  [[nodiscard]] bool start();
  [[nodiscard]] const EnvironmentIdentity& identity() const { return identity_; }
  /// The run's agents have been made. False: failure() says why the world cannot begin.
  /// REQUIRES: start() was true, and the run has begun.
  [[nodiscard]] bool begin_run(std::uint64_t seed, Agents agents);

  /// Why the world cannot go on, in words for people; empty while all is well.
  [[nodiscard]] const std::string& failure() const { return failure_; }
  /// The mistakes in the texts of its last answer, with their places.
  [[nodiscard]] const Diagnostics& mistakes() const { return mistakes_; }
  /// A question that belongs to no tick, such as a call of an internal action that the program has.
  /// Its number; none if the world has failed. It may take long: a person may be asked.
  [[nodiscard]] std::optional<std::size_t> call(nlohmann::json question, nlohmann::json& answer);
  /// Its answers since the last call that have more than a world for agents: `called`, `events`.
  [[nodiscard]] std::vector<nlohmann::json> take_news() { return std::exchange(news_, {}); }
  /// Ends the program now rather than with this object, so that all it wrote is shown.
  void end();

  void use_names(SymbolTable& symbols) override;
  void perceive(AgentId agent, Percepts& percepts) const override;
  [[nodiscard]] bool is_unchanged(AgentId agent) const override;
  void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) override;
  void take_results(const ResultReceiver& deliver) override;
  void advance() override;
  [[nodiscard]] bool finished() const override { return finished_ || !failure_.empty(); }
  [[nodiscard]] double tick_ms() const override { return tick_ms_; }

 private:
  using Json = nlohmann::json;
  using Clock = std::chrono::steady_clock;

  /// An agent, as far as the world knows it.
  struct Mind {
    std::string name;
    std::vector<PerceptPtr> percepts;
    /// They have not changed in the last tick.
    bool is_unchanged = false;
    bool has_left = false;
  };

  void show_errors();
  void add_mind();
  [[nodiscard]] Json agent_names() const;
  [[nodiscard]] bool note_who_came_and_left();
  [[nodiscard]] bool ask(Json question, double limit_s, Json& answer);
  /// `wait_s`: by how much later the answer may come.
  [[nodiscard]] bool ask_and_apply(Json question, double wait_s = 0);
  void reject(std::string why);
  [[nodiscard]] bool refuse_if_wrong();

  // Parts of an answer.
  void apply(const Json& answer);
  void apply_percepts(const Json& percepts);
  void apply_changes(const Json& changes);
  void apply_done(const Json& done);
  /// The percepts of an agent, or those of all, to be changed.
  [[nodiscard]] std::vector<PerceptPtr>* percepts_of(const std::string& agent);
  [[nodiscard]] std::vector<PerceptPtr> literals(const Json& texts, std::string_view agent);
  void replace(std::vector<PerceptPtr>& percepts, std::vector<PerceptPtr> others);
  void remove(std::vector<PerceptPtr>& percepts, const std::vector<PerceptPtr>& removed);
  void add(std::vector<PerceptPtr>& percepts, const std::vector<PerceptPtr>& added);
  void note_look(AgentId agent) const;

  Settings settings_;
  NumberedProcess process_;
  EnvironmentIdentity identity_;
  std::size_t question_ = 0;
  SymbolTable* symbols_ = nullptr;
  std::optional<PerceptTexts> texts_;
  Agents agents_;
  std::uint64_t seed_ = 0;
  std::vector<Mind> minds_;  // by the agents' numbers
  /// The tick in which each agent perceived last; one that did not in the last one has left.
  mutable std::vector<std::uint64_t> looked_at_;
  std::unordered_map<std::string, std::size_t> by_name_;
  std::vector<PerceptPtr> common_;
  bool is_common_unchanged_ = false;
  /// Removed by the last answer; agents compare them with what they perceive in their next look.
  std::vector<PerceptPtr> removed_;
  /// Marks literals; another number for each purpose.
  mutable std::uint64_t mark_ = 0;
  std::uint64_t tick_ = 0;
  /// The actions whose outcome is not known.
  std::unordered_set<std::uint64_t> pending_;
  /// Outcomes that have come and were not taken.
  std::map<std::uint64_t, ActionResult> done_;
  double tick_ms_ = 0;
  double time_ms_ = 0;
  Clock::time_point tick_began_;
  bool finished_ = false;
  bool started_ = false;
  std::string problem_;  // the first one of an answer
  std::string failure_;
  Diagnostics mistakes_;
  std::vector<Json> news_;
};

}  // namespace jaywalk

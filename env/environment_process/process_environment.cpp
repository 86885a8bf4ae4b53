// SPDX-License-Identifier: Apache-2.0
#include "env/environment_process/process_environment.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "env/process/message_reader.h"
#include "interpreter/environment/percepts.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

using nlohmann::json;

/// How long a free-running world may wait for something to happen.
constexpr double kLongestWaitMs = 1000;

/// How many seconds a call may take: a day. Ctrl-C ends it.
constexpr double kCallS = 86'400;

/// The name for all agents in answers, and that of an answer in messages.
constexpr std::string_view kEveryAgent = "*";
constexpr std::string_view kAnswer = "its answer";

std::chrono::milliseconds duration(double seconds) {
  return std::chrono::milliseconds(std::lround(seconds * 1000));
}

/// Null if there is none.
const json* field(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

}  // namespace

ProcessEnvironment::ProcessEnvironment(Settings settings)
    : settings_(std::move(settings)),
      process_({.command = settings_.command, .folder = settings_.folder, .key = "n"}) {}

ProcessEnvironment::~ProcessEnvironment() { end(); }

void ProcessEnvironment::end() {
  if (started_) {
    process_.tell({{"type", "bye"}, {"n", question_}}, std::chrono::milliseconds(100));
  }
  started_ = false;
  process_.finish();
  show_errors();
}

void ProcessEnvironment::show_errors() {
  const std::string errors = process_.take_errors();
  if (!errors.empty() && settings_.show_errors) settings_.show_errors(errors);
}

bool ProcessEnvironment::start() {
  json answer;
  if (!ask(environment_hello(settings_.arguments), settings_.start_s, answer)) return false;
  reject(read_environment_hello(answer, identity_));
  started_ = refuse_if_wrong();
  tick_ms_ = identity_.tick_ms;
  return started_;
}

void ProcessEnvironment::use_names(SymbolTable& symbols) {
  symbols_ = &symbols;
  texts_.emplace(symbols);
}

bool ProcessEnvironment::begin_run(std::uint64_t seed, Agents agents) {
  agents_ = std::move(agents);
  seed_ = seed;
  for (std::size_t i = 0; i < agents_.count; ++i) add_mind();
  const bool began = ask_and_apply({{"type", "init"}, {"seed", seed_}, {"agents", agent_names()}});
  tick_began_ = Clock::now();
  return began;
}

void ProcessEnvironment::add_mind() {
  Mind& mind = minds_.emplace_back();
  mind.name = agents_.name(AgentId{static_cast<std::uint32_t>(minds_.size() - 1)});
  by_name_[mind.name] = minds_.size() - 1;
  looked_at_.resize(std::max(looked_at_.size(), minds_.size()), tick_);
}

json ProcessEnvironment::agent_names() const {
  json names = json::array();
  for (const Mind& mind : minds_) {
    if (!mind.has_left) names.push_back(mind.name);
  }
  return names;
}

// The world as agents see it.

void ProcessEnvironment::note_look(AgentId agent) const {
  const auto number = static_cast<std::size_t>(agent);
  if (number >= looked_at_.size()) looked_at_.resize(number + 1, tick_);
  looked_at_[number] = tick_ + 1;
}

void ProcessEnvironment::perceive(AgentId agent, Percepts& percepts) const {
  note_look(agent);
  const std::uint64_t mark = ++mark_;
  const auto add = [&](const PerceptPtr& percept) {
    if (std::exchange(percept->content->mark, mark) != mark) {
      add_percept(percepts, percept->literal);
    }
  };
  std::ranges::for_each(common_, add);
  const auto number = static_cast<std::size_t>(agent);
  if (number < minds_.size()) std::ranges::for_each(minds_[number].percepts, add);
}

bool ProcessEnvironment::is_unchanged(AgentId agent) const {
  note_look(agent);
  const auto number = static_cast<std::size_t>(agent);
  return is_common_unchanged_ && number < minds_.size() && minds_[number].is_unchanged;
}

void ProcessEnvironment::execute(std::span<const ActionRequest> actions,
                                 std::span<ActionResult> results) {
  ++tick_;
  // Every agent has looked since they were removed.
  removed_.clear();
  is_common_unchanged_ = true;
  for (Mind& mind : minds_) mind.is_unchanged = true;
  // One that was created in this tick may act before it looks.
  for (const ActionRequest& action : actions) {
    const auto agent = static_cast<std::size_t>(action.agent);
    if (agent >= looked_at_.size()) looked_at_.resize(agent + 1, tick_);
  }
  if (!note_who_came_and_left()) return;
  json asked = json::array();
  for (const ActionRequest& action : actions) {
    pending_.insert(action.number);
    asked.push_back(
        action_json(minds_[static_cast<std::size_t>(action.agent)].name, action, *symbols_));
  }
  json question{{"type", "tick"}, {"time_ms", time_ms_}, {"actions", std::move(asked)}};
  const auto timer_ms = agents_.next_timer_ms ? agents_.next_timer_ms() : std::nullopt;
  if (pending_.empty() && !timer_ms) question["idle"] = true;
  double wait_ms = 0;
  if (identity_.free_running) {
    wait_ms = timer_ms ? std::clamp(*timer_ms - time_ms_, 0.0, kLongestWaitMs) : kLongestWaitMs;
    question["wait_ms"] = wait_ms;
  }
  if (!ask_and_apply(std::move(question), wait_ms / 1000)) return;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const auto done = done_.find(actions[i].number);
    results[i].is_pending = done == done_.end();
    if (done == done_.end()) continue;
    results[i] = std::move(done->second);
    done_.erase(done);
  }
}

void ProcessEnvironment::take_results(const ResultReceiver& deliver) {
  for (auto& [number, result] : done_) deliver(number, std::move(result));
  done_.clear();
}

void ProcessEnvironment::advance() {
  if (identity_.free_running) {
    const Clock::time_point now = Clock::now();
    tick_ms_ = std::chrono::duration<double, std::milli>(now - tick_began_).count();
    tick_began_ = now;
  }
  time_ms_ += tick_ms_;
}

// Agents that did not perceive in this tick are gone; those that perceived without being known are
// new, and perceive something from the next tick on.
bool ProcessEnvironment::note_who_came_and_left() {
  json left = json::array();
  json joined = json::array();
  for (std::size_t i = 0; i < minds_.size(); ++i) {
    Mind& mind = minds_[i];
    if (mind.has_left || looked_at_[i] == tick_) continue;
    mind.has_left = true;
    replace(mind.percepts, {});
    left.push_back(mind.name);
  }
  while (minds_.size() < looked_at_.size()) {
    add_mind();
    Mind& mind = minds_.back();
    // Some come and leave between two ticks.
    mind.has_left = looked_at_[minds_.size() - 1] != tick_ || mind.name.empty();
    if (!mind.has_left) joined.push_back(mind.name);
  }
  if (left.empty() && joined.empty()) return true;
  return ask_and_apply({{"type", "agents"},
                        {"seed", seed_},
                        {"agents", agent_names()},
                        {"joined", std::move(joined)},
                        {"left", std::move(left)}});
}

// Questions.

bool ProcessEnvironment::ask(json question, double limit_s, json& answer) {
  JsonAnswer said = process_.ask(std::move(question), question_++, duration(limit_s));
  show_errors();
  if (!said.error.empty()) {
    failure_ = std::move(said.error);
    started_ = false;
    return false;
  }
  answer = std::move(said.json);
  if (const json* const error = field(answer, "error")) {
    (void)process_.refuse({});
    failure_ = fmt::format("it reports '{}'",
                           error->is_string() ? error->get<std::string>() : error->dump());
    started_ = false;
    return false;
  }
  if (answer.contains("called") || answer.contains("events")) news_.push_back(answer);
  if (!answer.contains("n")) reject("there is no 'n', the number of the question");
  return refuse_if_wrong();
}

std::optional<std::size_t> ProcessEnvironment::call(json question, json& answer) {
  if (!started_) return std::nullopt;
  const std::size_t number = question_;
  if (!ask(std::move(question), kCallS, answer)) return std::nullopt;
  return number;
}

bool ProcessEnvironment::ask_and_apply(json question, double wait_s) {
  json answer;
  if (!ask(std::move(question), settings_.answer_s + wait_s, answer)) return false;
  apply(answer);
  return refuse_if_wrong();
}

/// Keeps the first thing that is wrong in an answer.
void ProcessEnvironment::reject(std::string why) {
  if (problem_.empty()) problem_ = std::move(why);
}

/// Ends the program if something was wrong with its last answer. Whether all was well.
bool ProcessEnvironment::refuse_if_wrong() {
  if (problem_.empty() && mistakes_.empty()) return true;
  failure_ = process_.refuse(problem_.empty() ? "it has wrong percepts" : problem_);
  started_ = false;
  return false;
}

// Answers.

void ProcessEnvironment::apply(const json& answer) {
  if (const json* const percepts = field(answer, "percepts")) apply_percepts(*percepts);
  if (const json* const changes = field(answer, "changes")) apply_changes(*changes);
  if (const json* const done = field(answer, "done")) apply_done(*done);
  MessageReader reader;
  finished_ = reader.flag_or(answer, "finished", kAnswer, false) || finished_;
  if (answer.contains("text")) {
    const std::string text = reader.text(answer, "text", kAnswer);
    if (settings_.show && reader.problem().empty()) settings_.show(text);
  }
  reject(reader.problem());
}

void ProcessEnvironment::apply_percepts(const json& percepts) {
  if (!percepts.is_object()) return reject("'percepts' is not an object");
  for (const auto& [agent, texts] : percepts.items()) {
    if (std::vector<PerceptPtr>* const own = percepts_of(agent)) {
      replace(*own, literals(texts, agent));
    }
  }
}

void ProcessEnvironment::apply_changes(const json& changes) {
  if (!changes.is_object()) return reject("'changes' is not an object");
  for (const auto& [agent, change] : changes.items()) {
    std::vector<PerceptPtr>* const own = percepts_of(agent);
    if (own == nullptr) continue;
    if (!change.is_object())
      return reject(fmt::format("the changes of '{}' are not an object", agent));
    if (const json* const removed = field(change, "remove"))
      remove(*own, literals(*removed, agent));
    if (const json* const added = field(change, "add")) add(*own, literals(*added, agent));
  }
}

void ProcessEnvironment::apply_done(const json& done) {
  if (!done.is_array()) return reject("'done' is not a list");
  for (const json& each : done) {
    const json* const id = each.is_object() ? field(each, "id") : nullptr;
    if (id == nullptr || !id->is_number_unsigned()) {
      return reject(fmt::format("'done' has {}, expected {{\"id\": <number of an action>}}",
                                shortened(each.dump(), kMostQuoted)));
    }
    const auto number = id->get<std::uint64_t>();
    if (pending_.erase(number) == 0) {
      return reject(fmt::format("no action {} is under way", id->dump()));
    }
    ActionResult result;
    if (const json* const why = field(each, "failed")) {
      if (!why->is_string())
        return reject(fmt::format("the reason why action {} failed is not a text", id->dump()));
      result = {false, why->get<std::string>()};
    }
    done_[number] = std::move(result);
  }
}

/// Null if nothing is kept of that agent: it is unknown, which is wrong, or it has left.
std::vector<PerceptPtr>* ProcessEnvironment::percepts_of(const std::string& agent) {
  if (agent == kEveryAgent) {
    is_common_unchanged_ = false;
    return &common_;
  }
  const auto found = by_name_.find(agent);
  if (found != by_name_.end()) {
    Mind& mind = minds_[found->second];
    mind.is_unchanged = false;
    return mind.has_left ? nullptr : &mind.percepts;
  }
  std::vector<std::string> names;
  for (const Mind& mind : minds_) {
    if (!mind.has_left) names.push_back(mind.name);
  }
  const std::string hint = did_you_mean(agent, names);
  reject(fmt::format("there is no agent '{}'{}{}", shortened(agent, kMostQuoted),
                     hint.empty() ? "" : "; ", hint));
  return nullptr;
}

/// Each once, in order.
std::vector<PerceptPtr> ProcessEnvironment::literals(const json& texts, std::string_view agent) {
  const std::string of =
      agent == kEveryAgent ? "a percept of every agent" : fmt::format("a percept of {}", agent);
  std::vector<PerceptPtr> read;
  if (!texts.is_array()) {
    reject(fmt::format("the percepts of '{}' are not a list", agent));
    return read;
  }
  const std::uint64_t mark = ++mark_;
  for (const json& text : texts) {
    if (!text.is_string()) {
      reject(fmt::format("{} is not a text: {}", of, shortened(text.dump(), kMostQuoted)));
      continue;
    }
    PerceptPtr percept = texts_->read(text.get_ref<const std::string&>(), of, mistakes_);
    if (percept != nullptr && std::exchange(percept->content->mark, mark) != mark) {
      read.push_back(std::move(percept));
    }
  }
  return read;
}

void ProcessEnvironment::replace(std::vector<PerceptPtr>& percepts,
                                 std::vector<PerceptPtr> others) {
  std::ranges::move(percepts, std::back_inserter(removed_));
  percepts = std::move(others);
}

void ProcessEnvironment::remove(std::vector<PerceptPtr>& percepts,
                                const std::vector<PerceptPtr>& removed) {
  const std::uint64_t mark = ++mark_;
  for (const PerceptPtr& each : removed) each->content->mark = mark;
  const auto stay =
      std::stable_partition(percepts.begin(), percepts.end(),
                            [mark](const PerceptPtr& each) { return each->content->mark != mark; });
  std::move(stay, percepts.end(), std::back_inserter(removed_));
  percepts.erase(stay, percepts.end());
}

void ProcessEnvironment::add(std::vector<PerceptPtr>& percepts,
                             const std::vector<PerceptPtr>& added) {
  const std::uint64_t mark = ++mark_;
  for (const PerceptPtr& each : percepts) each->content->mark = mark;
  for (const PerceptPtr& each : added) {
    if (each->content->mark != mark) percepts.push_back(each);
  }
}

}  // namespace jaywalk

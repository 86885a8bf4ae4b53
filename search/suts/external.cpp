// SPDX-License-Identifier: Apache-2.0
// A SUT that is a program of its own: it reads a test in one line of JSON, a road or named inputs,
// and answers with the outcome in another, measures or signals. Whatever it does wrong (it crashes,
// hangs, answers nonsense, answers another test, says more than it was asked) costs the test alone;
// it is started anew for the next one. docs/reference/system_protocol.md has the protocol,
// scenarios/search/external_sut.py and scenarios/search/archcomp/ have examples.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "env/process/numbered_process.h"
#include "interpreter/support/text.h"
#include "search/suts/input_space.h"
#include "search/suts/requirements.h"
#include "search/suts/road_space.h"
#include "search/suts/suts.h"

namespace jaywalk::search {
namespace {

using Json = nlohmann::json;

struct ExternalSettings {
  std::vector<std::string> command;
  std::string folder;
  double timeout_s = 60;
  /// Numbers that the program answers.
  std::vector<std::string> measures;
  /// Signals that it answers, and what is required of them.
  Requirements requirements;
};

/// The least robustness of all requirements, without a unit.
constexpr std::string_view kRobustness = "robustness";
/// Keys of a test and its answer that are no measures.
constexpr std::array<std::string_view, 6> kProtocol = {"test",    "sim_time",  "error",
                                                       "invalid", kTimeSignal, kRobustness};

/// How long a program that does not repeat the test's number is watched, after an answer, for lines
/// without a request.
constexpr std::chrono::milliseconds kSettling{20};

/// The test: the points, and the map as the competition's executors want it.
Json road_request(const RoadSpace& space, const TestInput& input) {
  Json points = Json::array();
  for (const Point& point : space.road_points(input)) {
    points.push_back(Json::array({point.x_m, point.y_m}));
  }
  return Json{{"map_size", space.settings().rules.map_m}, {"road_points", std::move(points)}};
}

/// Makes a test's message of its input.
using Request = std::function<Json(const TestInput& input)>;

class ExternalProgram : public Sut {
 public:
  ExternalProgram(Request request, const ExternalSettings& settings)
      : request_(std::move(request)),
        settings_(settings),
        process_({.command = settings.command,
                  .folder = settings.folder,
                  .key = "test",
                  .settling = kSettling}) {}

  Outcome run(const TestInput& input, std::size_t test) override {
    const std::chrono::milliseconds limit(std::lround(1000 * settings_.timeout_s));
    const JsonAnswer answer = process_.ask(request_(input), test, limit);
    if (answer.error.empty()) return read(answer.json);
    return failed(answer.error, answer.silent ? settings_.timeout_s : 0);
  }

 private:
  Outcome failed(const std::string& what, double seconds = 0) {
    return {.error = fmt::format("{}: {}", fmt::join(settings_.command, " "), what),
            .simulated_s = seconds};
  }

  /// The program is given up; the next test starts another one.
  Outcome nonsense(std::string_view what) { return failed(process_.refuse(what)); }

  /// Not a number for anything else.
  static double number_in(const Json& value) {
    return value.is_number() ? value.get<double>() : std::nan("");
  }

  Outcome read(const Json& json) {
    if (const auto error = json.find("error"); error != json.end() && error->is_string()) {
      // The program goes on; it could not execute this test.
      return failed(fmt::format("it says '{}'", shortened(error->get<std::string>(), kMostQuoted)));
    }
    if (const auto why = json.find("invalid"); why != json.end() && why->is_string()) {
      const std::string text = shortened(why->get<std::string>(), kMostQuoted);
      return {.error = {}, .refused = text.empty() ? "the program does not say why" : text};
    }
    Outcome outcome;
    if (!settings_.requirements.signals.empty()) {
      if (std::string why = judge(json, outcome); !why.empty()) return nonsense(why);
    }
    if (const auto time = json.find("sim_time"); time != json.end()) {
      outcome.simulated_s = number_in(*time);
    }
    const std::size_t judged = outcome.measures.size();
    for (const std::string& measure : settings_.measures) {
      const auto value = json.find(measure);
      if (value == json.end()) return nonsense(fmt::format("there is no '{}'", measure));
      outcome.measures.push_back(number_in(*value));
    }
    std::vector<std::string> names(judged, std::string(kRobustness));
    names.insert(names.end(), settings_.measures.begin(), settings_.measures.end());
    const std::string why = why_nonsense(outcome, "sim_time", names);
    return why.empty() ? outcome : nonsense(why);
  }

  /// Reads the signals and measures what the requirements say of them. Why they are none, in words
  /// for people; empty if they are.
  std::string judge(const Json& json, Outcome& outcome) const {
    const Requirements& requirements = settings_.requirements;
    std::vector<std::vector<double>> values(requirements.signals.size() + 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string name(i == 0 ? kTimeSignal : requirements.signals[i - 1].name);
      const auto found = json.find(name);
      if (found == json.end()) return fmt::format("there is no '{}'", name);
      if (!found->is_array()) return fmt::format("'{}' is no list of numbers", name);
      for (const Json& each : *found) {
        values[i].push_back(number_in(each));
        if (std::fabs(values[i].back()) <= kGreatestValue) continue;
        return fmt::format("'{}' has {} where a number up to {:g} is expected", name,
                           shortened(each.dump(), kMostQuoted), kGreatestValue);
      }
      if (values[i].size() != values[0].size()) {
        return fmt::format("'{}' has {} values, 'time' has {}", name, values[i].size(),
                           values[0].size());
      }
    }
    if (std::string why = why_no_times(values[0]); !why.empty()) return why;
    outcome.simulated_s = values[0].back() - values[0].front();
    if (requirements.all.empty()) return {};
    const std::vector<Robustness> judgements = requirements.judge(values);
    outcome.measures.push_back(std::ranges::min(judgements, {}, &Robustness::scaled).scaled);
    for (const Robustness& each : judgements) {
      outcome.measures.push_back(each.own);
      outcome.measures.push_back(each.scaled);
    }
    return {};
  }

  static constexpr double kGreatestValue = 1e12;

  Request request_;
  const ExternalSettings& settings_;
  NumberedProcess process_;
};

/// A program, whatever it gets.
class External : public SutModel {
 public:
  explicit External(ExternalSettings settings) : settings_(std::move(settings)) {
    for (const Requirement& each : settings_.requirements.all) {
      names_.push_back(
          {each.id + "_robustness", each.id + "_scaled", std::string(each.condition.written.text)});
    }
    // From here on the names stay where they are.
    if (!names_.empty()) {
      kinds_.push_back({kRobustness, "of the requirement that the test kept least", 1, 0, 1});
    }
    for (std::size_t i = 0; i < names_.size(); ++i) {
      kinds_.push_back({.name = names_[i].own,
                        .meaning = names_[i].meaning,
                        .requirement = settings_.requirements.all[i].id});
      kinds_.push_back({names_[i].scaled, names_[i].meaning, 1, 0, 1});
    }
    for (const std::string& measure : settings_.measures) {
      kinds_.push_back({measure, "as the program answers it"});
    }
  }

  [[nodiscard]] std::vector<std::string> command() const override { return settings_.command; }
  [[nodiscard]] std::span<const MeasureKind> measures() const override { return kinds_; }
  [[nodiscard]] std::vector<SutSetting> settings() const override {
    std::vector<SutSetting> all{
        {"command", fmt::format("{}", fmt::join(settings_.command, " "))},
        {"time limit", fmt::format("{:.6g} s for an answer", settings_.timeout_s)},
        input_setting()};
    for (const Requirement& each : settings_.requirements.all) {
      all.push_back({each.id, each.condition.written.text});
    }
    return all;
  }

 protected:
  [[nodiscard]] virtual SutSetting input_setting() const = 0;
  [[nodiscard]] std::unique_ptr<Sut> start(Request request) const {
    return std::make_unique<ExternalProgram>(std::move(request), settings_);
  }

 private:
  /// How a requirement's measures are called.
  struct Names {
    std::string own;
    std::string scaled;
    std::string meaning;
  };

  ExternalSettings settings_;
  std::vector<Names> names_;
  std::vector<MeasureKind> kinds_;
};

class ExternalOnRoads : public External {
 public:
  ExternalOnRoads(const RoadSpaceSettings& space, ExternalSettings settings)
      : External(std::move(settings)), space_(space) {}

  [[nodiscard]] const SearchSpace& space() const override { return space_; }
  [[nodiscard]] std::unique_ptr<Sut> make() const override {
    return start([this](const TestInput& input) { return road_request(space_, input); });
  }
  [[nodiscard]] const RoadSpace* road_space() const override { return &space_; }

 private:
  [[nodiscard]] SutSetting input_setting() const override {
    return road_setting(space_.settings());
  }

  RoadSpace space_;
};

class ExternalWithInputs : public External {
 public:
  ExternalWithInputs(InputSpaceSettings space, ExternalSettings settings)
      : External(std::move(settings)), space_(std::move(space)) {}

  [[nodiscard]] const SearchSpace& space() const override { return space_; }
  [[nodiscard]] std::unique_ptr<Sut> make() const override {
    return start([this](const TestInput& input) { return space_.request(input); });
  }

 private:
  [[nodiscard]] SutSetting input_setting() const override { return {"inputs", space_.text()}; }

  InputSpace space_;
};

std::vector<std::string> read_words(const ConfigNode& node, const ConfigReader& reader,
                                    std::string_view expected) {
  std::vector<std::string> words;
  if (node.kind != ConfigNode::Kind::list || node.items.empty()) {
    reader.unexpected(node, fmt::format("a list of {}s", expected));
    return words;
  }
  for (const ConfigNode& item : node.items) {
    if (auto word = reader.text(item, fmt::format("a {}", expected))) {
      words.push_back(std::move(*word));
    }
  }
  return words;
}

/// Measures under names that mean something else.
void check_names(const ConfigNode& node, const ConfigReader& reader,
                 const ExternalSettings& settings) {
  std::set<std::string> taken(kProtocol.begin(), kProtocol.end());
  for (const ReturnedSignal& each : settings.requirements.signals) taken.insert(each.name);
  for (const Requirement& each : settings.requirements.all) {
    taken.insert({each.id + "_robustness", each.id + "_scaled"});
  }
  for (const ConfigNode& item : node.items) {
    if (item.text.empty() || taken.insert(item.text).second) continue;
    reader.error(item.origin, fmt::format("'{}' cannot be the name of a measure", item.text),
                 "it stands for something else in the answers, or is a signal, or there twice");
  }
}

}  // namespace

namespace sut::external {

std::shared_ptr<const SutModel> read(const SutSetup& setup) {
  const ConfigReader& reader = setup.reader;
  const ConfigNode& node = setup.node;
  RoadSpaceSettings roads;
  InputSpaceSettings inputs;
  ExternalSettings settings{.command = {}, .folder = setup.folder};
  // Of signals alone there need be no measures.
  if (node.find("requirements") == nullptr) settings.measures = {"max_oob"};
  const auto ignored = [](const ConfigNode&, const std::string&) {};
  const std::vector<ConfigKey> keys{
      {"kind", ignored},
      {"command",
       [&](const ConfigNode& value, const std::string&) {
         settings.command = read_words(value, reader, "word");
       }},
      {"timeout_s", number_into(settings.timeout_s, reader, {0.01, 86400})},
      {"duration_s", number_into(inputs.duration_s, reader, {1e-6, 1e6})},
      {"sample_s", number_into(inputs.sample_s, reader, {1e-6, 1e6})},
      {"inputs", [&](const ConfigNode& value,
                     const std::string& path) { read_inputs(value, path, reader, inputs); }},
      {"signals", [&](const ConfigNode& value,
                      const std::string&) { read_signals(value, reader, settings.requirements); }},
      {"requirements",
       [&](const ConfigNode& value, const std::string& path) {
         const double end = inputs.duration_s;
         read_requirements(value, path, reader, end > 0 ? SignalRange{0, end} : SignalRange{},
                           settings.requirements);
       }},
      {"measures",
       [&](const ConfigNode& value, const std::string&) {
         settings.measures = read_words(value, reader, "name");
         check_names(value, reader, settings);
       }},
      {"roads", [&](const ConfigNode& value,
                    const std::string& path) { read_road_space(value, path, reader, roads); }},
  };
  reader.read_map(node, setup.path, keys);
  if (node.find("command") == nullptr) {
    reader.error(node.origin, "no 'command' to start the program with",
                 "for example command: [python3, external_sut.py]");
  }
  if (node.find("requirements") != nullptr && node.find("signals") == nullptr) {
    reader.error(node.find("requirements")->origin, "requirements of signals that are not named",
                 "'signals' names what the program returns, signals: {speed: [0, 160]}");
  }
  if (node.find("inputs") == nullptr) {
    for (const std::string_view key : {"duration_s", "sample_s"}) {
      if (const ConfigNode* const value = node.find(key)) {
        reader.error(value->origin, fmt::format("'{}' is of signals among 'inputs'", key));
      }
    }
    return std::make_shared<ExternalOnRoads>(roads, std::move(settings));
  }
  if (const ConfigNode* const both = node.find("roads")) {
    reader.error(both->origin, "the program gets roads or 'inputs', not both");
  }
  if (node.find("measures") == nullptr && node.find("requirements") == nullptr) {
    reader.error(node.origin, "nothing says how bad a test was",
                 "'measures' names numbers that the program answers, 'requirements' has conditions "
                 "over its 'signals'");
  }
  check_inputs(node, reader, inputs);
  if (inputs.inputs.empty()) return nullptr;  // reported
  return std::make_shared<ExternalWithInputs>(std::move(inputs), std::move(settings));
}

}  // namespace sut::external

}  // namespace jaywalk::search

// SPDX-License-Identifier: Apache-2.0
// A SUT that is a program of its own: it reads a road in one line of JSON and answers with the
// outcome in another. Whatever it does wrong (it crashes, hangs, answers nonsense, answers another
// test, says more than it was asked) costs the test alone; it is started anew for the next one.
// docs/reference/search.md has the protocol, scenarios/search/external_sut.py an example.

#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "env/process/numbered_process.h"
#include "interpreter/support/text.h"
#include "search/suts/road_space.h"
#include "search/suts/suts.h"

namespace jaywalk::search {
namespace {

using Json = nlohmann::json;

struct ExternalSettings {
  std::vector<std::string> command;
  std::string folder;
  double timeout_s = 60;
  std::vector<std::string> measures;
};

/// How long a program that does not repeat the test's number is watched, after an answer, for lines
/// without a request.
constexpr std::chrono::milliseconds kSettling{20};

/// The test: the points, and the map as the competition's executors want it.
Json request(const RoadSpace& space, const TestInput& input) {
  Json points = Json::array();
  for (const Point& point : space.road_points(input)) {
    points.push_back(Json::array({point.x_m, point.y_m}));
  }
  return Json{{"map_size", space.settings().rules.map_m}, {"road_points", std::move(points)}};
}

class ExternalProgram : public Sut {
 public:
  ExternalProgram(const RoadSpace& space, const ExternalSettings& settings)
      : space_(space),
        settings_(settings),
        process_({.command = settings.command,
                  .folder = settings.folder,
                  .key = "test",
                  .settling = kSettling}) {}

  Outcome run(const TestInput& input, std::size_t test) override {
    const std::chrono::milliseconds limit(std::lround(1000 * settings_.timeout_s));
    const JsonAnswer answer = process_.ask(request(space_, input), test, limit);
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
    Outcome outcome;
    if (const auto time = json.find("sim_time"); time != json.end()) {
      outcome.simulated_s = number_in(*time);
    }
    for (const std::string& measure : settings_.measures) {
      const auto value = json.find(measure);
      if (value == json.end()) return nonsense(fmt::format("there is no '{}'", measure));
      outcome.measures.push_back(number_in(*value));
    }
    const std::string why = why_nonsense(outcome, "sim_time", settings_.measures);
    return why.empty() ? outcome : nonsense(why);
  }

  const RoadSpace& space_;
  const ExternalSettings& settings_;
  NumberedProcess process_;
};

class External : public SutModel {
 public:
  External(const RoadSpaceSettings& space, ExternalSettings settings)
      : space_(space), settings_(std::move(settings)) {
    for (const std::string& measure : settings_.measures) {
      kinds_.push_back({measure, "as the program answers it"});
    }
  }

  [[nodiscard]] const SearchSpace& space() const override { return space_; }
  [[nodiscard]] std::span<const MeasureKind> measures() const override { return kinds_; }
  [[nodiscard]] std::unique_ptr<Sut> make() const override {
    return std::make_unique<ExternalProgram>(space_, settings_);
  }
  [[nodiscard]] std::vector<SutSetting> settings() const override {
    return {{"command", fmt::format("{}", fmt::join(settings_.command, " "))},
            {"time limit", fmt::format("{:.6g} s for an answer", settings_.timeout_s)},
            road_setting(space_.settings())};
  }
  [[nodiscard]] const RoadSpace* road_space() const override { return &space_; }
  [[nodiscard]] std::vector<std::string> command() const override { return settings_.command; }

 private:
  RoadSpace space_;
  ExternalSettings settings_;
  std::vector<MeasureKind> kinds_;
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

}  // namespace

namespace sut::external {

std::shared_ptr<const SutModel> read(const SutSetup& setup) {
  const ConfigReader& reader = setup.reader;
  RoadSpaceSettings space;
  ExternalSettings settings{.folder = setup.folder, .measures = {"max_oob"}};
  const auto ignored = [](const ConfigNode&, const std::string&) {};
  const std::vector<ConfigKey> keys{
      {"kind", ignored},
      {"command",
       [&](const ConfigNode& value, const std::string&) {
         settings.command = read_words(value, reader, "word");
       }},
      {"timeout_s", number_into(settings.timeout_s, reader, {0.01, 86400})},
      {"measures",
       [&](const ConfigNode& value, const std::string&) {
         settings.measures = read_words(value, reader, "name");
       }},
      {"roads", [&](const ConfigNode& value,
                    const std::string& path) { read_road_space(value, path, reader, space); }},
  };
  reader.read_map(setup.node, setup.path, keys);
  if (setup.node.find("command") == nullptr) {
    reader.error(setup.node.origin, "no 'command' to start the program with",
                 "for example command: [python3, external_sut.py]");
  }
  return std::make_shared<External>(space, std::move(settings));
}

}  // namespace sut::external

}  // namespace jaywalk::search

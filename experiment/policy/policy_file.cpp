// SPDX-License-Identifier: Apache-2.0
// Policy files, JSON: the policy's origin, then the learned values of each part.

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/policy/policy.h"
#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::uint64_t kVersion = 1;

/// JSON's library would make -1 a large number and 1e300 any.
template <class Number>
Number whole(const json& value) {
  if (!value.is_number_unsigned() || !std::in_range<Number>(value.get<json::number_unsigned_t>())) {
    throw std::invalid_argument(fmt::format("{} is not a whole number in range", value.dump()));
  }
  return value.get<Number>();
}

/// A text that the rule `is_one` of markup.h takes for a name.
std::string name_of(const json& value, bool (*is_one)(std::string_view)) {
  auto name = value.get<std::string>();
  if (!is_one(name)) throw std::invalid_argument(fmt::format("'{}' is no name", name));
  return name;
}

json weights_to_json(const std::vector<std::pair<std::string, double>>& weights) {
  json object = json::object();
  for (const auto& [id, weight] : weights) object[id] = weight;
  return object;
}

std::vector<std::pair<std::string, double>> weights_from_json(const json& object) {
  std::vector<std::pair<std::string, double>> weights;
  for (const auto& [id, weight] : object.items()) {
    weights.emplace_back(name_of(id, is_identifier), weight.get<double>());
  }
  return weights;
}

json settings_to_json(const LearnerSettings& settings) {
  json object{{"bins", settings.bins},
              {"trace", settings.trace},
              {"explores", settings.explores},
              {"explores_least", settings.explores_least},
              {"halves_after", settings.halves_after},
              {"hidden", settings.hidden},
              {"passes", settings.passes},
              {"clip", settings.clip},
              {"entropy", settings.entropy},
              {"entropy_least", settings.entropy_least}};
  if (settings.rate) object["rate"] = *settings.rate;
  return object;
}

LearnerSettings settings_from_json(const json& object) {
  LearnerSettings settings;
  settings.bins = object.at("bins").get<std::vector<double>>();
  settings.trace = object.at("trace").get<double>();
  settings.explores = object.at("explores").get<double>();
  settings.explores_least = object.at("explores_least").get<double>();
  settings.halves_after = object.at("halves_after").get<double>();
  settings.hidden = whole<std::uint32_t>(object.at("hidden"));
  settings.passes = whole<std::uint32_t>(object.at("passes"));
  settings.clip = object.at("clip").get<double>();
  settings.entropy = object.at("entropy").get<double>();
  // Older files have one for all time.
  settings.entropy_least = object.value("entropy_least", settings.entropy);
  if (object.contains("rate")) settings.rate = object.at("rate").get<double>();
  return settings;
}

json spec_to_json(const LearningSpec& spec) {
  return {{"learner", spec.learner},
          {"settings", settings_to_json(spec.settings)},
          {"reward",
           {{"score", spec.reward.score},
            {"precondition", spec.reward.precondition},
            {"violation", weights_to_json(spec.reward.violation)},
            {"robustness", weights_to_json(spec.reward.robustness)},
            {"new_bins", spec.reward.new_bins},
            {"natural_steps", spec.reward.natural_steps}}},
          {"shared", spec.is_shared},
          {"discount", spec.discount},
          {"generation", spec.generation}};
}

LearningSpec spec_from_json(const json& object) {
  LearningSpec spec;
  spec.learner = object.at("learner").get<std::string>();
  spec.settings = settings_from_json(object.at("settings"));
  const json& reward = object.at("reward");
  spec.reward = {.score = reward.at("score").get<double>(),
                 .precondition = reward.at("precondition").get<double>(),
                 .violation = weights_from_json(reward.at("violation")),
                 .robustness = weights_from_json(reward.at("robustness")),
                 .new_bins = reward.at("new_bins").get<double>(),
                 .natural_steps = reward.at("natural_steps").get<double>()};
  spec.is_shared = object.at("shared").get<bool>();
  spec.discount = object.at("discount").get<double>();
  spec.generation = whole<std::uint64_t>(object.at("generation"));
  return spec;
}

PolicyOrigin origin_from_json(const json& object) {
  PolicyOrigin origin;
  origin.behaviour = name_of(object.at("behaviour"), is_identifier);
  origin.program_sha256 = object.at("program_sha256").get<std::string>();
  origin.scenario = object.at("scenario").get<std::string>();
  origin.scenario_sha256 = object.at("scenario_sha256").get<std::string>();
  origin.agents = whole<std::uint32_t>(object.at("agents"));
  origin.seed = whole<std::uint64_t>(object.at("seed"));
  origin.tests = whole<std::uint64_t>(object.at("tests"));
  origin.errored = whole<std::uint64_t>(object.at("errored"));
  origin.spec = spec_from_json(object.at("learning"));
  for (const json& point : object.at("curve")) {
    origin.curve.push_back({.tests = whole<std::uint64_t>(point.at(0)),
                            .reward = point.at(1).get<double>(),
                            .success_pct = point.at(2).get<double>()});
  }
  origin.covered = object.at("covered").get<std::vector<std::string>>();
  return origin;
}

void check_share(std::string_view name, double value) {
  if (value >= 0 && value <= 1) return;
  throw std::invalid_argument(fmt::format("{} is not between 0 and 1", name));
}

/// The limits of a file's values; beyond them it would take all memory or time, or divide by zero.
void check_spec(const LearningSpec& spec) {
  constexpr std::uint32_t kMostUnits = 1024;
  constexpr std::uint32_t kMostPasses = 1000;
  const LearnerSettings& settings = spec.settings;
  if (settings.hidden == 0 || settings.hidden > kMostUnits) {
    throw std::invalid_argument("so many hidden units are not possible");
  }
  if (settings.passes == 0 || settings.passes > kMostPasses) {
    throw std::invalid_argument("so many passes are not possible");
  }
  if (std::ranges::any_of(settings.bins, [](double width) { return !(width > 0); })) {
    throw std::invalid_argument("a bin has no width");
  }
  if (!(settings.halves_after > 0)) throw std::invalid_argument("halves_after is not above 0");
  check_share("trace", settings.trace);
  check_share("rate", settings.rate.value_or(1));
  check_share("explores", settings.explores);
  check_share("explores_least", settings.explores_least);
  check_share("entropy", settings.entropy);
  check_share("entropy_least", settings.entropy_least);
  check_share("discount", spec.discount);
}

std::size_t feature_count(const json& value) {
  constexpr std::int64_t kMostFeatures = 1000;
  const auto count = value.is_number_unsigned() ? value.get<std::int64_t>() : -1;
  if (count < 0 || count > kMostFeatures) throw std::invalid_argument("so many features");
  return static_cast<std::size_t>(count);
}

Span place_of(const SourcePtr& source, std::size_t byte) {
  const auto size = static_cast<std::uint32_t>(source->text().size());
  const std::uint32_t begin =
      std::min(static_cast<std::uint32_t>(byte > 0 ? byte - 1 : 0), size > 0 ? size - 1 : 0);
  return {begin, std::min(begin + 1, size)};
}

}  // namespace

std::string Policy::text() const {
  ordered_json file;
  file["jaywalk_policy"] = kVersion;
  file["behaviour"] = origin_.behaviour;
  file["program_sha256"] = origin_.program_sha256;
  file["scenario"] = origin_.scenario;
  file["scenario_sha256"] = origin_.scenario_sha256;
  file["agents"] = origin_.agents;
  file["seed"] = origin_.seed;
  file["tests"] = origin_.tests;
  file["errored"] = origin_.errored;
  file["learning"] = spec_to_json(origin_.spec);
  file["curve"] = json::array();
  for (const LearningPoint& point : origin_.curve) {
    file["curve"].push_back({point.tests, point.reward, point.success_pct});
  }
  file["covered"] = origin_.covered;
  file["policies"] = json::array();
  for (const Part& part : parts_) {
    ordered_json each{{"name", part.name}, {"options", part.shape.options}};
    if (part.learner != nullptr) {
      each["features"] = part.shape.features;
      each["learned"] = part.learner->state();
    }
    file["policies"].push_back(std::move(each));
  }
  return file.dump() + '\n';
}

Result<std::shared_ptr<Policy>> parse_policy(const SourcePtr& source) {
  Diagnostics diagnostics;
  json file;
  try {
    file = json::parse(source->text());
  } catch (const json::parse_error& error) {
    diagnostics.error(SourceSpan{source, place_of(source, error.byte)}, "this is no JSON",
                      "a policy is written by `jaywalk learn`");
    return diagnostics;
  } catch (const json::out_of_range&) {
    diagnostics.error(source->name(), "the policy has a number that is too large");
    return diagnostics;
  }
  if (!file.is_object() || file.value("jaywalk_policy", json()) != kVersion) {
    diagnostics.error(source->name(), "this is no policy of version 1",
                      "a policy is written by `jaywalk learn`");
    return diagnostics;
  }
  try {
    PolicyOrigin origin = origin_from_json(file);
    check_spec(origin.spec);
    if (find_learner(origin.spec.learner) == nullptr) {
      diagnostics.error(source->name(), fmt::format("unknown learner '{}'", origin.spec.learner));
      return diagnostics;
    }
    auto policy = std::make_shared<Policy>(std::move(origin), std::span<const LearnedPlans>());
    for (const json& each : file.at("policies")) {
      Policy::Part& part = policy->parts_.emplace_back();
      part.name = name_of(each.at("name"), is_label);
      for (const json& option : each.at("options")) {
        part.shape.options.push_back(name_of(option, is_label));
      }
      if (!each.contains("learned")) continue;
      policy->make_learner(part, feature_count(each.at("features")));
      part.learner->restore(each.at("learned"));
    }
    return policy;
  } catch (const std::exception& error) {
    diagnostics.error(source->name(), fmt::format("the policy is damaged: {}", error.what()));
  }
  return diagnostics;
}

}  // namespace jaywalk

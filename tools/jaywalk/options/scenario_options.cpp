// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/scenario_options.h"

#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/shipped.h"
#include "tools/jaywalk/programs/program_check.h"

namespace jaywalk {

namespace {

/// The options of kLimitOptions, and their keys in experiment.limits.
constexpr std::array<std::pair<OptionName, std::string_view>, 4> kLimitKeys = {{
    {option::kMaxCycles, "cycles"},
    {option::kMaxInferences, "inferences"},
    {option::kMaxMemory, "memory_mb"},
    {option::kTimeout, "time_s"},
}};

/// Options that are keys of the scenario: their names, the keys, and what stands around the value.
struct KeyOfOption {
  OptionName option;
  std::string_view key;
  std::string_view begin;
  std::string_view end;
};
constexpr std::array<KeyOfOption, 3> kKeysOfOptions = {{
    {option::kDefects, "experiment.defects", "", ""},
    {option::kAvs, "experiment.avs", "[", "]"},
    {option::kLearner, "learning.learner", "", ""},
}};

}  // namespace

bool is_scenario_file(const std::string& path) {
  return path.ends_with(".yaml") || path.ends_with(".yml");
}

std::vector<std::string> limit_sets(const Arguments& arguments, Diagnostics& diagnostics,
                                    std::string_view within) {
  for (const OptionName whole : {option::kMaxCycles, option::kMaxInferences}) {
    (void)arguments.number(whole, 0, diagnostics, TestLimits::kMost);
  }
  (void)arguments.number(option::kMaxMemory, 0, diagnostics, TestLimits::kMostMegabytes);
  (void)arguments.positive(option::kTimeout, diagnostics);
  std::vector<std::string> sets;
  for (const auto& [option, key] : kLimitKeys) {
    const auto value = arguments.text(option);
    if (value) sets.push_back(fmt::format("{}.{}={}", within, key, *value));
  }
  return sets;
}

void report_repeated_keys(const std::vector<std::string>& sets, Diagnostics& diagnostics) {
  std::set<std::string> keys;
  for (const std::string& set : sets) {
    const std::string key = set.substr(0, set.find('='));
    if (!keys.insert(key).second) {
      diagnostics.error(fmt::format("{} {}", option::kSet.dashed(), set),
                        fmt::format("the key '{}' is given twice", key));
    }
  }
}

ScenarioOptions scenario_options(const Arguments& arguments, std::vector<std::string> behaviours,
                                 const std::vector<std::string>& more_sets) {
  Diagnostics ignored;  // prepare_scenario() reports them
  IncludePath include_path = parse_include_path(arguments, ignored);
  // Programs may be installed ones, as scenarios may.
  for (std::string& behaviour : behaviours) {
    if (behaviour.ends_with(".asl") && !behaviour.starts_with(kLibraryPrefix)) {
      behaviour = located(behaviour);
    }
  }
  std::vector<std::string> sets = arguments.texts(option::kSet);
  std::map<std::string, SourcePtr> given_by;
  // Writes the option's value as the scenario's key needs it, between `begin` and `end`.
  for (const auto& [option, key, begin, end] : kKeysOfOptions) {
    const auto value = arguments.text(option);
    if (!value) continue;
    sets.push_back(fmt::format("{}={}{}{}", key, begin, *value, end));
    given_by[sets.back()] = std::make_shared<const Source>(option.dashed(), *value);
  }
  if (const auto policies = arguments.texts(option::kPolicy); !policies.empty()) {
    sets.push_back(fmt::format("policy={}", nlohmann::json(policies).dump()));
  }
  sets.insert(sets.end(), more_sets.begin(), more_sets.end());
  return {.preset = arguments.text(option::kPreset),
          .sets = std::move(sets),
          .given_by = std::move(given_by),
          .behaviours = std::move(behaviours),
          .files = std::move(include_path.files),
          .include = {std::move(include_path.folders), std::move(include_path.mapped)}};
}

std::shared_ptr<const PreparedScenario> prepare_scenario(
    const std::string& path, const Arguments& arguments, std::vector<std::string> behaviours,
    Console& console, const std::vector<std::string>& more_sets) {
  if (!read_include_path(arguments, console)) return nullptr;
  const ScenarioOptions options = scenario_options(arguments, std::move(behaviours), more_sets);
  Diagnostics repeated;
  // The user's settings must not repeat a key; the command's own, `more_sets`, may override one.
  const auto given = static_cast<std::ptrdiff_t>(options.sets.size() - more_sets.size());
  report_repeated_keys({options.sets.begin(), options.sets.begin() + given}, repeated);
  if (repeated.has_errors()) {
    console.report(repeated);
    return nullptr;
  }
  Result<Scenario> scenario = read_scenario(path, options);
  if (!scenario) {
    console.report(scenario.diagnostics());
    return nullptr;
  }
  Diagnostics warnings;
  auto prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings);
  if (!prepared) {
    console.report(warnings);
    console.report(prepared.diagnostics());
    return nullptr;
  }
  if (!arguments.has(option::kNoCheck)) {
    // They are among the checker's warnings.
    const Scenario& own = prepared.value()->scenario();
    warnings = own.warnings;
    Checked checked;
    check_programs(own, checked, warnings);
  }
  console.report(warnings);
  return std::move(prepared).value();
}

}  // namespace jaywalk

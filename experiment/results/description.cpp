// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/description.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace jaywalk {
namespace {

constexpr std::array<std::string_view, 3> kLevels = {"summary", "found", "all"};

std::string value_text(const std::vector<ParameterValue>& values) {
  std::vector<std::string> texts;
  for (const ParameterValue& value : values) {
    const auto* number = std::get_if<double>(&value);
    texts.push_back(number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(value));
  }
  return fmt::format("{}", fmt::join(texts, ","));
}

StoredBehaviour describe(const PreparedBehaviour& prepared, const BehaviourSpec& spec) {
  StoredBehaviour behaviour{.name = prepared.name, .code_lines = prepared.code_lines};
  for (const ParameterSetting& each : spec.parameters) {
    behaviour.parameters.emplace_back(each.name, value_text(each.values));
  }
  for (const AgentSettings& settings : spec.agents) {
    for (const std::uint32_t agent : settings.agents) {
      for (const ParameterSetting& each : settings.parameters) {
        behaviour.parameters.emplace_back(fmt::format("p{}.{}", agent, each.name),
                                          value_text(each.values));
      }
    }
  }
  return behaviour;
}

std::optional<std::uint32_t> parse_positive(std::string_view text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number == 0) return std::nullopt;
  return number;
}

std::string names_of(const std::vector<StoredBehaviour>& behaviours) {
  std::vector<std::string_view> names;
  for (const StoredBehaviour& behaviour : behaviours) names.push_back(behaviour.name);
  return fmt::format("{}", fmt::join(names, ","));
}

/// The options as the command line would have them.
std::string options_of(const ExperimentDescription& description) {
  std::string text = description.preset ? fmt::format("--preset {} ", *description.preset) : "";
  for (const std::string& set : description.sets) text += fmt::format("--set {} ", set);
  return text.empty() ? "none" : text.substr(0, text.size() - 1);
}

/// The options of judging in the form of a command line.
std::string judging_of(const ExperimentDescription& description) {
  std::string text = description.metrics ? "--metrics " : "";
  for (const std::string& file : description.assertion_files) {
    text += fmt::format("--assertions {} ", file);
  }
  return text.empty() ? "none" : text.substr(0, text.size() - 1);
}

std::string difference_of_inputs(const ExperimentDescription& left,
                                 const ExperimentDescription& right) {
  if (left.inputs.size() != right.inputs.size()) {
    return fmt::format("they were made from {} and {} files", left.inputs.size(),
                       right.inputs.size());
  }
  for (std::size_t i = 0; i < left.inputs.size(); ++i) {
    // By content alone: the same files may lie elsewhere on another machine.
    if (left.inputs[i].sha256 != right.inputs[i].sha256) {
      return fmt::format("the text of '{}' is not the same", left.inputs[i].path);
    }
  }
  return {};
}

}  // namespace

std::string_view name(StoreLevel level) { return kLevels[static_cast<std::size_t>(level)]; }

std::optional<StoreLevel> parse_store_level(std::string_view text) {
  const auto found = std::ranges::find(kLevels, text);
  if (found == kLevels.end()) return std::nullopt;
  return static_cast<StoreLevel>(found - kLevels.begin());
}

std::optional<Shard> parse_shard(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto index = parse_positive(text.substr(0, slash));
  const auto count = parse_positive(text.substr(slash + 1));
  if (!index || !count || *index > *count) return std::nullopt;
  return Shard{.index = *index, .count = *count};
}

ExperimentDescription describe(const PreparedScenario& prepared, const ScenarioOptions& options,
                               const ExperimentPlan& plan, std::uint64_t seed) {
  const Scenario& scenario = prepared.scenario();
  ExperimentDescription description{.scenario = scenario.name,
                                    .preset = options.preset,
                                    .sets = options.sets,
                                    .behaviour_options = options.behaviours,
                                    .include = options.include,
                                    .agents = plan.agents,
                                    .vehicles = plan.vehicles,
                                    .tests = plan.tests,
                                    .seed = seed,
                                    .tick_s = scenario.world->tick_s(),
                                    .anchor = scenario.anchor,
                                    .version = JAYWALK_VERSION};
  for (std::size_t i = 0; i < prepared.behaviours().size(); ++i) {
    description.behaviours.push_back(describe(prepared.behaviours()[i], scenario.behaviours[i]));
  }
  description.inputs = stored_inputs(prepared.inputs());
  return description;
}

void make_portable(ExperimentDescription& description, const SourceFiles& files) {
  std::vector<std::string> names{description.scenario};
  for (const StoredInput& input : description.inputs) names.push_back(input.path);
  for (const std::string& folder : description.include.folders) names.push_back(folder + '/');
  for (const auto& [prefix, folder] : description.include.mapped) names.push_back(folder + '/');
  const PortableNames portable(names, files);
  description.names = portable;
  const auto rename = [&](std::string& text) { text = portable.in(std::move(text)); };
  const auto rename_folder = [&](std::string& folder) {
    folder = portable.in(folder + '/');
    if (folder.ends_with('/')) folder.pop_back();
  };
  rename(description.scenario);
  for (StoredInput& input : description.inputs) rename(input.path);
  std::ranges::for_each(description.sets, rename);
  std::ranges::for_each(description.behaviour_options, rename);
  std::ranges::for_each(description.assertion_files, rename);
  std::ranges::for_each(description.include.folders, rename_folder);
  for (auto& [prefix, folder] : description.include.mapped) rename_folder(folder);
}

void add_judging(ExperimentDescription& description, std::span<const SourcePtr> files,
                 bool metrics) {
  description.metrics = description.metrics || metrics;
  for (const SourcePtr& file : files) {
    StoredInput input = stored_input(*file);
    input.path = portable_path(input.path);
    auto same = std::ranges::find(description.inputs, input.path, &StoredInput::path);
    if (same != description.inputs.end() && same->sha256 != input.sha256) {
      // Two files of one name but different texts: the text's digest distinguishes them.
      input.path += '@' + input.sha256.substr(0, 8);
      same = std::ranges::find(description.inputs, input.path, &StoredInput::path);
    }
    std::erase(description.assertion_files, input.path);  // the latest counts
    description.assertion_files.push_back(input.path);
    if (same == description.inputs.end()) description.inputs.push_back(std::move(input));
  }
}

std::int64_t test_id(const ExperimentDescription& description, const TestKey& test) {
  const auto agents = std::ranges::find(description.agents, test.agents);
  assert(agents != description.agents.end() && "a test of the plan");
  const auto column = static_cast<std::uint64_t>(agents - description.agents.begin());
  // Vehicles outermost, so that the tests of the measures come first; ids count from 1.
  const std::uint64_t row = test.vehicle * description.behaviours.size() + test.behaviour;
  const std::uint64_t cell = row * description.agents.size() + column;
  return static_cast<std::int64_t>(cell * description.tests + test.number - description.first_test +
                                   1);
}

std::int64_t twin_id(const ExperimentDescription& description, TestKey test) {
  test.vehicle = 0;
  return test_id(description, test);
}

std::optional<TestKey> find_test(const ExperimentDescription& description, std::int64_t id) {
  if (id < 1 || description.tests == 0 || description.agents.empty()) return std::nullopt;
  const auto place = static_cast<std::uint64_t>(id - 1);
  const std::uint64_t cell = place / description.tests;
  if (cell >= cells(description)) return std::nullopt;
  const std::uint64_t row = cell / description.agents.size();
  return TestKey{.behaviour = row % description.behaviours.size(),
                 .agents = description.agents[cell % description.agents.size()],
                 .number = place % description.tests + description.first_test,
                 .vehicle = row / description.behaviours.size()};
}

ExperimentPlan plan_of(const ExperimentDescription& description) {
  ExperimentPlan plan{
      .agents = description.agents, .tests = description.tests, .vehicles = description.vehicles};
  for (const StoredBehaviour& behaviour : description.behaviours) {
    plan.behaviours.push_back(behaviour.name);
  }
  return plan;
}

std::uint64_t cells(const ExperimentDescription& description) {
  return description.vehicles.size() * description.behaviours.size() * description.agents.size();
}

std::uint64_t tests_in_shard(const ExperimentDescription& description) {
  const Shard& shard = description.shard;
  // How many numbers below `end` it has.
  const auto below = [&](std::uint64_t end) {
    return (end + shard.count - shard.index) / shard.count;
  };
  return below(description.first_test + description.tests) - below(description.first_test);
}

std::string difference(const ExperimentDescription& left, const ExperimentDescription& right) {
  struct Fact {
    std::string_view name;
    std::string left, right;
  };
  const auto list = [](const std::vector<std::uint32_t>& numbers) {
    return fmt::format("{}", fmt::join(numbers, ","));
  };
  const std::array facts = {
      Fact{"the versions of jaywalk", left.version, right.version},
      Fact{"the simulators", left.simulator, right.simulator},
      Fact{"the seeds", fmt::format("{}", left.seed), fmt::format("{}", right.seed)},
      Fact{"the numbers of tests", fmt::format("{}", left.tests), fmt::format("{}", right.tests)},
      Fact{"the first tests", fmt::format("{}", left.first_test),
           fmt::format("{}", right.first_test)},
      Fact{"the numbers of agents", list(left.agents), list(right.agents)},
      Fact{"the behaviours", names_of(left.behaviours), names_of(right.behaviours)},
      Fact{"the vehicles", fmt::format("{}", fmt::join(left.vehicles, ",")),
           fmt::format("{}", fmt::join(right.vehicles, ","))},
      Fact{"the scenario's options", options_of(left), options_of(right)},
      Fact{"the assertions and metrics", judging_of(left), judging_of(right)},
  };
  for (const Fact& fact : facts) {
    if (fact.left != fact.right) {
      return fmt::format("{} are {} and {}", fact.name, fact.left, fact.right);
    }
  }
  return difference_of_inputs(left, right);
}

}  // namespace jaywalk

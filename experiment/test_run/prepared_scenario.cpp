// SPDX-License-Identifier: Apache-2.0
#include "experiment/test_run/prepared_scenario.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/scenario/files/program_text.h"
#include "experiment/scenario/scenario_yaml.h"
#include "experiment/test_run/tested_vehicles.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/support/input/missing_file.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {
namespace {

// `radius/1` and `odds/2` as written by parameter_names().
struct Indicator {
  std::string name;
  std::size_t arity = 0;
};

Indicator parse_indicator(const std::string& text) {
  const std::size_t slash = text.rfind('/');
  return {text.substr(0, slash), static_cast<std::size_t>(std::stoul(text.substr(slash + 1)))};
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// Suggests the installed behaviour whose file is called so, in whichever folder, or nearly so.
std::string similar_behaviour(const std::string& path, std::span<const std::string> installed) {
  std::vector<std::string> names;
  std::ranges::transform(installed, std::back_inserter(names), file_name);
  std::string name = file_name(path);
  if (std::ranges::find(names, name) == names.end()) name = closest(name, names).value_or("");
  const auto found = std::ranges::find(installed, name, file_name);
  return found == installed.end() ? "" : fmt::format("did you mean '{}'?", *found);
}

/// Loads and compiles behaviours into one symbol table.
class Preparation {
 public:
  Preparation(const Scenario& scenario, SymbolTable& symbols, std::vector<SourcePtr>& inputs,
              Diagnostics& diagnostics)
      : world_(scenario.world->kind()),
        symbols_(symbols),
        inputs_(inputs),
        diagnostics_(diagnostics),
        include_path_(include_path(scenario)) {}

  PreparedBehaviour prepare(const BehaviourSpec& spec) {
    PreparedBehaviour result;
    result.name = spec.name;
    result.program_path = spec.program;
    result.program = load(spec.program, spec.origin, result);
    for (const TeamMember& member : spec.team) {
      const std::shared_ptr<const Program> program = load(member.program, member.origin, result);
      for (const std::uint32_t agent : member.agents) result.team[agent] = program;
    }
    if (!result.program || diagnostics_.has_errors()) return result;
    result.parameters = convert(spec.parameters);
    for (const AgentSettings& settings : spec.agents) {
      const std::vector<Parameter> parameters = convert(settings.parameters);
      for (const std::uint32_t agent : settings.agents) {
        std::vector<Parameter>& own = result.agent_parameters[agent];
        own.insert(own.end(), parameters.begin(), parameters.end());
      }
    }
    return result;
  }

 private:
  void add_input(const SourcePtr& source) {
    const auto same = [&](const SourcePtr& input) { return input->name() == source->name(); };
    if (std::none_of(inputs_.begin(), inputs_.end(), same)) inputs_.push_back(source);
  }

  // A program that several members of a team run counts once, and is compiled once.
  std::shared_ptr<const Program> load(const std::string& path, const ValueOrigin& origin,
                                      PreparedBehaviour& result) {
    if (const auto known = loaded_.find(path); known != loaded_.end()) return known->second;
    // A missing file is an error of the scenario; errors in a file are the program's.
    if (!include_path_.files.has(path)) {
      std::string hint = similar_behaviour(path, installed_behaviours(world_, include_path_.files));
      if (hint.empty() && include_path_.files.are_on_disk()) hint = hint_for_missing(path);
      report(diagnostics_, origin, fmt::format("no AgentSpeak program is at '{}'", path),
             std::move(hint));
      return nullptr;
    }
    const SourceTree tree = load_agent(path, include_path_, diagnostics_);
    diagnostics_ = with_errors(diagnostics_, kMissingInclude, kMissingIncludeHint);
    for (const auto& file : tree.files) {
      add_input(file->source);
      result.sources.push_back(file->source);
    }
    if (diagnostics_.has_errors()) return nullptr;
    std::shared_ptr<const Program> program = compile(tree, symbols_, diagnostics_);
    if (!program) return nullptr;
    result.code_lines += code_lines(tree);
    for (const std::string& name : parameter_names(*program, symbols_)) {
      settable_.push_back(parse_indicator(name));
    }
    return loaded_[path] = program;
  }

  std::vector<Parameter> convert(const std::vector<ParameterSetting>& settings) {
    std::vector<Parameter> result;
    for (const ParameterSetting& setting : settings) {
      if (!check(setting)) continue;
      Parameter parameter;
      parameter.predicate =
          symbols_.predicate(setting.name, static_cast<std::uint16_t>(setting.values.size()));
      for (const ParameterValue& value : setting.values) parameter.args.push_back(term(value));
      result.push_back(std::move(parameter));
    }
    return result;
  }

  Value term(const ParameterValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return Value::number(*number);
    return Value::atom(symbols_.predicate(std::get<std::string>(value), 0));
  }

  bool check(const ParameterSetting& setting) {
    std::vector<std::string> names;
    std::vector<std::string> arities;
    for (const Indicator& each : settable_) {
      names.push_back(each.name);
      if (each.name != setting.name) continue;
      if (each.arity == setting.values.size()) return true;
      arities.push_back(fmt::format("{}", each.arity));
    }
    if (!arities.empty()) {
      report(diagnostics_, setting.origin,
             fmt::format("'{}' takes {} values, {} given", setting.name, fmt::join(arities, " or "),
                         setting.values.size()));
      return false;
    }
    std::string hint = did_you_mean(setting.name, names);
    if (hint.empty()) {
      hint = names.empty() ? "the program has no initial beliefs"
                           : fmt::format("its initial beliefs are {}", fmt::join(names, ", "));
    }
    report(diagnostics_, setting.origin,
           fmt::format("the program has no initial belief '{}' to set", setting.name),
           std::move(hint));
    return false;
  }

  std::string_view world_;
  SymbolTable& symbols_;
  std::vector<SourcePtr>& inputs_;
  Diagnostics& diagnostics_;
  IncludePath include_path_;
  std::vector<Indicator> settable_;
  std::map<std::string, std::shared_ptr<const Program>> loaded_;
};

/// Assigns policies to the behaviours that have their options. A policy without such a behaviour is
/// an error. A behaviour with options but without a policy chooses at random; a note says so.
void give_policies(const Scenario& scenario, const SymbolTable& symbols,
                   std::vector<PreparedBehaviour>& behaviours, Diagnostics& errors,
                   Diagnostics& warnings) {
  std::vector<std::vector<LearnedPlans>> plans;
  for (const PreparedBehaviour& each : behaviours) {
    plans.push_back(learned_plans(*each.program, symbols));
  }
  for (const SourcePtr& source : scenario.policies) {
    auto policy = parse_policy(source);
    if (!policy.ok()) {
      errors.append(std::move(policy.diagnostics()));
      continue;
    }
    std::string why;
    bool is_used = false;
    for (std::size_t i = 0; i < behaviours.size(); ++i) {
      if (plans[i].empty()) continue;
      const std::string problem = mismatch(*policy.value(), plans[i]);
      if (why.empty()) why = fmt::format("{}: {}", behaviours[i].name, problem);
      if (!problem.empty()) continue;
      is_used = true;
      if (behaviours[i].policy == nullptr) behaviours[i].policy = policy.value();
    }
    if (is_used) continue;
    errors.error(source->name(), "the policy is for none of the behaviours",
                 why.empty() ? "none of them has plans that are labelled learned(P)" : why);
  }
  if (errors.has_errors() || scenario.policies.empty()) return;
  for (std::size_t i = 0; i < behaviours.size(); ++i) {
    if (plans[i].empty() || behaviours[i].policy != nullptr) continue;
    warnings.warning(SourceSpan{}, "",
                     fmt::format("{} has no policy and chooses by chance", behaviours[i].name));
  }
}

}  // namespace

IncludePath include_path(const Scenario& scenario) {
  IncludePath path;
  path.folders = scenario.include.folders;
  path.mapped = scenario.include.mapped;
  path.files = scenario.files;
  // The scenario is the project of its programs, wherever it has them from.
  path.files.allow_reading(std::filesystem::path(scenario.name).parent_path().string());
  return path;
}

PreparedScenario::PreparedScenario(Scenario scenario, std::shared_ptr<const SymbolTable> symbols,
                                   std::vector<PreparedBehaviour> behaviours,
                                   std::vector<PreparedBehaviour> actors,
                                   std::vector<SourcePtr> inputs,
                                   std::vector<PreparedVehicle> vehicles)
    : scenario_(std::move(scenario)),
      symbols_(std::move(symbols)),
      behaviours_(std::move(behaviours)),
      actors_(std::move(actors)),
      inputs_(std::move(inputs)) {
  for (PreparedVehicle& vehicle : vehicles) {
    vehicles_.push_back(std::move(vehicle.name));
    worlds_.push_back(std::move(vehicle.world));
  }
}

Result<std::shared_ptr<const PreparedScenario>> PreparedScenario::prepare(Scenario scenario,
                                                                          Diagnostics& warnings) {
  const auto symbols = std::make_shared<SymbolTable>();
  std::vector<PreparedVehicle> vehicles;
  for (TestedVehicle& vehicle : tested_vehicles(scenario)) {
    const auto world =
        scenario.world->with(std::move(vehicle.parameters), std::move(vehicle.simulator));
    vehicles.push_back({std::move(vehicle.name), world->prepare(*symbols)});
  }
  Diagnostics errors;
  std::vector<SourcePtr> inputs = scenario.sources;
  const auto prepare_all = [&](const std::vector<BehaviourSpec>& specs) {
    std::vector<PreparedBehaviour> prepared;
    for (const BehaviourSpec& spec : specs) {
      Diagnostics found;
      prepared.push_back(Preparation(scenario, *symbols, inputs, found).prepare(spec));
      (found.has_errors() ? errors : warnings).append(std::move(found));
    }
    return prepared;
  };
  std::vector<PreparedBehaviour> behaviours = prepare_all(scenario.behaviours);
  std::vector<PreparedBehaviour> actors = prepare_all(scenario.actors);
  if (!errors.has_errors()) give_policies(scenario, *symbols, behaviours, errors, warnings);
  if (errors.has_errors()) return errors;
  return std::shared_ptr<const PreparedScenario>(
      new PreparedScenario(std::move(scenario), symbols, std::move(behaviours), std::move(actors),
                           std::move(inputs), std::move(vehicles)));
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "env/environments.h"
#include "experiment/compare/published/published.h"
#include "experiment/compare/published/published_programs.h"
#include "experiment/scenario/files/program_text.h"
#include "experiment/test_run/prepared_scenario.h"
#include "interpreter/term/heap.h"

namespace jaywalk {
namespace {

/// A preset whose results were published, with the parameters that it gives to behaviours.
struct PublishedSetting {
  const Preset* preset;
  Scenario scenario;
};

std::vector<std::string> published_presets() {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) {
    if (preset.results == PresetResults::published) names.emplace_back(preset.name);
  }
  return names;
}

/// The setting of that preset for behaviours of these names, or of any one.
PublishedSetting setting_of(const Preset& preset, const std::vector<std::string>& behaviours) {
  const auto text =
      fmt::format("behaviours: [{}.asl]\n",
                  behaviours.empty() ? "any" : fmt::format("{}", fmt::join(behaviours, ".asl, ")));
  ScenarioOptions options;
  options.preset = preset.name;
  auto scenario = parse_scenario(std::make_shared<const Source>("published", text), options);
  return {&preset, scenario.ok() ? std::move(scenario).value() : Scenario{}};
}

std::optional<PublishedSetting> setting_with(const WorldSpec& world,
                                             const std::vector<std::string>& behaviours) {
  for (const Preset& preset : presets()) {
    if (preset.results == PresetResults::other) continue;
    PublishedSetting setting = setting_of(preset, behaviours);
    if (setting.scenario.world->same_as(world)) return setting;
  }
  return std::nullopt;
}

/// `proximity.asl 4f…`: the program is one of agents/crossing.
bool is_shipped(const std::string& path, const SourcePtr& source) {
  const std::string line = fmt::format("{} {}\n", path, sha256(source->text()));
  return ("\n" + std::string(kPublishedPrograms)).find("\n" + line) != std::string::npos;
}

/// Whether the program of that name and its includes are those of agents/crossing.
bool has_published_program(const PreparedBehaviour& behaviour) {
  if (!behaviour.team.empty() || behaviour.sources.empty()) return false;
  if (!is_shipped(behaviour.name + ".asl", behaviour.sources.front())) return false;
  return std::all_of(behaviour.sources.begin() + 1, behaviour.sources.end(), [](const auto& each) {
    const std::string& name = each->name();
    return is_shipped("shared/" + name.substr(name.rfind('/') + 1), each);
  });
}

bool is_value(const ParameterValue& wanted, Value value, const SymbolTable& symbols) {
  if (const auto* const number = std::get_if<double>(&wanted)) {
    return value.is_number() && value.as_number() == *number;
  }
  return value.is_atom() &&
         symbols.text(symbols.signature(value.atom_id()).functor) == std::get<std::string>(wanted);
}

/// The values that the program itself gives to a belief.
std::span<const Value> initial_values(const Program& program, Predicate predicate) {
  for (const Program::Belief& belief : program.beliefs()) {
    if (belief.rule == nullptr && belief.predicate == predicate && belief.fact.is_structure()) {
      return belief.fact.structure()->arg_span();
    }
  }
  return {};
}

/// Each parameter has the preset's value, or the program's own if the preset is silent.
bool has_published_parameters(const PreparedBehaviour& behaviour, const BehaviourSpec& published,
                              const SymbolTable& symbols) {
  if (!behaviour.agent_parameters.empty()) return false;
  const auto is_as_published = [&](const Parameter& parameter) {
    const std::string_view name = symbols.text(symbols.signature(parameter.predicate).functor);
    const auto wanted = std::ranges::find(published.parameters, name, &ParameterSetting::name);
    if (wanted != published.parameters.end()) {
      return std::ranges::equal(wanted->values, parameter.args, [&](const auto& left, Value right) {
        return is_value(left, right, symbols);
      });
    }
    return std::ranges::equal(initial_values(*behaviour.program, parameter.predicate),
                              parameter.args,
                              [](Value left, Value right) { return left.same_as(right); });
  };
  const auto is_given = [&](const ParameterSetting& setting) {
    return std::ranges::any_of(behaviour.parameters, [&](const Parameter& parameter) {
      return symbols.text(symbols.signature(parameter.predicate).functor) == setting.name;
    });
  };
  return std::ranges::all_of(behaviour.parameters, is_as_published) &&
         std::ranges::all_of(published.parameters, is_given);
}

std::string why_not(const PreparedBehaviour& behaviour, const BehaviourSpec& published,
                    const SymbolTable& symbols) {
  if (!has_published_program(behaviour)) return behaviour.name + " runs another program";
  if (has_published_parameters(behaviour, published, symbols)) return {};
  return behaviour.name + " has other parameters";
}

/// Why the whole scenario is another experiment than the published one, even if its world is the
/// published one; empty if it is not.
std::string why_none(const Scenario& scenario) {
  if (scenario.experiment.feedback > 0) return "pedestrians know what earlier tests covered";
  if (scenario.world->has_given_starts()) return "start cells are given";
  return {};
}

}  // namespace

PublishedRows published_rows(const PreparedScenario& prepared) {
  PublishedRows rows;
  std::vector<std::string> names;
  for (const PreparedBehaviour& behaviour : prepared.behaviours()) {
    if (has_published_figures(behaviour.name)) names.push_back(behaviour.name);
  }
  const auto setting = setting_with(*prepared.scenario().world, names);
  rows.world = setting.has_value();
  if (names.empty()) return rows;
  rows.left_out = setting ? why_none(prepared.scenario())
                          : fmt::format("the world is not a published one (presets {})",
                                        fmt::join(published_presets(), ", "));
  if (!rows.left_out.empty()) return rows;
  if (prepared.scenario().world->carries_over()) rows.quirks = PublishedQuirks::repeated;
  std::vector<std::string> others;
  for (const PreparedBehaviour& behaviour : prepared.behaviours()) {
    const auto published =
        std::ranges::find(setting->scenario.behaviours, behaviour.name, &BehaviourSpec::name);
    if (published == setting->scenario.behaviours.end()) continue;
    std::string why = why_not(behaviour, *published, *prepared.symbols());
    if (why.empty()) {
      rows.behaviours.push_back(behaviour.name);
    } else {
      others.push_back(std::move(why));
    }
  }
  rows.left_out = fmt::format("{}", fmt::join(others, ", "));
  return rows;
}

}  // namespace jaywalk

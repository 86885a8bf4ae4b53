// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/scenario.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "env/environments.h"
#include "experiment/judge/situations/situations.h"
#include "experiment/scenario/files/program_copies.h"
#include "experiment/scenario/scenario_schema.h"
#include "experiment/scenario/scenario_yaml.h"
#include "interpreter/support/input/missing_file.h"
#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

ConfigNode map_of(std::string key, ConfigNode value) {
  ConfigNode map;
  map.kind = ConfigNode::Kind::map;
  map.entries.push_back({std::move(key), {}, std::move(value)});
  return map;
}

/// Merges the layers of a scenario and checks the result.
class ScenarioBuilder {
 public:
  ScenarioBuilder(SourcePtr source, const ScenarioOptions& options)
      : source_(std::move(source)), options_(options) {}

  Result<Scenario> build() {
    if (!parse_layers() || !choose_world()) return std::move(diagnostics_);
    // The order of the layers: preset, file, settings; values of each replace those of the earlier
    // ones.
    read_preset();
    const std::string folder = std::filesystem::path(source_->name()).parent_path().string();
    read_layer(file_, folder, draft_, diagnostics_);
    select_behaviours();
    // Between file and settings, since only now is it known which behaviours there are.
    set_behaviours_of_preset();
    for (const ConfigNode& setting : settings_) read_layer(setting, "", draft_, diagnostics_);
    if (diagnostics_.has_errors()) return std::move(diagnostics_);
    finish();
    if (diagnostics_.has_errors()) return std::move(diagnostics_);
    draft_.scenario.warnings = std::move(diagnostics_);
    return std::move(draft_.scenario);
  }

 private:
  bool parse_layers() {
    draft_.scenario.name = source_->name();
    draft_.scenario.sources.push_back(source_);
    draft_.scenario.files = options_.files;
    draft_.scenario.include = options_.include;
    std::optional<ConfigNode> file = parse_config(source_, diagnostics_);
    if (file && file->kind == ConfigNode::Kind::null) {
      diagnostics_.error(source_->name(), "the scenario is empty",
                         "docs/reference/scenarios.md describes what to write");
    } else if (file) {
      file_ = std::move(*file);
    }
    for (const std::string& text : options_.sets) {
      const auto given = options_.given_by.find(text);
      const SourcePtr source = given == options_.given_by.end() ? nullptr : given->second;
      if (std::optional<ConfigNode> setting = parse_setting(text, diagnostics_, source)) {
        settings_.push_back(std::move(*setting));
      }
    }
    return !diagnostics_.has_errors();
  }

  // The world's name is in any layer; it decides what the others mean.
  bool choose_world() {
    const auto named_in = [](const ConfigNode& layer) {
      const ConfigNode* const world = layer.find("world");
      return world == nullptr ? nullptr : world->find("environment");
    };
    const ConfigNode* named = named_in(file_);
    for (const ConfigNode& setting : settings_) {
      if (const ConfigNode* const value = named_in(setting)) named = value;
    }
    world_ = &environments().front();
    if (named != nullptr) {
      const ConfigReader reader(diagnostics_);
      const auto name = reader.text(*named, "the name of an environment");
      if (!name) return false;
      world_ = find_environment(*name);
      if (world_ == nullptr) {
        std::vector<std::string> names;
        for (const EnvironmentKind& kind : environments()) names.emplace_back(kind.name);
        report(diagnostics_, named->origin, fmt::format("unknown environment '{}'", *name),
               did_you_mean(*name, names));
        return false;
      }
    }
    draft_.world_kind = world_->name;
    draft_.world = world_->section();
    return true;
  }

  // The preset's name is in any layer; the option --preset counts before the file's. Without one
  // it is the world's first, if it has any.
  void read_preset() {
    ConfigNode named;
    if (!world_->presets.empty()) named.text = world_->presets.front().name;
    if (const ConfigNode* value = file_.find("preset")) named = *value;
    if (options_.preset) {
      named = {ConfigNode::Kind::scalar, *options_.preset, {{}, "--preset"}, {}, {}};
    }
    for (const ConfigNode& setting : settings_) {
      if (const ConfigNode* value = setting.find("preset")) named = *value;
    }
    if (named.kind == ConfigNode::Kind::null && named.text.empty()) return;
    const auto preset = std::ranges::find(world_->presets, named.text, &Preset::name);
    if (preset == world_->presets.end()) {
      std::vector<std::string> names;
      for (const Preset& each : world_->presets) names.emplace_back(each.name);
      std::string hint = did_you_mean(named.text, names);
      if (hint.empty()) {
        hint = names.empty() ? fmt::format("the world {} has none", world_->name)
                             : "`jaywalk list presets` shows them";
      }
      report(diagnostics_, named.origin, fmt::format("unknown preset '{}'", named.text),
             std::move(hint));
      return;
    }
    draft_.scenario.preset = preset->name;
    const auto source = std::make_shared<const Source>(fmt::format("preset {}", preset->name),
                                                       std::string(preset->text));
    std::optional<ConfigNode> layer = parse_config(source, diagnostics_);
    if (!layer || layer->kind != ConfigNode::Kind::map) return;
    const auto behaviours = std::ranges::find(layer->entries, "behaviours", &ConfigEntry::key);
    if (behaviours != layer->entries.end()) {
      // Kept for later: a preset sets parameters of behaviours, but adds none.
      preset_behaviours_ = std::move(behaviours->value);
      layer->entries.erase(behaviours);
    }
    read_layer(*layer, "", draft_, diagnostics_);
  }

  // The file decides which behaviours there are, and its parameters replace the preset's.
  void set_behaviours_of_preset() {
    for (BehaviourSpec& behaviour : draft_.scenario.behaviours) {
      const ConfigNode* const value = preset_behaviours_.find(behaviour.name);
      if (value == nullptr) continue;
      ScenarioDraft preset;
      preset.world_kind = world_->name;
      preset.scenario.behaviours.emplace_back().name = behaviour.name;
      read_layer(map_of("behaviours", map_of(behaviour.name, *value)), "", preset, diagnostics_);
      for (ParameterSetting& setting : preset.scenario.behaviours.front().parameters) {
        const bool given = std::ranges::any_of(
            behaviour.parameters, [&](const auto& own) { return own.name == setting.name; });
        if (!given) behaviour.parameters.push_back(std::move(setting));
      }
    }
  }

  void select_behaviours() {
    if (options_.behaviours.empty()) return;
    std::vector<BehaviourSpec> selected;
    for (const std::string& wanted : options_.behaviours) {
      if (std::optional<BehaviourSpec> behaviour = find_behaviour(wanted)) {
        selected.push_back(std::move(*behaviour));
      }
    }
    draft_.scenario.behaviours = std::move(selected);
  }

  std::optional<BehaviourSpec> find_behaviour(const std::string& wanted) {
    // By name, then by file: a name of the scenario hides an installed one.
    const std::string path = program_path("", wanted, world_->name, options_.files);
    std::vector<std::string> names;
    for (const BehaviourSpec& behaviour : draft_.scenario.behaviours) {
      if (behaviour.name == wanted || behaviour.program == path) return behaviour;
      names.push_back(behaviour.name);
    }
    const std::string option = fmt::format("behaviour {}", wanted);
    if (wanted.ends_with(".asl") || options_.files.has(path)) {
      BehaviourSpec behaviour;
      behaviour.name = behaviour_name(wanted);
      behaviour.program = path;
      behaviour.origin.option = option;
      return behaviour;
    }
    for (const std::string& installed : installed_behaviours(world_->name, options_.files)) {
      names.push_back(behaviour_name(installed));
    }
    std::string hint = did_you_mean(wanted, names);
    if (hint.empty() && options_.files.are_on_disk()) hint = hint_for_missing(wanted);
    if (hint.empty()) hint = "`jaywalk list behaviours` names the installed ones";
    diagnostics_.error(option,
                       "neither a behaviour of the scenario, an installed one nor an .asl file",
                       std::move(hint));
    return std::nullopt;
  }

  [[nodiscard]] ValueOrigin origin_of(std::string path) const {
    return jaywalk::origin_of(draft_.scenario.origins, std::move(path), source_->name());
  }

  void finish() {
    Scenario& scenario = draft_.scenario;
    const std::string folder;
    const SectionContext context{folder, options_.files, draft_.scenario.origins, diagnostics_};
    draft_.world->check(scenario.name, context);
    check_avs();
    check_behaviours();
    // Files are only read for a scenario that is right so far.
    if (!diagnostics_.has_errors()) draft_.world->read_files(context, scenario.sources);
    if (!diagnostics_.has_errors()) read_programs();
    finish_learning();
    read_reachable();
    if (draft_.assertions_file) {
      read_assertions();
    } else if (!draft_.judged.empty()) {
      report(diagnostics_, draft_.judged.front().second, "assertions to judge, but no file of them",
             "name it under 'assertions.file'");
    }
    if (!diagnostics_.has_errors()) finish_world();
  }

  void finish_world() {
    Scenario& scenario = draft_.scenario;
    scenario.world = draft_.world->finish();
    for (WorldAgent& agent : draft_.world->agents()) {
      BehaviourSpec& program = scenario.actors.emplace_back();
      program.name = std::move(agent.name);
      program.program = std::move(agent.program);
      program.parameters = std::move(agent.parameters);
      program.origin = std::move(agent.origin);
    }
  }

  void read_programs() {
    Scenario& scenario = draft_.scenario;
    const std::vector<std::vector<std::string>*> commands = draft_.world->commands();
    auto programs = keep_programs(commands, options_.files, scenario.sources);
    if (programs.ok()) {
      scenario.programs = std::move(programs).value();
    } else {
      diagnostics_.append(std::move(programs.diagnostics()));
    }
  }

  // The settings are those of the learner that is named; assertions that are rewarded are judged.
  void finish_learning() {
    LearningSpec& learning = draft_.scenario.learning;
    learning.settings = draft_.learner_settings[learning.learner];
    if (!draft_.rewarded.empty() && !draft_.assertions_file) {
      report(diagnostics_, draft_.rewarded.front().second,
             "assertions are rewarded, but none are judged", "name their file under 'assertions'");
    }
    for (const auto& [path, origin] : draft_.policy_files) {
      Result<SourcePtr> source = options_.files.read(path, kMostPolicyBytes);
      if (!source.ok()) {
        report(diagnostics_, origin, fmt::format("no policy is at '{}'", path),
               "jaywalk learn writes them");
        continue;
      }
      draft_.scenario.sources.push_back(source.value());
      draft_.scenario.policies.push_back(std::move(source).value());
    }
  }

  void read_reachable() {
    if (!draft_.reachable_file) return;
    const auto& [path, origin] = *draft_.reachable_file;
    Result<SourcePtr> source = options_.files.read(path, kMaxScenarioBytes);
    if (!source.ok()) {
      report(diagnostics_, origin, fmt::format("no file of situations is at '{}'", path),
             "jaywalk reach SCENARIO --csv writes one");
      return;
    }
    draft_.scenario.sources.push_back(source.value());
    Result<ReachFile> file = parse_reach_file(source.value());
    if (!file.ok()) {
      diagnostics_.append(std::move(file.diagnostics()));
    } else if (file.value().reachable.empty()) {
      report(diagnostics_, origin,
             fmt::format("'{}' says of no situation whether it can be met", path),
             "jaywalk reach SCENARIO --csv writes one that does");
    } else {
      draft_.scenario.experiment.reachable = std::move(file.value().reachable);
    }
  }

  // An assertion whose violation or robustness is rewarded has to be judged.
  void check_rewarded() {
    std::vector<std::string> ids;
    for (const Assertion& assertion : draft_.scenario.assertions) ids.push_back(assertion.id);
    for (const auto& [id, origin] : draft_.rewarded) {
      if (std::ranges::find(ids, id) != ids.end()) continue;
      report(diagnostics_, origin, fmt::format("no assertion '{}' is judged by this scenario", id),
             did_you_mean(id, ids));
    }
  }

  void read_assertions() {
    Result<SourcePtr> source = options_.files.read(*draft_.assertions_file, kMaxScenarioBytes);
    if (!source.ok()) {
      report(diagnostics_, origin_of("assertions"),
             fmt::format("no assertions are at '{}'", *draft_.assertions_file),
             hint_for_missing(*draft_.assertions_file));
      return;
    }
    draft_.scenario.sources.push_back(source.value());
    Result<std::vector<Assertion>> all = parse_assertions(source.value());
    if (!all.ok()) {
      diagnostics_.append(std::move(all.diagnostics()));
      return;
    }
    if (draft_.judged.empty()) {
      draft_.scenario.assertions = std::move(all.value());
    } else {
      select_assertions(all.value());
    }
    check_told_assertions();
    check_rewarded();
  }

  void select_assertions(const std::vector<Assertion>& all) {
    std::vector<std::string> ids;
    for (const Assertion& assertion : all) ids.push_back(assertion.id);
    for (const auto& [id, origin] : draft_.judged) {
      const auto found = std::find(ids.begin(), ids.end(), id);
      if (found != ids.end()) {
        draft_.scenario.assertions.push_back(all[static_cast<std::size_t>(found - ids.begin())]);
        continue;
      }
      report(diagnostics_, origin,
             fmt::format("no assertion '{}' in '{}'", id, *draft_.assertions_file),
             did_you_mean(id, ids));
    }
  }

  // The assertion that agents receive, as a belief assertion(Id), is one that is judged.
  void check_told_assertions() {
    for (const BehaviourSpec& behaviour : draft_.scenario.behaviours) {
      for (const ParameterSetting& setting : behaviour.parameters) check_told(setting);
      for (const AgentSettings& agents : behaviour.agents) {
        for (const ParameterSetting& setting : agents.parameters) check_told(setting);
      }
    }
  }

  void check_told(const ParameterSetting& setting) {
    if (setting.name != "assertion") return;
    std::vector<std::string> ids;
    for (const Assertion& assertion : draft_.scenario.assertions) ids.push_back(assertion.id);
    for (const ParameterValue& value : setting.values) {
      const auto* const id = std::get_if<std::string>(&value);
      if (id == nullptr || std::find(ids.begin(), ids.end(), *id) != ids.end()) continue;
      report(diagnostics_, setting.origin,
             fmt::format("no assertion '{}' is judged by this scenario", *id),
             did_you_mean(*id, ids));
    }
  }

  void check_avs() {
    const std::vector<std::string> names = draft_.world->av_models();
    for (const std::string& name : draft_.scenario.experiment.avs) {
      if (std::ranges::find(names, name) != names.end()) continue;
      std::string hint = did_you_mean(name, names);
      if (hint.empty()) {
        hint = names.empty() ? "the world's simulator has none to choose from"
                             : fmt::format("they are {}", fmt::join(names, ", "));
      }
      report(diagnostics_, origin_of("experiment.avs"),
             fmt::format("unknown model '{}' of the AV", name), std::move(hint));
    }
  }

  void check_behaviours() {
    if (draft_.scenario.behaviours.empty()) {
      diagnostics_.error(source_->name(), "no behaviour to run",
                         "list AgentSpeak programs under 'behaviours'");
    }
    std::set<std::string_view> names;
    for (const BehaviourSpec& behaviour : draft_.scenario.behaviours) {
      if (!is_identifier(behaviour.name)) {
        report(diagnostics_, behaviour.origin,
               fmt::format("'{}' cannot be the name of a behaviour", behaviour.name),
               fmt::format("{}; give another one as 'name'", kIdentifierHint));
      } else if (!names.insert(behaviour.name).second) {
        report(diagnostics_, behaviour.origin,
               fmt::format("a second behaviour with the name '{}'", behaviour.name),
               "give one of them a 'name' of its own");
      }
    }
  }

  SourcePtr source_;
  const ScenarioOptions& options_;
  Diagnostics diagnostics_;
  const EnvironmentKind* world_ = nullptr;
  ConfigNode file_;
  std::vector<ConfigNode> settings_;
  ScenarioDraft draft_;
  ConfigNode preset_behaviours_;
};

}  // namespace

Result<Scenario> read_scenario(const std::string& path, const ScenarioOptions& options) {
  Result<SourcePtr> source = options.files.read(path, kMaxScenarioBytes);
  if (!source.ok()) return std::move(source.diagnostics());
  return parse_scenario(source.value(), options);
}

Result<Scenario> parse_scenario(const SourcePtr& source, const ScenarioOptions& options) {
  return ScenarioBuilder(source, options).build();
}

}  // namespace jaywalk

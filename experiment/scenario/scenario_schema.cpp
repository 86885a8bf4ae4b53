// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/scenario_schema.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "experiment/scenario/number_list.h"

namespace jaywalk {
namespace {

// Ranges of the keys: generous, but small enough that products of them do not overflow.
constexpr IntegerRange kTests{1, 1'000'000'000};
constexpr IntegerRange kGenerations{0, 1'000'000'000};
constexpr IntegerRange kLimits{0, TestLimits::kMost};
constexpr IntegerRange kMegabytes{0, TestLimits::kMostMegabytes};
constexpr IntegerRange kSeeds{0, INT64_MAX};
constexpr IntegerRange kEpsg{1024, 32767};
constexpr NumberRange kOnEarth{-1e8, 1e8};
constexpr NumberRange kBearing{-360, 360};

class LayerReader : LayerPart {
 public:
  LayerReader(const std::string& folder, ScenarioDraft& draft, Diagnostics& diagnostics)
      : LayerPart(folder, draft, diagnostics), diagnostics_(diagnostics) {}

  void read(const ConfigNode& root) {
    read_keys(root, "",
              {
                  {"preset", [](const ConfigNode&, const std::string&) {}},  // read before
                  {"world", method(&LayerReader::read_world)},
                  {"behaviours", method(&LayerReader::read_behaviours)},
                  {"assertions", method(&LayerReader::read_assertions)},
                  {"experiment", method(&LayerReader::read_experiment)},
                  {"learning",
                   [this](const ConfigNode& node, const std::string& path) {
                     read_learning(node, path, folder_, draft_, diagnostics_);
                   }},
                  {"policy",
                   [this](const ConfigNode& node, const std::string& path) {
                     read_policies(node, path, folder_, draft_, diagnostics_);
                   }},
              });
  }

 private:
  using Handler = void (LayerReader::*)(const ConfigNode&, const std::string&);

  std::function<void(const ConfigNode&, const std::string&)> method(Handler handler) {
    return [this, handler](const ConfigNode& node, const std::string& path) {
      (this->*handler)(node, path);
    };
  }

  // The keys that all worlds have; the world reads the others (env/world/world_section.h).
  void read_world(const ConfigNode& node, const std::string& path) {
    const std::array common{
        // Read before, since the other keys depend on it.
        ConfigKey{"environment", [](const ConfigNode&, const std::string&) {}},
        ConfigKey{"anchor", [this](const ConfigNode& value,
                                   const std::string& key) { read_anchor(value, key); }},
    };
    draft_.world->read(node, path, context_, common);
  }

  void read_anchor(const ConfigNode& node, const std::string& path) {
    Anchor anchor = draft_.scenario.anchor.value_or(Anchor{});
    read_keys(node, path,
              {
                  {"epsg", integer(anchor.epsg, kEpsg)},
                  {"easting", number(anchor.easting_m, kOnEarth)},
                  {"northing", number(anchor.northing_m, kOnEarth)},
                  {"bearing", number(anchor.bearing_deg, kBearing)},
              });
    draft_.scenario.anchor = anchor;
    constexpr int kDegrees = 4326;
    if (anchor.epsg == 0) {
      reader_.error(node.origin, "an anchor without 'epsg', the code of its reference system");
    } else if (anchor.epsg == kDegrees) {
      reader_.error(node.origin, "expected a reference system in metres, found one in degrees",
                    "a UTM zone is epsg: 32601 to 32660, Great Britain's grid 27700");
    }
  }

  // A list says which behaviours there are; a map changes those that have been listed.
  void read_behaviours(const ConfigNode& node, const std::string& path) {
    std::vector<BehaviourSpec>& behaviours = draft_.scenario.behaviours;
    draft_.scenario.origins[path] = node.origin;
    if (node.kind == ConfigNode::Kind::list) {
      behaviours.clear();
      for (const ConfigNode& item : node.items) read_behaviour_item(item, path);
    } else if (node.kind == ConfigNode::Kind::map) {
      for (const ConfigEntry& entry : node.entries) change_behaviour(entry, path);
    } else {
      reader_.unexpected(node, "a list of AgentSpeak programs");
    }
  }

  void read_behaviour_item(const ConfigNode& node, const std::string& path) {
    BehaviourSpec behaviour;
    behaviour.origin = node.origin;
    if (node.kind == ConfigNode::Kind::map) {
      if (node.find("program") == nullptr && node.find("team") == nullptr) {
        reader_.error(node.origin, "a behaviour without 'program', the path of its .asl file");
        return;
      }
      read_behaviour(node, path, behaviour);

    } else if (const auto program = reader_.text(node, "the path of an AgentSpeak program")) {
      behaviour.program = program_path(folder_, *program, draft_.world_kind, context_.files);
    }
    if (behaviour.program.empty()) return;
    if (behaviour.name.empty()) behaviour.name = behaviour_name(behaviour.program);
    draft_.scenario.behaviours.push_back(std::move(behaviour));
  }

  void change_behaviour(const ConfigEntry& entry, const std::string& path) {
    std::vector<std::string> names;
    for (BehaviourSpec& behaviour : draft_.scenario.behaviours) {
      if (behaviour.name == entry.key) {
        read_behaviour(entry.value, fmt::format("{}.{}", path, entry.key), behaviour);
        return;
      }
      names.push_back(behaviour.name);
    }
    reader_.error(entry.origin, fmt::format("no behaviour '{}' has been listed", entry.key),
                  did_you_mean(entry.key, names));
  }

  void read_behaviour(const ConfigNode& node, const std::string& path, BehaviourSpec& behaviour) {
    read_keys(node, path,
              {
                  {"program",
                   [&](const ConfigNode& value, const std::string&) {
                     if (const auto program = reader_.text(value, "the path of a program")) {
                       behaviour.program =
                           program_path(folder_, *program, draft_.world_kind, context_.files);
                     }
                   }},
                  {"name",
                   [&](const ConfigNode& value, const std::string&) {
                     if (const auto name = reader_.text(value, "a name")) behaviour.name = *name;
                   }},
                  {"parameters",
                   [&](const ConfigNode& value, const std::string&) {
                     read_parameters(value, reader_, behaviour.parameters);
                   }},
                  {"team", [&](const ConfigNode& value,
                               const std::string&) { read_team(value, behaviour); }},
                  {"agents", [&](const ConfigNode& value,
                                 const std::string&) { read_agents(value, behaviour.agents); }},
              });
  }

  // Agents whose number is in no list run the first program.
  void read_team(const ConfigNode& node, BehaviourSpec& behaviour) {
    if (node.kind != ConfigNode::Kind::map || node.entries.empty()) {
      reader_.unexpected(node, "agents' numbers and their programs, {1..3: random_action.asl}");
      return;
    }
    behaviour.team.clear();
    for (const ConfigEntry& entry : node.entries) {
      TeamMember member;
      member.origin = entry.value.origin;
      const auto program = reader_.text(entry.value, "the path of a program");
      if (!program || !read_numbers(entry.key, entry.origin, member.agents)) continue;
      member.program = program_path(folder_, *program, draft_.world_kind, context_.files);
      behaviour.team.push_back(std::move(member));
    }
    if (behaviour.program.empty() && !behaviour.team.empty()) {
      behaviour.program = behaviour.team.front().program;
    }
  }

  void read_agents(const ConfigNode& node, std::vector<AgentSettings>& settings) {
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "agents' numbers and their parameters, {1..3: {radius: 10}}");
      return;
    }
    for (const ConfigEntry& entry : node.entries) {
      AgentSettings setting;
      if (!read_numbers(entry.key, entry.origin, setting.agents)) continue;
      read_parameters(entry.value, reader_, setting.parameters);
      settings.push_back(std::move(setting));
    }
  }

  // A file of assertions, or a file and which of them.
  void read_assertions(const ConfigNode& node, const std::string& path) {
    if (node.kind != ConfigNode::Kind::map) {
      read_assertions_file(node, path);
      draft_.judged.clear();
      return;
    }
    read_keys(node, path,
              {
                  {"file", method(&LayerReader::read_assertions_file)},
                  {"judge", method(&LayerReader::read_judged)},
              });
  }

  void read_assertions_file(const ConfigNode& node, const std::string&) {
    if (const auto file = reader_.text(node, "the path of a file of assertions")) {
      draft_.scenario.origins["assertions"] = node.origin;
      draft_.assertions_file = path_in(folder_, *file);
    }
  }

  void read_judged(const ConfigNode& node, const std::string&) {
    if (node.kind != ConfigNode::Kind::list) {
      reader_.unexpected(node, "a list of assertions' ids");
      return;
    }
    draft_.judged.clear();
    for (const ConfigNode& item : node.items) {
      if (const auto id = reader_.text(item, "the id of an assertion")) {
        draft_.judged.emplace_back(*id, item.origin);
      }
    }
  }

  void read_experiment(const ConfigNode& node, const std::string& path) {
    ExperimentSpec& experiment = draft_.scenario.experiment;
    read_keys(node, path,
              {
                  {"tests", integer(experiment.tests, kTests)},
                  {"agents", method(&LayerReader::read_agent_numbers)},
                  {"seed", integer(experiment.seed, kSeeds)},
                  {"feedback", integer(experiment.feedback, kGenerations)},
                  {"reachable", method(&LayerReader::read_reachable)},
                  {"defects", method(&LayerReader::read_defects)},
                  {"avs", method(&LayerReader::read_avs)},
                  {"limits", method(&LayerReader::read_limits)},
              });
  }

  void read_limits(const ConfigNode& node, const std::string& path) {
    TestLimits& limits = draft_.scenario.experiment.limits;
    read_keys(node, path,
              {
                  {"cycles", integer(limits.cycles, kLimits)},
                  {"inferences", integer(limits.inferences, kLimits)},
                  {"memory_mb", integer(limits.memory_mb, kMegabytes)},
                  {"time_s", number(limits.time_s, {0, 1e6})},
              });
  }

  void read_reachable(const ConfigNode& node, const std::string&) {
    if (const auto file = reader_.text(node, "the path of a file that `jaywalk reach` wrote")) {
      draft_.reachable_file.emplace(path_in(folder_, *file), node.origin);
    }
  }

  void read_defects(const ConfigNode& node, const std::string& path) {
    draft_.scenario.origins[path] = node.origin;
    draft_.scenario.experiment.defects = read_defect_list(node, reader_);
  }

  void read_avs(const ConfigNode& node, const std::string& path) {
    draft_.scenario.origins[path] = node.origin;
    draft_.scenario.experiment.avs = read_av_list(node, reader_);
  }

  void read_agent_numbers(const ConfigNode& node, const std::string& path) {
    draft_.scenario.origins[path] = node.origin;
    std::string text = node.text;
    if (node.kind == ConfigNode::Kind::list) {
      for (const ConfigNode& item : node.items) {
        text += fmt::format("{}{}", text.empty() ? "" : ",", item.text);
      }
    } else if (node.kind != ConfigNode::Kind::scalar) {
      reader_.unexpected(node, "numbers of agents, 1..10,15,20");
      return;
    }
    (void)read_numbers(text, node.origin, draft_.scenario.experiment.agents);
  }

  bool read_numbers(std::string_view text, const ValueOrigin& origin,
                    std::vector<std::uint32_t>& numbers) {
    Result<std::vector<std::uint32_t>> list = parse_number_list(text, "");
    if (list.ok()) {
      numbers = std::move(list).value();
      return true;
    }
    for (const Diagnostic& each : list.diagnostics().items()) {
      reader_.error(origin, each.message, each.hint);
    }
    return false;
  }

  Diagnostics& diagnostics_;
};

}  // namespace

void read_layer(const ConfigNode& root, const std::string& folder, ScenarioDraft& draft,
                Diagnostics& diagnostics) {
  LayerReader(folder, draft, diagnostics).read(root);
}

std::string behaviour_name(const std::string& program) {
  return std::filesystem::path(program).stem().generic_string();
}

}  // namespace jaywalk

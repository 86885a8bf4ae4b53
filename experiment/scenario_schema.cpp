#include "experiment/scenario_schema.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "env/environments.h"
#include "experiment/number_list.h"

namespace jaywalk {
namespace {

// What a scenario may ask for; generous, but safe to multiply.
constexpr IntegerRange kCells{1, 100'000};
constexpr IntegerRange kCellsFromAnywhere{-100'000, 100'000};
constexpr IntegerRange kRows{0, 999};
constexpr IntegerRange kBandRows{1, 100};
constexpr std::size_t kMaxBands = 50;
constexpr NumberRange kMoney{0, 1e9};
constexpr NumberRange kMetres{0.01, 1000};
constexpr NumberRange kSeconds{0.001, 3600};
constexpr NumberRange kWindow{0, 3600};
constexpr NumberRange kSpeed{0.01, 10'000};
constexpr IntegerRange kTests{1, 1'000'000'000};
constexpr IntegerRange kSeeds{0, INT64_MAX};
constexpr IntegerRange kAftermath{0, 1000};
constexpr std::uint32_t kMaxAgents = 10'000;

bool is_atom(std::string_view text) {
  if (text.empty() || std::islower(static_cast<unsigned char>(text[0])) == 0) return false;
  return std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

// `1/11` is a number, too.
std::optional<double> parse_fraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_number(text);
  const std::optional<double> above = parse_number(text.substr(0, slash));
  const std::optional<double> below = parse_number(text.substr(slash + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  return *above / *below;
}

class LayerReader {
 public:
  LayerReader(const std::string& folder, ScenarioDraft& draft, Diagnostics& diagnostics)
      : folder_(folder), draft_(draft), reader_(diagnostics) {}

  void read(const ConfigNode& root) {
    read_keys(root, "",
              {
                  {"preset", [](const ConfigNode&, const std::string&) {}},  // read before
                  {"world", method(&LayerReader::read_world)},
                  {"behaviours", method(&LayerReader::read_behaviours)},
                  {"experiment", method(&LayerReader::read_experiment)},
              });
  }

 private:
  using Handler = void (LayerReader::*)(const ConfigNode&, const std::string&);

  std::function<void(const ConfigNode&, const std::string&)> method(Handler handler) {
    return [this, handler](const ConfigNode& node, const std::string& path) {
      (this->*handler)(node, path);
    };
  }

  // Keeps where the key was given, for what is found to be wrong with it later.
  void read_keys(const ConfigNode& node, const std::string& path,
                 std::initializer_list<ConfigKey> keys) {
    draft_.origins[path] = node.origin;
    reader_.read_map(node, path, {keys.begin(), keys.size()});
  }

  // The handlers of plain values: read, check, store.
  std::function<void(const ConfigNode&, const std::string&)> number(double& target,
                                                                    NumberRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.number(node, range)) target = *value;
    };
  }
  template <class T>
  std::function<void(const ConfigNode&, const std::string&)> integer(T& target,
                                                                     IntegerRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.integer(node, range)) target = static_cast<T>(*value);
    };
  }
  std::function<void(const ConfigNode&, const std::string&)> interval(Interval& target,
                                                                      IntegerRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.interval(node, range)) target = *value;
    };
  }
  template <class T>
  std::function<void(const ConfigNode&, const std::string&)> choice(
      T& target, std::initializer_list<Choice<T>> choices) {
    return [this, &target, words = std::vector<Choice<T>>(choices)](const ConfigNode& node,
                                                                    const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.choice(node, std::span<const Choice<T>>(words))) {
        target = *value;
      }
    };
  }

  [[nodiscard]] CrossingParameters& world() { return draft_.scenario.world; }

  void read_world(const ConfigNode& node, const std::string& path) {
    read_keys(node, path,
              {
                  {"environment", method(&LayerReader::read_environment)},
                  {"length", integer(world().length, kCells)},
                  {"cell", number(world().cell_m, kMetres)},
                  {"tick", number(world().tick_s, kSeconds)},
                  {"bands", method(&LayerReader::read_bands)},
                  {"av", method(&LayerReader::read_av)},
                  {"zone", method(&LayerReader::read_zone)},
                  {"road_end", integer(world().road_end, kCells)},
                  {"aftermath", integer(world().aftermath, kAftermath)},
                  {"spawn", method(&LayerReader::read_spawn)},
                  {"scoring", method(&LayerReader::read_scoring)},
              });
  }

  void read_environment(const ConfigNode& node, const std::string&) {
    const std::optional<std::string> name = reader_.text(node, "the name of an environment");
    if (!name || find_environment(*name) != nullptr) return;
    std::vector<std::string> names;
    for (const EnvironmentKind& kind : environments()) names.emplace_back(kind.name);
    reader_.error(node.origin, fmt::format("unknown environment '{}'", *name),
                  did_you_mean(*name, names));
  }

  void read_bands(const ConfigNode& node, const std::string& path) {
    if (node.kind != ConfigNode::Kind::list || node.items.empty() ||
        node.items.size() > kMaxBands) {
      reader_.unexpected(node, fmt::format("a list of 1 to {} bands", kMaxBands),
                         "a band is {kind: pavement, rows: 2} or "
                         "{kind: lane, rows: 4, direction: forward}");
      return;
    }
    draft_.origins[path] = node.origin;
    std::vector<Band> bands;
    for (const ConfigNode& item : node.items) {
      Band band;
      read_keys(
          item, path,
          {
              {"kind", choice<BandKind>(band.kind, {{"pavement", BandKind::pavement},
                                                    {"lane", BandKind::lane}})},
              {"rows", integer(band.rows, kBandRows)},
              {"direction", choice<Direction>(band.direction, {{"forward", Direction::forward},
                                                               {"back", Direction::back}})},
          });
      bands.push_back(band);
    }
    world().bands = std::move(bands);
    // Dead zones name rows of other bands; they have to be given anew.
    world().spawn.dead_zones.clear();
  }

  void read_av(const ConfigNode& node, const std::string& path) {
    AvParameters& av = world().av;
    if (node.find("speed") != nullptr && node.find("speed_mps") != nullptr) {
      reader_.error(node.origin, "give either 'speed' or 'speed_mps'");
    }
    read_keys(node, path,
              {
                  {"length", integer(av.length, kCells)},
                  {"rows", interval(av.rows, kRows)},
                  {"start", integer(av.start, kCellsFromAnywhere)},
                  {"stopping_distance", integer(av.stopping_distance, {0, kCells.most})},
                  {"speed",
                   [&](const ConfigNode& value, const std::string&) {
                     if (const auto speed = reader_.number(value, kSpeed)) {
                       av.speed = *speed;
                       draft_.speed_mps.reset();
                     }
                   }},
                  {"speed_mps",
                   [&](const ConfigNode& value, const std::string&) {
                     if (const auto speed = reader_.number(value, kSpeed)) {
                       draft_.speed_mps = *speed;
                     }
                   }},
              });
  }

  void read_zone(const ConfigNode& node, const std::string& path) {
    ZoneParameters& zone = world().zone;
    if (node.find("ttc") != nullptr && node.find("ahead") != nullptr) {
      reader_.error(node.origin, "give either 'ttc' or 'ahead'");
    }
    read_keys(
        node, path,
        {
            {"rows", method(&LayerReader::read_zone_rows)},
            {"from", choice<ZoneOrigin>(zone.origin,
                                        {{"leading_edge", ZoneOrigin::leading_edge},
                                         {"stopping_distance", ZoneOrigin::stopping_distance}})},
            {"ttc",
             [&](const ConfigNode& value, const std::string& key) {
               draft_.origins[key] = value.origin;
               if (const auto window = reader_.number_pair(value, kWindow)) {
                 zone.ttc = {(*window)[0], (*window)[1]};
                 zone.ahead.reset();
               }
             }},
            {"ahead",
             [&](const ConfigNode& value, const std::string& key) {
               draft_.origins[key] = value.origin;
               if (const auto cells = reader_.interval(value, kCellsFromAnywhere)) {
                 zone.ahead = *cells;
               }
             }},
        });
  }

  void read_zone_rows(const ConfigNode& node, const std::string& path) {
    draft_.origins[path] = node.origin;
    ZoneParameters& zone = world().zone;
    if (node.kind == ConfigNode::Kind::list) {
      if (const auto rows = reader_.interval(node, kRows)) {
        zone.rows = ZoneRows::given;
        zone.given_rows = *rows;
      }
    } else if (node.kind == ConfigNode::Kind::scalar && node.text == "lane") {
      zone.rows = ZoneRows::lane;
    } else if (node.kind == ConfigNode::Kind::scalar && node.text == "av") {
      zone.rows = ZoneRows::av;
    } else {
      reader_.unexpected(node, "lane, av or rows as [first, last]");
    }
  }

  void read_spawn(const ConfigNode& node, const std::string& path) {
    read_keys(
        node, path,
        {
            {"choose", choice<SpawnChoice>(world().spawn.choose, {{"row", SpawnChoice::row},
                                                                  {"cell", SpawnChoice::cell}})},
            {"dead_zones", method(&LayerReader::read_dead_zones)},
            {"cells",
             [&](const ConfigNode& value, const std::string& key) {
               if (const auto file = reader_.text(value, "the path of a CSV file")) {
                 draft_.origins[key] = value.origin;
                 draft_.start_cells_file = path_in(folder_, *file);
               }
             }},
        });
  }

  void read_dead_zones(const ConfigNode& node, const std::string& path) {
    draft_.origins[path] = node.origin;
    if (node.kind == ConfigNode::Kind::scalar && node.text == "none") {
      world().spawn.dead_zones.clear();
      return;
    }
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "rows and their number of cells, {0: 18}, or none");
      return;
    }
    for (const ConfigEntry& entry : node.entries) {
      const std::optional<std::int64_t> row = parse_integer(entry.key);
      if (!row || *row < kRows.least || *row > kRows.most) {
        reader_.error(entry.origin,
                      fmt::format("expected the number of a row, found '{}'", entry.key));
      } else if (const auto cells = reader_.integer(entry.value, {0, kCells.most})) {
        world().spawn.dead_zones[static_cast<int>(*row)] = static_cast<int>(*cells);
      }
    }
  }

  void read_scoring(const ConfigNode& node, const std::string& path) {
    ScoringParameters& scoring = world().scoring;
    read_keys(
        node, path,
        {
            {"pavement_cost", number(scoring.pavement_cost, kMoney)},
            {"road_cost", number(scoring.road_cost, kMoney)},
            {"costs", choice<RoadCost>(scoring.costs,
                                       {{"replace", RoadCost::replace}, {"add", RoadCost::add}})},
            {"reward", number(scoring.reward, kMoney)},
            {"rewarded", choice<Rewarded>(scoring.rewarded, {{"first_hit", Rewarded::first_hit},
                                                             {"zone", Rewarded::zone}})},
        });
  }

  // A list says which behaviours there are; a map changes those that have been listed.
  void read_behaviours(const ConfigNode& node, const std::string& path) {
    std::vector<BehaviourSpec>& behaviours = draft_.scenario.behaviours;
    draft_.origins[path] = node.origin;
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
      if (node.find("program") == nullptr) {
        reader_.error(node.origin, "a behaviour without 'program', the path of its .asl file");
        return;
      }
      read_behaviour(node, path, behaviour);
    } else if (const auto program = reader_.text(node, "the path of an AgentSpeak program")) {
      behaviour.program = path_in(folder_, *program);
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
                       behaviour.program = path_in(folder_, *program);
                     }
                   }},
                  {"name",
                   [&](const ConfigNode& value, const std::string&) {
                     if (const auto name = reader_.text(value, "a name")) behaviour.name = *name;
                   }},
                  {"parameters",
                   [&](const ConfigNode& value, const std::string&) {
                     read_parameters(value, behaviour.parameters);
                   }},
                  {"agents", [&](const ConfigNode& value,
                                 const std::string&) { read_agents(value, behaviour.agents); }},
              });
  }

  void read_agents(const ConfigNode& node, std::vector<AgentSettings>& settings) {
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "agents' numbers and their parameters, {1..3: {radius: 10}}");
      return;
    }
    for (const ConfigEntry& entry : node.entries) {
      AgentSettings setting;
      if (!read_numbers(entry.key, entry.origin, setting.agents)) continue;
      read_parameters(entry.value, setting.parameters);
      settings.push_back(std::move(setting));
    }
  }

  void read_parameters(const ConfigNode& node, std::vector<ParameterSetting>& settings) {
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "names of beliefs and their values, {radius: 15}");
      return;
    }
    for (const ConfigEntry& entry : node.entries) {
      ParameterSetting setting{entry.key, {}, entry.origin};
      if (!is_atom(entry.key)) {
        reader_.error(entry.origin,
                      fmt::format("expected the name of a belief, found '{}'", entry.key));
        continue;
      }
      if (!read_values(entry.value, setting.values)) continue;
      std::erase_if(settings, [&](const ParameterSetting& old) { return old.name == entry.key; });
      settings.push_back(std::move(setting));
    }
  }

  bool read_values(const ConfigNode& node, std::vector<ParameterValue>& values) {
    if (node.kind == ConfigNode::Kind::list) {
      return std::all_of(node.items.begin(), node.items.end(),
                         [&](const ConfigNode& item) { return read_value(item, values); });
    }
    return read_value(node, values);
  }

  bool read_value(const ConfigNode& node, std::vector<ParameterValue>& values) {
    const bool scalar = node.kind == ConfigNode::Kind::scalar;
    if (scalar && (node.text == "true" || node.text == "false")) {
      reader_.unexpected(node, "a number or an atom", "true and false are no terms in AgentSpeak");
      return false;
    }
    if (const auto value = scalar ? parse_fraction(node.text) : std::nullopt) {
      values.emplace_back(*value);
    } else if (scalar && is_atom(node.text)) {
      values.emplace_back(node.text);
    } else {
      reader_.unexpected(node, "a number (15, 0.5, 1/11) or an atom (back)");
      return false;
    }
    return true;
  }

  void read_experiment(const ConfigNode& node, const std::string& path) {
    ExperimentSpec& experiment = draft_.scenario.experiment;
    read_keys(node, path,
              {
                  {"tests", integer(experiment.tests, kTests)},
                  {"agents", method(&LayerReader::read_agent_numbers)},
                  {"seed", integer(experiment.seed, kSeeds)},
              });
  }

  void read_agent_numbers(const ConfigNode& node, const std::string& path) {
    draft_.origins[path] = node.origin;
    std::string text = node.text;
    if (node.kind == ConfigNode::Kind::list) {
      for (const ConfigNode& item : node.items) {
        text += fmt::format("{}{}", text.empty() ? "" : ",", item.text);
      }
    } else if (node.kind != ConfigNode::Kind::scalar) {
      reader_.unexpected(node, "numbers of agents, 1..10,15,20");
      return;
    }
    std::vector<std::uint32_t> numbers;
    if (!read_numbers(text, node.origin, numbers)) return;
    if (*std::max_element(numbers.begin(), numbers.end()) > kMaxAgents) {
      reader_.error(node.origin, fmt::format("more than {} agents", kMaxAgents));
      return;
    }
    draft_.scenario.experiment.agents = std::move(numbers);
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

  const std::string& folder_;
  ScenarioDraft& draft_;
  ConfigReader reader_;
};

}  // namespace

void read_layer(const ConfigNode& root, const std::string& folder, ScenarioDraft& draft,
                Diagnostics& diagnostics) {
  LayerReader(folder, draft, diagnostics).read(root);
}

std::string path_in(const std::string& folder, const std::string& path) {
  return (std::filesystem::path(folder) / path).lexically_normal().generic_string();
}

std::string behaviour_name(const std::string& program) {
  return std::filesystem::path(program).stem().generic_string();
}

}  // namespace jaywalk

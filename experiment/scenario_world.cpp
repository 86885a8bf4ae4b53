// The key `world` of a scenario.

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "env/crossing/layout.h"
#include "env/environments.h"
#include "experiment/scenario_layer.h"

namespace jaywalk {
namespace {

// What a scenario may ask for; generous, but safe to multiply.
constexpr IntegerRange kCells{1, 100'000};
constexpr IntegerRange kCellsFromZero{0, 99'999};
constexpr IntegerRange kCellsFromAnywhere{-100'000, 100'000};
constexpr IntegerRange kRows{0, 999};
constexpr IntegerRange kBandRows{1, 100};
constexpr std::size_t kMaxBands = 50;
constexpr std::size_t kMaxItems = 1000;
constexpr NumberRange kMoney{0, 1e9};
constexpr NumberRange kMetres{0.01, 1000};
constexpr NumberRange kMetresFar{0, 1e6};
constexpr NumberRange kStandoff{0, 100};
constexpr NumberRange kSeconds{0.001, 3600};
constexpr NumberRange kWindow{0, 3600};
constexpr NumberRange kTimeLimit{0, 86'400};
constexpr NumberRange kSpeed{0.01, 10'000};
constexpr NumberRange kPace{0.001, 100};
constexpr NumberRange kAcceleration{0.01, 100};
constexpr IntegerRange kAftermath{0, 1000};
constexpr IntegerRange kEpsg{1024, 32767};
constexpr NumberRange kOnEarth{-1e8, 1e8};
constexpr NumberRange kBearing{-360, 360};

class WorldReader : LayerPart {
 public:
  WorldReader(const std::string& folder, ScenarioDraft& draft, Diagnostics& diagnostics)
      : LayerPart(folder, draft, diagnostics) {}

  void read(const ConfigNode& node, const std::string& path) {
    read_keys(node, path,
              {
                  {"environment", method(&WorldReader::read_environment)},
                  {"length", integer(world().length, kCells)},
                  {"cell", number(world().cell_m, kMetres)},
                  {"tick", number(world().tick_s, kSeconds)},
                  {"bands", method(&WorldReader::read_bands)},
                  {"map", method(&WorldReader::read_map)},
                  {"crosswalks", method(&WorldReader::read_crosswalks)},
                  {"obstacles", method(&WorldReader::read_obstacles)},
                  {"actors", method(&WorldReader::read_actors)},
                  {"pedestrians", method(&WorldReader::read_pedestrians)},
                  {"anchor", method(&WorldReader::read_anchor)},
                  {"av", method(&WorldReader::read_av)},
                  {"zone", method(&WorldReader::read_zone)},
                  {"road_end", integer(world().road_end, kCells)},
                  {"aftermath", integer(world().aftermath, kAftermath)},
                  {"until", choice<TestEnd>(world().end, {{"precondition", TestEnd::precondition},
                                                          {"collision", TestEnd::collision},
                                                          {"road_end", TestEnd::road}})},
                  {"time_limit", number(world().time_limit_s, kTimeLimit)},
                  {"spawn", method(&WorldReader::read_spawn)},
                  {"scoring", method(&WorldReader::read_scoring)},
              });
  }

 private:
  using Handler = void (WorldReader::*)(const ConfigNode&, const std::string&);

  KeyReader method(Handler handler) {
    return [this, handler](const ConfigNode& node, const std::string& path) {
      (this->*handler)(node, path);
    };
  }

  [[nodiscard]] CrossingParameters& world() { return draft_.scenario.world; }

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
                  {"model", method(&WorldReader::read_model)},
                  {"reaction", optional_number(av.vehicle.reaction_s, kWindow)},
                  {"deceleration", optional_number(av.vehicle.deceleration_mps2, kAcceleration)},
                  {"acceleration", number(av.vehicle.acceleration_mps2, kAcceleration)},
                  {"range", number(av.vehicle.range_m, kMetresFar)},
                  {"standoff", number(av.vehicle.standoff_m, kStandoff)},
                  {"period", number(av.vehicle.period_s, kWindow)},
                  {"command", method(&WorldReader::read_command)},
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
            {"rows", method(&WorldReader::read_zone_rows)},
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
            {"dead_zones", method(&WorldReader::read_dead_zones)},
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

  KeyReader optional_number(std::optional<double>& target, NumberRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.number(node, range)) target = *value;
    };
  }

  void read_model(const ConfigNode& node, const std::string& path) {
    draft_.origins[path] = node.origin;
    const std::optional<std::string> name = reader_.text(node, "how the AV drives");
    if (!name) return;
    if (find_vehicle_model(*name) != nullptr) {
      world().av.vehicle.model = *name;
      return;
    }
    std::vector<std::string> names;
    for (const VehicleModel& model : vehicle_models()) names.emplace_back(model.name);
    reader_.error(node.origin, fmt::format("unknown model '{}' of the AV", *name),
                  did_you_mean(*name, names));
  }

  // A program and its arguments. One that is a file beside the scenario is found there.
  void read_command(const ConfigNode& node, const std::string& path) {
    draft_.origins[path] = node.origin;
    std::vector<std::string> command;
    if (node.kind == ConfigNode::Kind::list && !node.items.empty()) {
      for (const ConfigNode& item : node.items) {
        const auto word = reader_.text(item, "a word of a command");
        if (!word) return;
        const std::string beside = path_in(folder_, *word);
        std::error_code ignored;
        command.push_back(std::filesystem::is_regular_file(beside, ignored) ? beside : *word);
      }
      world().av.vehicle.command = std::move(command);
    } else {
      reader_.unexpected(node, "a program and its arguments as [python3, controller.py]");
    }
  }

  void read_pedestrians(const ConfigNode& node, const std::string& path) {
    PedestrianParameters& pedestrians = world().pedestrians;
    read_keys(
        node, path,
        {
            {"speed", number(pedestrians.speed, kPace)},
            {"speed_mps", optional_number(draft_.pedestrian_mps, kPace)},
            {"sight", number(pedestrians.sight, {0, 1e6})},
            {"features", choice<bool>(pedestrians.features, {{"true", true}, {"false", false}})},
        });
  }

  // The first cells of a map's rows are the bands; so the AV's lane is where its row begins.
  void read_map(const ConfigNode& node, const std::string& path) {
    draft_.origins[path] = node.origin;
    std::vector<std::string> lines;
    if (const auto text = reader_.text(node, "lines of . > < x and #")) {
      for (std::size_t at = 0; at < text->size();) {
        const std::size_t end = std::min(text->find('\n', at), text->size());
        lines.push_back(text->substr(at, end - at));
        at = end + 1;
      }
    }
    if (!check_map(node, lines)) return;
    std::vector<Band> bands;
    for (const std::string& line : lines) {
      const Band band = band_of(line.front());
      const bool same = !bands.empty() && bands.back().kind == band.kind &&
                        bands.back().direction == band.direction;
      if (same) {
        ++bands.back().rows;
      } else {
        bands.push_back(band);
      }
    }
    world().length = static_cast<int>(lines.front().size());
    world().bands = std::move(bands);
    world().map = std::move(lines);
    world().spawn.dead_zones.clear();
  }

  static Band band_of(char letter) {
    if (letter == '.' || letter == '#') return {BandKind::pavement, 1, Direction::forward};
    return {BandKind::lane, 1, letter == '<' ? Direction::back : Direction::forward};
  }

  bool check_map(const ConfigNode& node, const std::vector<std::string>& lines) {
    if (lines.empty() || lines.size() > 1000 || lines.front().empty()) {
      reader_.unexpected(node, "a map of 1 to 1000 lines of . > < x and #");
      return false;
    }
    for (std::size_t row = 0; row < lines.size(); ++row) {
      if (lines[row].size() != lines.front().size()) {
        reader_.error(node.origin, fmt::format("line {} of the map has {} cells, the first has {}",
                                               row, lines[row].size(), lines.front().size()));
        return false;
      }
      for (std::size_t y = 0; y < lines[row].size(); ++y) {
        if (find_surface(lines[row][y])) continue;
        reader_.error(
            node.origin,
            fmt::format("unknown ground '{}' in row {}, cell {} of the map", lines[row][y], row, y),
            ". pavement, > and < lanes, x junction, # blocked");
        return false;
      }
    }
    return true;
  }

  template <class Item>
  void read_list(const ConfigNode& node, const std::string& path, std::string_view expected,
                 std::vector<Item>& target, std::function<void(const ConfigNode&, Item&)> read) {
    draft_.origins[path] = node.origin;
    if (node.kind != ConfigNode::Kind::list || node.items.size() > kMaxItems) {
      reader_.unexpected(node, expected);
      return;
    }
    target.clear();
    for (const ConfigNode& item : node.items) read(item, target.emplace_back());
  }

  void require(const ConfigNode& node, std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
      if (node.kind == ConfigNode::Kind::map && node.find(key) == nullptr) {
        reader_.error(node.origin, fmt::format("the key '{}' is missing", key));
      }
    }
  }

  void read_crosswalks(const ConfigNode& node, const std::string& path) {
    read_list<Crosswalk>(
        node, path, "a list of crosswalks, {kind: zebra, cells: [30, 32]}", world().crosswalks,
        [&](const ConfigNode& item, Crosswalk& crosswalk) {
          require(item, {"cells"});
          read_keys(item, path,
                    {{"kind", choice<CrosswalkKind>(crosswalk.kind,
                                                    {{"zebra", CrosswalkKind::zebra},
                                                     {"signalled", CrosswalkKind::signalled}})},
                     {"cells", interval(crosswalk.cells, kCellsFromZero)}});
        });
  }

  void read_obstacles(const ConfigNode& node, const std::string& path) {
    read_list<Obstacle>(node, path, "a list of obstacles, {rows: [2, 2], cells: [30, 32]}",
                        world().obstacles, [&](const ConfigNode& item, Obstacle& obstacle) {
                          require(item, {"rows", "cells"});
                          read_keys(item, path,
                                    {{"rows", interval(obstacle.rows, kRows)},
                                     {"cells", interval(obstacle.cells, kCellsFromZero)}});
                        });
  }

  // What an actor is stands in the world, whose program it runs in the scenario; in the same order.
  void read_actors(const ConfigNode& node, const std::string& path) {
    std::vector<BehaviourSpec>& programs = draft_.scenario.actors;
    programs.clear();
    draft_.actor_mps.clear();
    read_list<ActorParameters>(
        node, path, "a list of actors, {kind: cyclist, program: cyclist.asl, start: [2, 60]}",
        world().actors, [&](const ConfigNode& item, ActorParameters& actor) {
          BehaviourSpec& program = programs.emplace_back();
          program.origin = item.origin;
          std::optional<double>& mps = draft_.actor_mps.emplace_back();
          read_actor(item, path, actor, program, mps);
          if (actor.name.empty()) {
            actor.name = fmt::format("{}_{}", name(actor.kind), programs.size());
          }
          program.name = actor.name;
        });
  }

  void read_actor(const ConfigNode& item, const std::string& path, ActorParameters& actor,
                  BehaviourSpec& program, std::optional<double>& mps) {
    require(item, {"kind", "program"});
    const bool is_signal = item.find("crosswalk") != nullptr;
    if (!is_signal) require(item, {"start"});
    int crosswalk = 1;
    read_keys(item, path,
              {{"kind", choice<ActorKind>(actor.kind, {{"pedestrian", ActorKind::pedestrian},
                                                       {"cyclist", ActorKind::cyclist},
                                                       {"vehicle", ActorKind::vehicle},
                                                       {"signal", ActorKind::signal}})},
               {"name",
                [&](const ConfigNode& value, const std::string&) {
                  const auto name = reader_.text(value, "a name");
                  if (name && is_atom(*name)) {
                    actor.name = *name;
                  } else if (name) {
                    reader_.unexpected(value, "a name in small letters, as an atom has it");
                  }
                }},
               {"program",
                [&](const ConfigNode& value, const std::string&) {
                  if (const auto file = reader_.text(value, "the path of a program")) {
                    program.program = path_in(folder_, *file);
                  }
                }},
               {"start",
                [&](const ConfigNode& value, const std::string&) {
                  if (const auto at = reader_.number_pair(value, {0, 1e5}, PairOrder::any)) {
                    actor.start = cell({(*at)[0], (*at)[1]});
                  }
                }},
               {"way", choice<Direction>(actor.way, {{"forward", Direction::forward},
                                                     {"back", Direction::back},
                                                     {"left", Direction::left},
                                                     {"right", Direction::right}})},
               {"speed", number(actor.speed, kSpeed)},
               {"speed_mps", optional_number(mps, kSpeed)},
               {"crosswalk", integer(crosswalk, {1, static_cast<std::int64_t>(kMaxItems)})},
               {"parameters", [&](const ConfigNode& value, const std::string&) {
                  read_parameters(value, reader_, program.parameters);
                }}});
    actor.crosswalk = static_cast<std::size_t>(crosswalk - 1);
    if (is_signal) actor.kind = ActorKind::signal;
  }
};

}  // namespace

void read_world(const ConfigNode& node, const std::string& path, const std::string& folder,
                ScenarioDraft& draft, Diagnostics& diagnostics) {
  WorldReader(folder, draft, diagnostics).read(node, path);
}

}  // namespace jaywalk

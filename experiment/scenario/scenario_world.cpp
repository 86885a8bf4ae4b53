// The key `world` of a scenario; what lies on the ground, who is on it and the AV are read in files
// of their own (scenario_road.cpp, scenario_actors.cpp, scenario_av.cpp).

#include <fmt/format.h>

#include "env/environments.h"
#include "experiment/scenario/scenario_layer.h"
#include "experiment/scenario/scenario_ranges.h"

namespace jaywalk {
namespace {

// What a scenario may ask for; generous, but safe to multiply.
constexpr NumberRange kMoney{0, 1e9};
constexpr NumberRange kMetres{0.01, 1000};
constexpr NumberRange kSeconds{0.001, 3600};
constexpr NumberRange kTimeLimit{0, 86'400};
constexpr NumberRange kPace{0.001, 100};
constexpr IntegerRange kAftermath{0, 1000};
constexpr IntegerRange kEpsg{1024, 32767};
constexpr NumberRange kOnEarth{-1e8, 1e8};
constexpr NumberRange kBearing{-360, 360};

class WorldReader : LayerPart {
 public:
  WorldReader(const std::string& folder, ScenarioDraft& draft, Diagnostics& diagnostics)
      : LayerPart(folder, draft, diagnostics), diagnostics_(diagnostics) {}

  void read(const ConfigNode& node, const std::string& path) {
    read_keys(node, path,
              {
                  {"environment", method(&WorldReader::read_environment)},
                  {"length", integer(world().length, kCells)},
                  {"cell", number(world().cell_m, kMetres)},
                  {"tick", number(world().tick_s, kSeconds)},
                  {"bands", part(jaywalk::read_bands)},
                  {"map", part(jaywalk::read_map)},
                  {"crosswalks", part(jaywalk::read_crosswalks)},
                  {"obstacles", part(jaywalk::read_obstacles)},
                  {"actors", part(jaywalk::read_actors)},
                  {"pedestrians", method(&WorldReader::read_pedestrians)},
                  {"anchor", method(&WorldReader::read_anchor)},
                  {"av", part(jaywalk::read_av)},
                  {"simulator", part(jaywalk::read_simulator)},
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

  // A key that is read in a file of its own.
  KeyReader part(PartReader* reader) {
    return [this, reader](const ConfigNode& node, const std::string& path) {
      reader(node, path, folder_, draft_, diagnostics_);
    };
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

  void read_environment(const ConfigNode& node, const std::string&) {
    const std::optional<std::string> name = reader_.text(node, "the name of an environment");
    if (!name || find_environment(*name) != nullptr) return;
    std::vector<std::string> names;
    for (const EnvironmentKind& kind : environments()) names.emplace_back(kind.name);
    reader_.error(node.origin, fmt::format("unknown environment '{}'", *name),
                  did_you_mean(*name, names));
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

  Diagnostics& diagnostics_;
};

}  // namespace

void read_world(const ConfigNode& node, const std::string& path, const std::string& folder,
                ScenarioDraft& draft, Diagnostics& diagnostics) {
  WorldReader(folder, draft, diagnostics).read(node, path);
}

}  // namespace jaywalk

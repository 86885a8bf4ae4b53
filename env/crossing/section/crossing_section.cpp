// SPDX-License-Identifier: Apache-2.0
// The key `world` of a scenario in the crossing. Separate files read the ground (road_section.cpp)
// and the actors (actors_section.cpp).

#include "env/crossing/section/crossing_section.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "env/config/reader.h"
#include "env/crossing/simulated_drive.h"
#include "env/crossing/world.h"
#include "env/simulator/simulator_section.h"
#include "env/vehicle/vehicle_section.h"

namespace jaywalk {
namespace {

class AvReader : VehicleSection {
 public:
  AvReader(const SectionContext& context, CrossingDraft& draft)
      : VehicleSection(context), draft_(draft) {}

  void read_av(const ConfigNode& node, const std::string& path) {
    AvParameters& av = draft_.world.av;
    if (node.find("speed") != nullptr && node.find("speed_mps") != nullptr) {
      reader_.error(node.origin, "give either 'speed' or 'speed_mps'");
    }
    std::vector<ConfigKey> keys{
        {"length", integer(av.length, kCells)},
        {"rows", interval(av.rows, kRows)},
        {"start", integer(av.start, kCellsFromAnywhere)},
        {"stopping_distance", integer(av.stopping_distance, {0, kCells.most})},
        {"carry_over", choice<bool>(av.carry_over, {{"true", true}, {"false", false}})},
    };
    add_keys(av.vehicle, av.twin, keys);
    keys.push_back({"speed", [&](const ConfigNode& value, const std::string& key) {
                      speed(av.speed, kSpeed, "speed_mps")(value, key);
                      draft_.speed_mps.reset();
                    }});
    keys.push_back({"speed_mps", speed(draft_.speed_mps, kSpeed, "speed_mps")});
    read_keys(node, path, keys);
  }

 private:
  CrossingDraft& draft_;
};

// Ranges of the keys: generous, but small enough that products of them do not overflow.
constexpr NumberRange kMoney{0, 1e9};
constexpr NumberRange kMetres{0.01, 1000};
constexpr NumberRange kSeconds{0.001, 3600};
constexpr NumberRange kTimeLimit{0, 86'400};
constexpr NumberRange kPace{0.001, 100};
constexpr IntegerRange kAftermath{0, 1000};

class CrossingReader : CrossingPart {
 public:
  CrossingReader(const SectionContext& context, CrossingDraft& draft)
      : CrossingPart(context, draft) {}

  void read(const ConfigNode& node, const std::string& path, std::span<const ConfigKey> common) {
    std::vector<ConfigKey> keys(common.begin(), common.end());
    keys.insert(keys.end(),
                {
                    {"length", integer(world().length, kCells)},
                    {"cell", number(world().cell_m, kMetres)},
                    {"tick", number(world().tick_s, kSeconds)},
                    {"bands", part(jaywalk::read_bands)},
                    {"map", part(jaywalk::read_map)},
                    {"crosswalks", part(jaywalk::read_crosswalks)},
                    {"obstacles", part(jaywalk::read_obstacles)},
                    {"actors", part(jaywalk::read_actors)},
                    {"pedestrians", method(&CrossingReader::read_pedestrians)},
                    {"av", part(jaywalk::read_av)},
                    {"simulator",
                     [this](const ConfigNode& value, const std::string& key) {
                       read_simulator(value, key, context_, world().simulator);
                     }},
                    {"zone", method(&CrossingReader::read_zone)},
                    {"road_end", integer(world().road_end, kCells)},
                    {"aftermath", integer(world().aftermath, kAftermath)},
                    {"until", choice<TestEnd>(world().end, {{"precondition", TestEnd::precondition},
                                                            {"collision", TestEnd::collision},
                                                            {"road_end", TestEnd::road}})},
                    {"time_limit", number(world().time_limit_s, kTimeLimit)},
                    {"spawn", method(&CrossingReader::read_spawn)},
                    {"scoring", method(&CrossingReader::read_scoring)},
                });
    read_keys(node, path, keys);
  }

 private:
  using Handler = void (CrossingReader::*)(const ConfigNode&, const std::string&);

  KeyReader method(Handler handler) {
    return [this, handler](const ConfigNode& node, const std::string& path) {
      (this->*handler)(node, path);
    };
  }

  // A key that is read in a file of its own.
  KeyReader part(CrossingPartReader* reader) {
    return [this, reader](const ConfigNode& node, const std::string& path) {
      reader(node, path, context_, draft_);
    };
  }

  void read_zone(const ConfigNode& node, const std::string& path) {
    ZoneParameters& zone = world().zone;
    if (node.find("ttc") != nullptr && node.find("ahead") != nullptr) {
      reader_.error(node.origin, "give either 'ttc' or 'ahead'");
    }
    read_keys(
        node, path,
        {
            {"rows", method(&CrossingReader::read_zone_rows)},
            {"from", choice<ZoneOrigin>(zone.origin,
                                        {{"leading_edge", ZoneOrigin::leading_edge},
                                         {"stopping_distance", ZoneOrigin::stopping_distance}})},
            {"ttc",
             [&](const ConfigNode& value, const std::string& key) {
               note_origin(value, key);
               if (const auto window = reader_.number_pair(value, kWindow)) {
                 zone.ttc = {(*window)[0], (*window)[1]};
                 zone.ahead.reset();
               }
             }},
            {"ahead",
             [&](const ConfigNode& value, const std::string& key) {
               note_origin(value, key);
               if (const auto cells = reader_.interval(value, kCellsFromAnywhere)) {
                 zone.ahead = *cells;
               }
             }},
        });
  }

  void read_zone_rows(const ConfigNode& node, const std::string& path) {
    note_origin(node, path);
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
            {"dead_zones", method(&CrossingReader::read_dead_zones)},
            {"cells",
             [&](const ConfigNode& value, const std::string& key) {
               if (const auto file = reader_.text(value, "the path of a CSV file")) {
                 note_origin(value, key);
                 draft_.start_cells_file = path_in(context_.folder, *file);
               }
             }},
        });
  }

  void read_dead_zones(const ConfigNode& node, const std::string& path) {
    note_origin(node, path);
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
            {"speed", speed(pedestrians.speed, kPace, "speed_mps")},
            {"speed_mps", speed(draft_.pedestrian_mps, kPace, "speed_mps")},
            {"sight", number(pedestrians.sight, {0, 1e6})},
            {"features", choice<bool>(pedestrians.features, {{"true", true}, {"false", false}})},
        });
  }
};

class CrossingSection final : public WorldSection {
 public:
  void read(const ConfigNode& node, const std::string& path, const SectionContext& context,
            std::span<const ConfigKey> common) override {
    CrossingReader(context, draft_).read(node, path, common);
  }

  void check(const std::string& scenario, const SectionContext& context) override {
    CrossingParameters& world = draft_.world;
    const double mps_to_cells = world.tick_s / world.cell_m;
    if (draft_.speed_mps) world.av.speed = *draft_.speed_mps * mps_to_cells;
    if (draft_.pedestrian_mps) world.pedestrians.speed = *draft_.pedestrian_mps * mps_to_cells;
    for (std::size_t i = 0; i < draft_.actor_mps.size(); ++i) {
      if (draft_.actor_mps[i]) world.actors[i].speed = *draft_.actor_mps[i] * mps_to_cells;
    }
    warn_of_speed(
        world.av.speed / mps_to_cells, draft_.speed_mps ? "world.av.speed_mps" : "world.av.speed",
        draft_.speed_mps ? std::string()
                         : fmt::format("'speed' is in cells of {:g} m and ticks of {:g} s",
                                       world.cell_m, world.tick_s),
        context);
    std::vector<ParameterProblem> found = problems(world);
    if (!world.simulator.name.empty()) {
      std::optional<SimulatedSite> site;
      if (found.empty()) site = simulated_site(world);
      check_simulator(world.simulator, site ? &*site : nullptr, scenario, context);
    }
    for (ParameterProblem& problem : found) {
      report(context.diagnostics, origin_of(context.origins, problem.path, scenario),
             std::move(problem.message), fmt::format("the key is {}", problem.path));
    }
    check_vehicle(world.av.vehicle, world.av.twin, scenario, context);
  }

  void read_files(const SectionContext& context, std::vector<SourcePtr>& sources) override {
    if (!draft_.start_cells_file) return;
    Result<SourcePtr> source = context.files.read(*draft_.start_cells_file);
    if (!source.ok()) {
      context.diagnostics.append(std::move(source.diagnostics()));
      return;
    }
    Result<StartCells> cells = parse_start_cells(source.value(), grid(draft_.world));
    if (!cells.ok()) {
      context.diagnostics.append(std::move(cells.diagnostics()));
      return;
    }
    sources.push_back(source.value());
    draft_.start_cells = std::make_shared<const StartCells>(std::move(cells).value());
  }

  std::vector<std::vector<std::string>*> commands() override {
    std::vector<std::vector<std::string>*> commands{&draft_.world.av.vehicle.command};
    if (auto& twin = draft_.world.av.twin) commands.push_back(&twin->command);
    for (auto& [key, value] : draft_.world.simulator.settings) commands.push_back(&value.command);
    return commands;
  }

  std::vector<WorldAgent> agents() const override { return draft_.agents; }

  std::vector<std::string> av_models() const override {
    return av_model_names(draft_.world.simulator);
  }

  std::shared_ptr<const WorldSpec> finish() const override {
    CrossingParameters world = draft_.world;
    // A file is where its copy is.
    for (auto& [key, value] : world.simulator.settings) {
      if (!value.text.empty() && !value.command.empty()) value.text = value.command.front();
    }
    return std::make_shared<CrossingSpec>(std::move(world), draft_.start_cells);
  }

 private:
  CrossingDraft draft_;
};

}  // namespace

void read_av(const ConfigNode& node, const std::string& path, const SectionContext& context,
             CrossingDraft& draft) {
  AvReader(context, draft).read_av(node, path);
}

std::unique_ptr<WorldSection> crossing_section() { return std::make_unique<CrossingSection>(); }

}  // namespace jaywalk

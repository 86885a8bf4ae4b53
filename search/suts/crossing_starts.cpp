// SPDX-License-Identifier: Apache-2.0
#include "search/suts/crossing_starts.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "experiment/scenario/scenario_schema.h"

namespace jaywalk::search {
namespace {

std::vector<int> pavement_rows(const CrossingParameters& world) {
  std::vector<int> rows;
  int row = 0;
  for (const Band& band : world.bands) {
    for (int i = 0; i < band.rows; ++i, ++row) {
      if (band.kind == BandKind::pavement) rows.push_back(row);
    }
  }
  return rows;
}

/// The cells in which no test begins that draws its own. Some are left, as of every world.
void leave_out_dead_zones(const CrossingParameters& world, CrossingStarts& starts) {
  CrossingStarts left{.searched = starts.searched};
  for (std::size_t i = 0; i < starts.rows.size(); ++i) {
    const auto dead = world.spawn.dead_zones.find(starts.rows[i]);
    std::vector<int>& cells = starts.cells[i];
    if (dead != world.spawn.dead_zones.end()) {
      std::erase_if(cells, [&](int cell) { return cell < dead->second; });
    }
    if (cells.empty()) continue;
    left.rows.push_back(starts.rows[i]);
    left.cells.push_back(std::move(cells));
  }
  starts = std::move(left);
}

}  // namespace

void CrossingStartsReader::read(const ConfigNode& node, const std::string& path) {
  if (node.kind != ConfigNode::Kind::map) {
    const std::array choices = {
        Choice<Starts>{"searched", Starts::searched}, Choice<Starts>{"spawn", Starts::spawn},
        Choice<Starts>{"chance", Starts::chance}, Choice<Starts>{"given", Starts::given}};
    if (const auto chosen = reader_.choice<Starts>(node, choices)) starts_ = *chosen;
    return;
  }
  const auto list = [&](std::vector<int>& numbers) {
    return [this, &numbers](const ConfigNode& value, const std::string&) {
      read_whole_numbers(value, numbers);
    };
  };
  const std::vector<ConfigKey> keys{
      {"rows", list(rows_)},
      {"cells", list(cells_)},
      {"walks", [&](const ConfigNode& value, const std::string&) { read_walks(value); }}};
  origin_ = node.origin;
  reader_.read_map(node, path, keys);
}

void CrossingStartsReader::read_whole_numbers(const ConfigNode& node, std::vector<int>& numbers) {
  for (const ConfigNode& item : node.items) {
    if (const auto number = reader_.integer(item, {0, 1'000'000})) {
      numbers.push_back(static_cast<int>(*number));
    }
  }
  if (node.items.empty()) reader_.unexpected(node, "a list of whole numbers");
}

/// The path of a file of walks, each with its start.
void CrossingStartsReader::read_walks(const ConfigNode& value) {
  const auto path = reader_.text(value, "the path of a file of walks");
  if (!path) return;
  const Result<SourcePtr> source =
      setup_.files.read(path_in(setup_.folder, *path), kMaxScenarioBytes);
  if (!source.ok()) {
    reader_.error(value.origin, fmt::format("no file of walks is at '{}'", *path),
                  "jaywalk reach SCENARIO --csv writes one");
    return;
  }
  Result<ReachFile> file = parse_reach_file(source.value());
  if (!file.ok()) {
    reader_.error_in(value.origin, file.diagnostics());
  } else if (file.value().walks.empty()) {
    reader_.error(value.origin, fmt::format("'{}' has no walks", *path));
  } else {
    walks_ = std::move(file.value().walks);
    file_ = source.value();
  }
}

std::optional<CrossingStarts> CrossingStartsReader::space(const CrossingSpec& crossing,
                                                          std::uint32_t agents) const {
  if (!walks_.empty()) return starts_of_walks(agents);
  if (starts_ == Starts::chance) return CrossingStarts{};
  if (starts_ == Starts::given) return given_starts(crossing, agents);
  const CrossingParameters& world = crossing.parameters();
  CrossingStarts starts{.searched = agents, .rows = pavement_rows(world)};
  std::vector<int> cells(static_cast<std::size_t>(world.length));
  std::iota(cells.begin(), cells.end(), 0);
  if (!choose(rows_, starts.rows, "no pavement has the row") ||
      !choose(cells_, cells, "the road has no cell")) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < starts.rows.size(); ++i) starts.cells.push_back(cells);
  if (starts_ == Starts::spawn) leave_out_dead_zones(world, starts);
  return starts;
}

std::optional<CrossingStarts> CrossingStartsReader::starts_of_walks(std::uint32_t agents) const {
  if (agents != 1) {
    reader_.error(origin_, fmt::format("walks are of one pedestrian, not of {}", agents));
    return std::nullopt;
  }
  CrossingStarts starts;
  for (const ScriptedWalk& walk : walks_) {
    starts.given.push_back({walk.start});
    starts.moves.push_back(walk.moves);
  }
  return starts;
}

/// Leaves those that are wanted, if any are named; false after reporting one that is not there.
bool CrossingStartsReader::choose(const std::vector<int>& wanted, std::vector<int>& all,
                                  std::string_view what_is_wrong) const {
  for (const int each : wanted) {
    if (std::ranges::find(all, each) != all.end()) continue;
    reader_.error(origin_, fmt::format("{} {}", what_is_wrong, each));
    return false;
  }
  if (!wanted.empty()) all = wanted;
  return true;
}

std::optional<CrossingStarts> CrossingStartsReader::given_starts(const CrossingSpec& crossing,
                                                                 std::uint32_t agents) const {
  CrossingStarts starts;
  if (crossing.given_starts() != nullptr) {
    for (const auto& [test, cells] : *crossing.given_starts()) {
      if (cells.size() < agents) continue;
      starts.given.emplace_back(cells.begin(), cells.begin() + agents);
    }
  }
  if (!starts.given.empty()) return starts;
  reader_.error(setup_.node.find("starts")->origin,
                fmt::format("the scenario gives no start cells of {} pedestrians", agents),
                "world.spawn.cells names a file of them; `compare --starts` writes one");
  return std::nullopt;
}

}  // namespace jaywalk::search

// SPDX-License-Identifier: Apache-2.0
// Reads the ground: bands or a map, crosswalks, obstacles.

#include <algorithm>

#include <fmt/format.h>

#include "env/config/reader.h"
#include "env/crossing/layout.h"
#include "env/crossing/section/crossing_section.h"

namespace jaywalk {
namespace {

constexpr IntegerRange kCellsFromZero{0, 99'999};
constexpr IntegerRange kBandRows{1, 100};
constexpr std::size_t kMaxBands = 50;

class RoadReader : CrossingPart {
 public:
  RoadReader(const SectionContext& context, CrossingDraft& draft) : CrossingPart(context, draft) {}

  void read_bands(const ConfigNode& node, const std::string& path) {
    if (node.kind != ConfigNode::Kind::list || node.items.empty() ||
        node.items.size() > kMaxBands) {
      reader_.unexpected(node, fmt::format("a list of 1 to {} bands", kMaxBands),
                         "a band is {kind: pavement, rows: 2} or "
                         "{kind: lane, rows: 4, direction: forward}");
      return;
    }
    note_origin(node, path);
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

  // The first cells of a map's rows are the bands; so the AV's lane is where its row begins.
  void read_map(const ConfigNode& node, const std::string& path) {
    note_origin(node, path);
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

 private:
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
};

}  // namespace

void read_bands(const ConfigNode& node, const std::string& path, const SectionContext& context,
                CrossingDraft& draft) {
  RoadReader(context, draft).read_bands(node, path);
}

void read_map(const ConfigNode& node, const std::string& path, const SectionContext& context,
              CrossingDraft& draft) {
  RoadReader(context, draft).read_map(node, path);
}

void read_crosswalks(const ConfigNode& node, const std::string& path, const SectionContext& context,
                     CrossingDraft& draft) {
  RoadReader(context, draft).read_crosswalks(node, path);
}

void read_obstacles(const ConfigNode& node, const std::string& path, const SectionContext& context,
                    CrossingDraft& draft) {
  RoadReader(context, draft).read_obstacles(node, path);
}

}  // namespace jaywalk

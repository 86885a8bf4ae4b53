// SPDX-License-Identifier: Apache-2.0
#include "reference.h"

#include <algorithm>
#include <cstdlib>

namespace jaywalk::reference {
namespace {

constexpr int kRadius = 15;
constexpr std::uint64_t kOneIn = 11;

}  // namespace

Pedestrians::Pedestrians(Behaviour behaviour, const Crossing& world, std::uint64_t seed)
    : behaviour_(behaviour), world_(world), random_(seed), walkers_(world.positions().size()) {}

std::vector<Step> Pedestrians::decide() {
  const bool elects =
      behaviour_ == Behaviour::election || behaviour_ == Behaviour::election_by_intersect;
  if (elects && !elected_ && world_.ticks() > 0) elect();
  std::vector<Step> steps;
  for (std::size_t i = 0; i < walkers_.size(); ++i) steps.push_back(step_of(i));
  return steps;
}

Step Pedestrians::step_of(std::size_t agent) {
  const Position position = world_.positions()[agent];
  Walker& walker = walkers_[agent];
  if (behaviour_ == Behaviour::random_action) return random_action(position);
  const bool first = world_.ticks() == 0;
  bool starts = false;
  switch (behaviour_) {
    case Behaviour::random_behaviour:
      starts = !walker.crossing && chance(kOneIn);
      break;
    case Behaviour::proximity:
      starts = !first && distance(position) < kRadius;
      break;
    case Behaviour::intersect:
      starts = !first && zone_entry(position).has_value();
      break;
    case Behaviour::intersect_literal:
      starts = !first && crosses_early(position);
      break;
    case Behaviour::random_action:
    case Behaviour::election:
    case Behaviour::election_by_intersect:
      break;
  }
  if (starts && !walker.crossing) walker.crossing = way_across(position);
  return walker.crossing ? cross(agent) : walk_on(agent);
}

Step Pedestrians::random_action(Position position) {
  std::vector<Step> steps{std::nullopt};
  for (int i = 0; i < kDirectionCount; ++i) {
    const auto direction = static_cast<Direction>(i);
    if (grid(world_.parameters()).contains(neighbour(position, direction))) {
      steps.emplace_back(direction);
    }
  }
  return steps[random_.below(steps.size())];
}

Step Pedestrians::walk_on(std::size_t agent) {
  Walker& walker = walkers_[agent];
  if (!walker.way) walker.way = chance(2) ? Direction::forward : Direction::back;
  const Position next = neighbour(world_.positions()[agent], *walker.way);
  if (!grid(world_.parameters()).contains(next)) {
    walker.way = *walker.way == Direction::forward ? Direction::back : Direction::forward;
  }
  return walker.way;
}

Step Pedestrians::cross(std::size_t agent) {
  Walker& walker = walkers_[agent];
  const int x = world_.positions()[agent].x;
  const int rows = grid(world_.parameters()).rows;
  if (behaviour_ == Behaviour::random_behaviour) {
    if (*walker.crossing == Direction::left && x == 1) walker.crossing = Direction::right;
    if (*walker.crossing == Direction::right && x == rows - 1) walker.crossing = Direction::left;
    return walker.crossing;
  }
  const bool arrived = *walker.crossing == Direction::left ? x == 0 : x == rows - 1;
  return arrived ? std::nullopt : walker.crossing;
}

Direction Pedestrians::way_across(Position position) const {
  return position.x < world_.zone_rows().first ? Direction::right : Direction::left;
}

int Pedestrians::distance(Position position) const {
  const Interval lane = av_lane(world_.parameters());
  const int rows = std::max({lane.first - position.x, position.x - lane.last, 0});
  return std::abs(position.y - world_.av_cell()) + rows;
}

// Ticks until an agent that crosses now is in the zone, if it ever is.
std::optional<int> Pedestrians::zone_entry(Position position) const {
  const CrossingParameters& parameters = world_.parameters();
  const Interval rows = world_.zone_rows();
  const int moves = std::max(rows.first - position.x, position.x - rows.last);
  for (int t = moves; t < moves + rows.size(); ++t) {
    const int origin = zone_origin(parameters, world_.ticks() + t - 1);
    const Interval ahead = zone_ahead(parameters);
    const Interval cells{origin + ahead.first, std::min(origin + ahead.last, parameters.road_end)};
    if (cells.contains(position.y)) return t;
  }
  return std::nullopt;
}

// The draft's sentence: the lower bound only.
bool Pedestrians::crosses_early(Position position) const {
  const Interval rows = world_.zone_rows();
  const int moves = std::max(rows.first - position.x, position.x - rows.last);
  const int origin = zone_origin(world_.parameters(), world_.ticks() + moves - 1);
  return origin + zone_ahead(world_.parameters()).first <= position.y;
}

void Pedestrians::elect() {
  std::optional<std::size_t> winner;
  int least = 0;
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    const Position position = world_.positions()[i];
    std::optional<int> rank = distance(position);
    if (behaviour_ == Behaviour::election_by_intersect) {
      rank = zone_entry(position);
    } else if (*rank >= kRadius) {
      continue;
    }
    if (!rank || (winner && *rank >= least)) continue;
    winner = i;
    least = *rank;
  }
  if (!winner) return;
  elected_ = true;
  walkers_[*winner].crossing = way_across(world_.positions()[*winner]);
}

void tick(Crossing& world, const CrossingVocabulary& vocabulary, const std::vector<Step>& steps) {
  std::vector<Value> ways;
  ways.reserve(steps.size());  // requests point into it
  std::vector<ActionRequest> requests;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!steps[i]) continue;
    ways.push_back(vocabulary.atom(*steps[i]));
    requests.push_back({static_cast<AgentId>(i), vocabulary.move(), {&ways.back(), 1}});
  }
  std::vector<ActionResult> results(requests.size());
  world.execute(requests, results);
  world.advance();
}

CrossingResult run(Behaviour behaviour, const CrossingParameters& parameters,
                   const std::vector<Position>& start, std::uint64_t seed,
                   std::optional<Direction> way) {
  SymbolTable symbols;
  const CrossingVocabulary vocabulary(symbols);
  Crossing world(parameters, vocabulary, start);
  Pedestrians pedestrians(behaviour, world, seed);
  for (std::size_t i = 0; way && i < start.size(); ++i) pedestrians.walk(i, *way);
  while (!world.finished()) tick(world, vocabulary, pedestrians.decide());
  return world.result();
}

}  // namespace jaywalk::reference

#include "env/crossing/crossing.h"

#include <algorithm>
#include <cassert>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace jaywalk {
namespace {

ActionResult failure(std::string reason) {
  return {.succeeded = false, .reason = std::move(reason)};
}

double heading_rad(Direction direction) {
  using std::numbers::pi;
  switch (direction) {
    case Direction::left:
      return pi;
    case Direction::right:
      return 0;
    case Direction::forward:
      return pi / 2;
    case Direction::back:
      return -pi / 2;
  }
  return 0;
}

}  // namespace

double CrossingResult::score() const {
  if (pedestrians.empty()) return 0;
  double sum = 0;
  for (const PedestrianOutcome& outcome : pedestrians) sum += outcome.reward - outcome.cost;
  return sum / static_cast<double>(pedestrians.size());
}

Crossing::Crossing(const CrossingParameters& parameters, const CrossingVocabulary& vocabulary,
                   std::vector<Position> start)
    : parameters_(parameters),
      vocabulary_(vocabulary),
      grid_(grid(parameters)),
      zone_rows_(jaywalk::zone_rows(parameters)),
      zone_ahead_(zone_ahead(parameters)),
      positions_(std::move(start)),
      acted_in_(positions_.size(), 0),
      stepped_in_(positions_.size(), 0),
      origin_(zone_origin(parameters, 0)) {
  result_.start = positions_;
  // Before its first step everyone looks at the AV's lane.
  for (const Position& position : positions_) {
    facing_.push_back(position.x > parameters.av.rows.last ? Direction::left : Direction::right);
  }
  result_.pedestrians.resize(positions_.size());
}

void Crossing::perceive(AgentId agent, Percepts& percepts) const {
  using enum CrossingPercept;
  const auto index = static_cast<std::size_t>(agent);
  assert(index < positions_.size() && "every agent has a start cell");
  const auto add = [&](CrossingPercept percept, auto... args) {
    percepts.add(vocabulary_.percept(percept), {Value::number(args)...});
  };
  add(tick, ticks_ + 1);
  add(at, positions_[index].x, positions_[index].y);
  add(av, origin_);
  for (const std::size_t hit : result_.hit_by) add(precondition_met, static_cast<double>(hit + 1));

  add(id, static_cast<double>(index + 1));
  add(pedestrians, static_cast<double>(positions_.size()));
  add(CrossingPercept::grid, grid_.rows, grid_.cells);
  int first = 0;
  for (const Band& band : parameters_.bands) {
    const int last = first + band.rows - 1;
    if (band.kind == BandKind::pavement) {
      add(pavement, first, last);
    } else {
      percepts.add(vocabulary_.percept(lane),
                   {Value::number(first), Value::number(last), vocabulary_.atom(band.direction)});
    }
    first = last + 1;
  }
  add(av_rows, parameters_.av.rows.first, parameters_.av.rows.last);
  add(av_length, parameters_.av.length);
  add(av_speed, parameters_.av.speed);
  add(CrossingPercept::zone_rows, zone_rows_.first, zone_rows_.last);
  add(CrossingPercept::zone_ahead, zone_ahead_.first, zone_ahead_.last);
  add(road_end, parameters_.road_end);
  add(tick_length, parameters_.tick_s);
  add(cell_length, parameters_.cell_m);
}

ActionResult Crossing::act(const ActionRequest& action) {
  const auto index = static_cast<std::size_t>(action.agent);
  assert(index < positions_.size() && "every agent has a start cell");
  if (action.predicate == vocabulary_.stay()) return {};
  if (action.predicate != vocabulary_.move()) {
    return failure("unknown action, expected move(Way) or stay");
  }
  if (std::exchange(acted_in_[index], ticks_ + 1) == ticks_ + 1) {
    return failure("a second step in the same tick");
  }
  for (int i = 0; i < kDirectionCount; ++i) {
    const auto direction = static_cast<Direction>(i);
    if (!action.args[0].same_as(vocabulary_.atom(direction))) continue;
    const Position target = neighbour(positions_[index], direction);
    if (!grid_.contains(target)) {
      return failure(fmt::format("a step {} from ({},{}) leaves the grid", name(direction),
                                 positions_[index].x, positions_[index].y));
    }
    positions_[index] = target;
    stepped_in_[index] = ticks_ + 1;
    facing_[index] = direction;
    return {};
  }
  return failure("unknown way to move, expected left, right, forward or back");
}

void Crossing::execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) {
  assert(actions.size() == results.size());
  // A move never depends on where others are: one after another is all at once.
  for (std::size_t i = 0; i < actions.size(); ++i) results[i] = act(actions[i]);
}

void Crossing::charge_costs() {
  const ScoringParameters& scoring = parameters_.scoring;
  const double road = scoring.costs == RoadCost::replace
                          ? scoring.road_cost
                          : scoring.pavement_cost + scoring.road_cost;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const bool on_road = band_kind(parameters_, positions_[i].x) == BandKind::lane;
    result_.pedestrians[i].cost += on_road ? road : scoring.pavement_cost;
  }
}

Interval Crossing::zone_cells() const {
  return {std::max(origin_ + zone_ahead_.first, 0),
          std::min({origin_ + zone_ahead_.last, parameters_.road_end, grid_.cells - 1})};
}

bool Crossing::in_zone(Position position, Interval cells) const {
  return zone_rows_.contains(position.x) && cells.contains(position.y);
}

void Crossing::sweep_zone() {
  const Interval cells = zone_cells();
  for (const Position& position : positions_) {
    if (!in_zone(position, cells)) continue;
    result_.hit_cell = std::min(result_.hit_cell.value_or(position.y), position.y);
  }
  if (!result_.hit_cell) return;
  result_.success = true;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (!in_zone(positions_[i], cells)) continue;
    const bool first = positions_[i].y == *result_.hit_cell;
    if (first) result_.hit_by.push_back(i);
    if (first || parameters_.scoring.rewarded == Rewarded::zone) {
      result_.pedestrians[i].reward = parameters_.scoring.reward;
    }
  }
}

void Crossing::advance() {
  ++ticks_;
  if (!result_.success) {
    result_.ticks = ticks_;
    charge_costs();
    sweep_zone();
  }
  origin_ = zone_origin(parameters_, ticks_);
}

bool Crossing::finished() const {
  if (result_.success) return ticks_ >= result_.ticks + parameters_.aftermath;
  return origin_ >= parameters_.road_end;
}

int Crossing::av_edge() const {
  const int ahead = parameters_.zone.origin == ZoneOrigin::stopping_distance
                        ? parameters_.av.stopping_distance
                        : 0;
  return origin_ - ahead;
}

std::vector<Actor> Crossing::actors() const {
  const double cell = parameters_.cell_m;
  std::vector<Actor> actors{
      {"av", ActorKind::vehicle, parameters_.av.length * cell, parameters_.av.rows.size() * cell}};
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    actors.push_back(
        {fmt::format("p{}", i + 1), ActorKind::pedestrian, kPedestrianSizeM, kPedestrianSizeM});
  }
  return actors;
}

Scene Crossing::scene() const {
  const double cell = parameters_.cell_m;
  const AvParameters& av = parameters_.av;
  const double step_mps = cell / parameters_.tick_s;
  Scene scene{{(av.rows.first + av.rows.last + 1) / 2.0 * cell,
               (av_edge() + 1 - av.length / 2.0) * cell, av.speed * step_mps,
               heading_rad(Direction::forward)}};
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const bool steps = ticks_ > 0 && stepped_in_[i] == ticks_;
    scene.push_back({(positions_[i].x + 0.5) * cell, (positions_[i].y + 0.5) * cell,
                     steps ? step_mps : 0, heading_rad(facing_[i])});
  }
  return scene;
}

}  // namespace jaywalk

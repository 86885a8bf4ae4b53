// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/crossing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace jaywalk {
namespace {

ActionResult refusal(std::string reason) {
  return {.succeeded = false, .reason = std::move(reason)};
}

std::vector<RoadUser> bodies_at(const CrossingParameters& parameters,
                                const std::vector<Position>& start) {
  std::vector<RoadUser> bodies;
  for (const Position position : start) {
    // Before its first step everyone looks at the AV's way.
    const bool right_of_av = position.x > parameters.av.rows.last;
    bodies.push_back({.kind = ActorKind::pedestrian,
                      .place = middle(position),
                      .speed = parameters.pedestrians.speed,
                      .facing = right_of_av ? Direction::left : Direction::right});
  }
  for (const ActorParameters& actor : parameters.actors) {
    Position at = actor.start;
    if (actor.kind == ActorKind::signal) at.y = parameters.crosswalks[actor.crosswalk].cells.first;
    bodies.push_back(
        {.kind = actor.kind, .place = middle(at), .speed = actor.speed, .facing = actor.way});
  }
  return bodies;
}

}  // namespace

Crossing::Crossing(const CrossingParameters& parameters, const CrossingVocabulary& vocabulary,
                   std::vector<Position> start, int head_start)
    : parameters_(parameters),
      vocabulary_(vocabulary),
      given_(given_percepts(parameters)),
      layout_(parameters),
      zone_rows_(jaywalk::zone_rows(parameters)),
      zone_ahead_(zone_ahead(parameters)),
      pedestrians_(start.size()),
      bodies_(bodies_at(parameters, start)),
      positions_(std::move(start)),
      signals_(parameters.crosswalks.size(), SignalColour::green),
      av_(parameters, head_start),
      max_ticks_(max_ticks(parameters)),
      origin_(zone_origin_at(parameters, head_start)) {
  result_.start = positions_;
  result_.agents.resize(positions_.size());
  note_end();
}

std::string_view name(EndReason reason) {
  constexpr std::array<std::string_view, 4> kNames = {"precondition", "collision", "road_end",
                                                      "time_limit"};
  return kNames[static_cast<std::size_t>(reason)];
}

ActionResult Crossing::act(const ActionRequest& action) {
  const auto index = static_cast<std::size_t>(action.agent);
  assert(index < bodies_.size() && "every agent has a body");
  if (action.predicate == vocabulary_.stay()) return {};
  if (action.predicate == vocabulary_.show()) return show(index, action.args);
  if (action.predicate != vocabulary_.move() && action.predicate != vocabulary_.move_by()) {
    return refusal("unknown action, expected move(Way), move(Way,Cells), stay or show(Colour)");
  }
  RoadUser& body = bodies_[index];
  // Marked before the step is known to succeed: a step that failed was an attempt, too.
  if (std::exchange(body.acted_in, ticks_ + 1) == ticks_ + 1) {
    return refusal("a second step in the same tick");
  }
  if (body.kind == ActorKind::signal) return refusal("a signal does not move");
  ActionResult result = move(body, action.args);
  // Costs, zone and percepts go by whole cells.
  if (index < pedestrians_) positions_[index] = cell(body.place);
  return result;
}

ActionResult Crossing::move(RoadUser& body, std::span<const Value> args) {
  double cells = body.speed;
  if (args.size() == 2) {
    if (!args[1].is_number() || !(args[1].as_number() >= 0)) {
      return refusal("the cells of a step are a number, at least 0");
    }
    cells = std::min(cells, args[1].as_number());
  }
  for (int i = 0; i < kDirectionCount; ++i) {
    const auto direction = static_cast<Direction>(i);
    if (!args[0].same_as(vocabulary_.atom(direction))) continue;
    std::string obstacle = step(body, layout_, direction, cells, ticks_ + 1);
    return obstacle.empty() ? ActionResult{} : refusal(std::move(obstacle));
  }
  return refusal("unknown way to move, expected left, right, forward or back");
}

ActionResult Crossing::show(std::size_t agent, std::span<const Value> args) {
  if (bodies_[agent].kind != ActorKind::signal) return refusal("only a signal shows a colour");
  const ActorParameters& actor = parameters_.actors[agent - pedestrians_];
  for (const auto colour : {SignalColour::green, SignalColour::amber, SignalColour::red}) {
    if (!args[0].same_as(vocabulary_.atom(colour))) continue;
    // Only a change is an event.
    if (std::exchange(signals_[actor.crosswalk], colour) != colour) {
      result_.signals.push_back({ticks_ + 1, agent, colour});
    }
    return {};
  }
  return refusal("unknown colour, expected green, amber or red");
}

void Crossing::execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) {
  assert(actions.size() == results.size());
  // A move never depends on where others are: one after another is all at once.
  for (std::size_t i = 0; i < actions.size(); ++i) {
    results[i] = act(actions[i]);
    const auto agent = static_cast<std::size_t>(actions[i].agent);
    if (results[i].succeeded && agent < pedestrians_) ++result_.agents[agent].actions;
  }
}

void Crossing::charge_costs() {
  const ScoringParameters& scoring = parameters_.scoring;
  const double road = scoring.costs == RoadCost::replace
                          ? scoring.road_cost
                          : scoring.pavement_cost + scoring.road_cost;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    result_.agents[i].cost += layout_.is_road(positions_[i]) ? road : scoring.pavement_cost;
  }
}

Interval Crossing::zone_cells() const {
  return {std::max(origin_ + zone_ahead_.first, 0),
          std::min({origin_ + zone_ahead_.last, parameters_.road_end, layout_.grid().cells - 1})};
}

bool Crossing::in_zone(Position position, Interval cells) const {
  return zone_rows_.contains(position.x) && cells.contains(position.y);
}

void Crossing::sweep_zone() {
  const Interval cells = zone_cells();
  for (const Position& position : positions_) {
    if (!in_zone(position, cells)) continue;
    // The AV would hit the pedestrian in the nearest cell first.
    result_.hit_cell = std::min(result_.hit_cell.value_or(position.y), position.y);
  }
  if (!result_.hit_cell) return;
  result_.hit_origin = origin_;
  result_.success = true;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (!in_zone(positions_[i], cells)) continue;
    // Several pedestrians in that cell meet the precondition together.
    const bool first = positions_[i].y == *result_.hit_cell;
    if (first) result_.met_by.push_back(i);
    if (first || parameters_.scoring.rewarded == Rewarded::zone) {
      result_.agents[i].reward = parameters_.scoring.reward;
    }
  }
}

void Crossing::advance() {
  ++ticks_;
  const double out_of_sight = parameters_.av.vehicle.range_m / parameters_.cell_m;
  for (RoadUser& body : bodies_) {
    if (body.gone && body.stepped_in < ticks_) leave(body, layout_, out_of_sight, ticks_);
  }
  if (!result_.success) {
    result_.ticks = ticks_;
    // Within the tick the actions come before the costs, these before the zone, and the AV drives
    // last. The tick of the precondition costs, those of the aftermath do not.
    charge_costs();
    sweep_zone();
  }
  drive();
  result_.all_ticks = ticks_;
  note_end();
}

std::size_t Crossing::first_traffic() const { return pedestrians_ + parameters_.actors.size(); }

void Crossing::begin(DriveBriefing briefing) {
  av_.begin(std::move(briefing), actors(), scene());
  if (av_.simulated() == nullptr) return;
  for (const Actor& each : av_.simulated()->traffic()) bodies_.push_back({.kind = each.kind});
  move_traffic();
  origin_ = zone_origin_at(parameters_, av_.driven());
  note_end();
}

void Crossing::move_traffic() {
  const double cell = parameters_.cell_m;
  for (std::size_t i = first_traffic(); i < bodies_.size(); ++i) {
    const std::size_t index = i - first_traffic();
    const ActorState at = av_.simulated()->traffic_state(index);
    RoadUser& body = bodies_[i];
    // A place in cells is that of a cell's middle, in metres that of its near corner plus a half.
    body.place = {at.x_m / cell - 0.5, at.y_m / cell - 0.5};
    body.facing = nearest_direction(at.heading_rad);
    body.step = at.speed_mps * parameters_.tick_s / cell;
    body.speed = body.step;
    body.stepped_in = ticks_;
    body.absent = !av_.simulated()->is_present(index);
  }
}

void Crossing::drive() {
  const double speed_before = av_.speed();
  const Interval ahead_before = zone_ahead_;
  std::vector<Collision> collisions =
      av_.drive(ticks_, bodies_, signals_, layout_, result_.collisions);
  result_.collisions.insert(result_.collisions.end(), collisions.begin(), collisions.end());
  move_traffic();
  origin_ = zone_origin_at(parameters_, av_.driven());
  if (!parameters_.zone.ahead) zone_ahead_ = zone_ahead(parameters_, av_.speed());
  // Percepts that stay while the AV does are only built again when this number changes
  // (perceive.cpp).
  if (av_.speed() != speed_before || zone_ahead_ != ahead_before) ++rest_number_;
}

std::optional<EndReason> Crossing::end_reason() const {
  std::optional<int> begun;  // the tick of what ends the test after the aftermath
  if (parameters_.end == TestEnd::precondition && result_.success) begun = result_.ticks;
  if (parameters_.end == TestEnd::collision && !result_.collisions.empty()) {
    begun = result_.collisions.front().tick;
  }
  if (begun && ticks_ >= *begun + parameters_.aftermath) {
    return parameters_.end == TestEnd::precondition ? EndReason::precondition
                                                    : EndReason::collision;
  }
  // During the aftermath the time limit still ends the test, the end of the road does not.
  if (max_ticks_ > 0 && ticks_ >= max_ticks_) return EndReason::time_limit;
  if (!begun && origin_ >= parameters_.road_end) return EndReason::road_end;
  return std::nullopt;
}

void Crossing::note_end() {
  const auto reason = end_reason();
  result_.end = reason ? name(*reason) : std::string_view();
}

void Crossing::end() {
  DriveEnd end{.why = result_.end, .impact_mps = {}};
  if (!result_.collisions.empty()) end.impact_mps = result_.collisions.front().impact_mps;
  av_.end(end);
}

int Crossing::left_over() const {
  if (!parameters_.av.carry_over) return 0;
  if (result_.success) return *result_.hit_origin + zone_ahead_.last - *result_.hit_cell;
  return std::max(origin_ - parameters_.road_end, 0);
}

int Crossing::av_edge() const {
  const int ahead = parameters_.zone.origin == ZoneOrigin::stopping_distance
                        ? parameters_.av.stopping_distance
                        : 0;
  return origin_ - ahead;
}

std::vector<Actor> Crossing::actors() const {
  std::vector<Actor> actors{av_.actor()};
  for (std::size_t i = 0; i < first_traffic(); ++i) {
    const BoxSize size = size_of(bodies_[i].kind);
    actors.push_back(
        {i < pedestrians_ ? fmt::format("p{}", i + 1) : parameters_.actors[i - pedestrians_].name,
         bodies_[i].kind, size.length_m, size.width_m});
  }
  if (const SimulatedDrive* const simulated = av_.simulated()) {
    actors.insert(actors.end(), simulated->traffic().begin(), simulated->traffic().end());
  }
  return actors;
}

Scene Crossing::scene() const {
  const double cell = parameters_.cell_m;
  const double step_mps = cell / parameters_.tick_s;
  Scene scene{av_.state()};
  for (const RoadUser& body : std::span(bodies_).first(first_traffic())) {
    const double step = ticks_ > 0 ? body.step_in(ticks_) : 0;
    scene.push_back({(body.place.x + 0.5) * cell, (body.place.y + 0.5) * cell, step * step_mps,
                     heading_rad(body.facing)});
  }
  for (std::size_t i = first_traffic(); i < bodies_.size(); ++i) {
    scene.push_back(av_.simulated()->traffic_state(i - first_traffic()));
  }
  return scene;
}

std::vector<WorldEvent> Crossing::events() const {
  std::vector<WorldEvent> events;
  for (const SignalChange& each : result_.signals) {
    events.push_back({each.tick, each.body + 1, "signal", std::string(name(each.colour))});
  }
  return events;
}

std::string Crossing::describe_result() const {
  if (!result_.success) return World::describe_result();
  std::vector<std::size_t> numbers;
  for (const std::size_t index : result_.met_by) numbers.push_back(index + 1);
  return fmt::format("precondition met in tick {} at cell {} by pedestrian{} {}, score {:.2f}",
                     result_.ticks, *result_.hit_cell, numbers.size() == 1 ? "" : "s",
                     fmt::join(numbers, ", "), result_.score());
}

bool Crossing::last_action_failed(std::size_t agent) const {
  if (agent >= bodies_.size()) return false;
  return bodies_[agent].acted_in == ticks_ && bodies_[agent].stepped_in != ticks_;
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
// The percepts of the agents of the crossing world: the rows of percepts.def, in their order.

#include <cassert>
#include <cmath>

#include "env/crossing/crossing.h"

namespace jaywalk {

class Crossing::Perceiver {
 public:
  Perceiver(const Crossing& world, std::size_t agent, Percepts& percepts)
      : world_(world), agent_(agent), percepts_(percepts) {}

  void perceive() {
    how_the_test_stands();
    if (gives(blocked)) blocked_ways();
    if (gives(crosswalk)) signals();
    if (gives(road_user)) road_users();
    if (gives(ground_here) && !self().gone) features();
    if (percepts_.keep_rest(vocabulary().percept(id), world_.rest_number_)) return;
    add(id, static_cast<double>(agent_ + 1));
    number_of_pedestrians();
    add(walking_speed, self().speed);
    road();
    vehicle();
    add(av_speed, world_.av_.speed());
    zone();
    add(CrossingPercept::zone_ahead, world_.zone_ahead_.first, world_.zone_ahead_.last);
    end_of_road();
  }
  // Percepts that all agents share and that never change during a test.
  void perceive_constants() {
    number_of_pedestrians();
    road();
    vehicle();
    zone();
    end_of_road();
  }

 private:
  using enum CrossingPercept;

  [[nodiscard]] bool gives(CrossingPercept percept) const {
    return world_.given_[static_cast<std::size_t>(percept)];
  }
  template <class... Args>
  void add(CrossingPercept percept, Args... args) {
    assert(gives(percept) && "percepts.def says when");
    percepts_.add(vocabulary().percept(percept), {term(args)...});
  }
  static Value term(double number) { return Value::number(number); }
  Value term(Direction direction) const { return vocabulary().atom(direction); }
  Value term(Surface kind) const { return vocabulary().atom(kind); }
  Value term(SignalColour colour) const { return vocabulary().atom(colour); }
  Value term(ActorKind kind) const { return vocabulary().atom(kind); }
  Value term(CrosswalkKind kind) const { return vocabulary().atom(kind); }

  [[nodiscard]] const CrossingVocabulary& vocabulary() const { return world_.vocabulary_; }
  [[nodiscard]] const RoadUser& self() const { return world_.bodies_[agent_]; }

  void how_the_test_stands() {
    add(tick, world_.ticks_ + 1);
    add(at, self().place.x, self().place.y);
    add(CrossingPercept::av, world_.origin_);
    if (gives(precondition_met)) {
      for (const std::size_t hit : world_.result_.met_by) {
        add(precondition_met, static_cast<double>(hit + 1));
      }
    }
    if (gives(collision)) {
      for (const Collision& each : world_.result_.collisions) {
        add(collision, static_cast<double>(each.body + 1));
      }
    }
  }

  void blocked_ways() {
    for (int i = 0; i < kDirectionCount; ++i) {
      const auto direction = static_cast<Direction>(i);
      if (is_blocked(self(), world_.layout_, direction, self().speed)) add(blocked, direction);
    }
  }

  void signals() {
    const std::vector<Crosswalk>& all = world_.parameters_.crosswalks;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto number = static_cast<double>(i + 1);
      add(crosswalk, number, all[i].cells.first, all[i].cells.last, all[i].kind);
      if (all[i].kind == CrosswalkKind::signalled) {
        add(CrossingPercept::signal, number, world_.signals_[i]);
      }
    }
  }

  void road_users() {
    const double sight = world_.parameters_.pedestrians.sight;
    for (std::size_t i = 0; i < world_.bodies_.size(); ++i) {
      const RoadUser& other = world_.bodies_[i];
      const GridPoint here = self().place;
      const double distance = std::hypot(other.place.x - here.x, other.place.y - here.y);
      const bool seen = other.kind != ActorKind::signal && !other.absent && distance <= sight;
      if (i == agent_ || !seen) continue;
      add(road_user, static_cast<double>(i + 1), other.kind, other.place.x, other.place.y,
          other.facing, other.step_in(world_.ticks_));
    }
  }

  void features() {
    const Position here = cell(self().place);
    add(ground_here, world_.layout_.at(here));
    for (int i = 0; i < kDirectionCount; ++i) {
      const auto direction = static_cast<Direction>(i);
      const Position next = neighbour(here, direction);
      const bool inside = world_.layout_.grid().contains(next);
      add(ground, direction, inside ? world_.layout_.at(next) : Surface::blocked);
    }
    for (const Direction side : {Direction::left, Direction::right}) kerb_on(here, side);
    add(av_offset, world_.origin_ - self().place.y);
  }

  // The cells to the nearest road straight across, if there is one.
  void kerb_on(Position here, Direction side) {
    int steps = 0;
    for (Position p = here; world_.layout_.grid().contains(p); p = neighbour(p, side)) {
      if (world_.layout_.is_road(p)) {
        add(kerb, side, steps);
        return;
      }
      ++steps;
    }
  }

  void number_of_pedestrians() { add(pedestrians, static_cast<double>(world_.pedestrians_)); }

  void road() {
    const CrossingParameters& parameters = world_.parameters_;
    add(CrossingPercept::grid, world_.layout_.grid().rows, world_.layout_.grid().cells);
    int first = 0;
    for (const Band& band : parameters.bands) {
      const int last = first + band.rows - 1;
      if (band.kind == BandKind::pavement) {
        add(pavement, first, last);
      } else {
        add(lane, first, last, band.direction);
      }
      first = last + 1;
    }
    for (const Obstacle& each : parameters.obstacles) {
      add(obstacle, each.rows.first, each.rows.last, each.cells.first, each.cells.last);
    }
    add(tick_length, parameters.tick_s);
    add(cell_length, parameters.cell_m);
  }

  void vehicle() {
    const AvParameters& vehicle = world_.parameters_.av;
    add(av_rows, vehicle.rows.first, vehicle.rows.last);
    add(av_length, vehicle.length);
  }

  void zone() { add(CrossingPercept::zone_rows, world_.zone_rows_.first, world_.zone_rows_.last); }

  void end_of_road() { add(road_end, world_.parameters_.road_end); }

  const Crossing& world_;
  std::size_t agent_;
  Percepts& percepts_;
};

void Crossing::perceive(AgentId agent, Percepts& percepts) const {
  const auto index = static_cast<std::size_t>(agent);
  assert(index < bodies_.size() && "every agent has a body");
  Perceiver(*this, index, percepts).perceive();
}

void Crossing::constants(Percepts& percepts) const {
  Perceiver(*this, 0, percepts).perceive_constants();
}

}  // namespace jaywalk

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The world of the case study: pedestrians beside a straight road on which an automated vehicle
// (AV) drives, perhaps with other road users. A test asks whether some pedestrian gets into the
// precondition zone in front of it. Read parameters.h before; percepts.def lists what agents
// perceive and do.
//
// Tick t, in this order: all agents perceive what tick t - 1 left; all moves take effect at once;
// costs are charged on the new positions; the AV sweeps the zone ahead of where it stood after
// tick t - 1, cell by cell, until it meets a pedestrian; then it moves (av.h); then the test may
// end.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "env/crossing/av.h"
#include "env/crossing/layout.h"
#include "env/crossing/parameters.h"
#include "env/crossing/road_user.h"
#include "env/crossing/vocabulary.h"
#include "env/scene.h"
#include "env/world/world.h"

namespace jaywalk {

/// A signal begins to show another colour in a tick. The bodies are the pedestrians and then the
/// other actors.
struct SignalChange {
  int tick = 0;
  std::size_t body = 0;
  SignalColour colour = SignalColour::green;
};

/// The world's name.
inline constexpr std::string_view kCrossing = "crossing";

/// Why a test has ended.
enum class EndReason { precondition, collision, road_end, time_limit };

/// `precondition`, `collision`, `road_end` or `time_limit`.
[[nodiscard]] std::string_view name(EndReason reason);

/// The outcome of a test; the agents are the pedestrians. Nobody is stopped by a collision.
struct CrossingResult : WorldResult {
  /// The nearest occupied cell of the zone when the precondition was met, and the zone's origin.
  std::optional<int> hit_cell;
  std::optional<int> hit_origin;
  std::vector<Position> start;
  /// In the order of time; all signals are green before.
  std::vector<SignalChange> signals;
};

class Crossing final : public World {
 public:
  /// One agent for each start cell, then one for each actor of the parameters; AgentId is the
  /// index. The AV begins `head_start` cells ahead of where the parameters let it start. REQUIRES:
  /// parameters without problems(), start cells on the grid, a head start that some test has left
  /// over (or 0). Parameters and vocabulary must outlive the world.
  Crossing(const CrossingParameters& parameters, const CrossingVocabulary& vocabulary,
           std::vector<Position> start, int head_start = 0);

  void perceive(AgentId agent, Percepts& percepts) const override;
  void constants(Percepts& percepts) const override;
  void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) override;
  void advance() override;
  [[nodiscard]] bool finished() const override { return end_reason().has_value(); }
  [[nodiscard]] double tick_s() const override { return parameters_.tick_s; }

  [[nodiscard]] const CrossingParameters& parameters() const { return parameters_; }
  [[nodiscard]] std::string_view kind() const override { return kCrossing; }
  [[nodiscard]] int ticks() const override { return ticks_; }
  /// The pedestrians' cells.
  [[nodiscard]] std::span<const Position> positions() const { return positions_; }
  /// The pedestrians, then the other actors, then the traffic of a simulator, which has no agents.
  [[nodiscard]] std::span<const RoadUser> bodies() const { return bodies_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  /// The colour that the signal of a crosswalk shows to vehicles.
  [[nodiscard]] SignalColour signal(std::size_t crosswalk) const { return signals_[crosswalk]; }
  [[nodiscard]] const Av& vehicle() const { return av_; }
  /// The cell of the AV's leading edge; its body lies behind it.
  [[nodiscard]] int av_edge() const;
  /// The cell from which the zone and distances are measured.
  [[nodiscard]] int av_cell() const { return origin_; }
  /// The cells of the zone that the next tick tests.
  [[nodiscard]] Interval zone_cells() const;
  [[nodiscard]] Interval zone_rows() const { return zone_rows_; }
  /// Starts the controller or simulator. Adds the simulator's own traffic to the bodies and actors.
  void begin(DriveBriefing briefing) override;
  void end() override;
  [[nodiscard]] std::vector<std::string> take_notes() override { return av_.take_notes(); }
  [[nodiscard]] std::string failure() const override { return av_.failure(); }
  /// The AV, named `av`, the pedestrians p1, p2, … in the agents' order, then the other bodies.
  [[nodiscard]] std::vector<Actor> actors() const override;
  [[nodiscard]] Scene scene() const override;
  /// The signals' new colours.
  [[nodiscard]] std::vector<WorldEvent> events() const override;
  /// Once the test is finished: the cells of the last tick's drive that came after what ended it.
  /// With `av.carry_over` they are the next test's head start; 0 without.
  [[nodiscard]] int left_over() const override;
  [[nodiscard]] const CrossingResult& result() const override { return result_; }
  /// With the cell that the precondition was met in.
  [[nodiscard]] std::string describe_result() const override;
  [[nodiscard]] bool last_action_failed(std::size_t agent) const override;

 private:
  class Perceiver;

  [[nodiscard]] std::optional<EndReason> end_reason() const;
  void note_end();
  ActionResult act(const ActionRequest& action);
  ActionResult move(RoadUser& body, std::span<const Value> args);
  ActionResult show(std::size_t agent, std::span<const Value> args);
  void charge_costs();
  void sweep_zone();
  void drive();
  void move_traffic();
  [[nodiscard]] std::size_t first_traffic() const;
  [[nodiscard]] bool in_zone(Position position, Interval cells) const;

  const CrossingParameters& parameters_;
  const CrossingVocabulary& vocabulary_;
  std::array<bool, kCrossingPercepts.size()> given_;
  Layout layout_;
  Interval zone_rows_;
  Interval zone_ahead_;
  std::size_t pedestrians_;
  std::vector<RoadUser> bodies_;
  std::vector<Position> positions_;  // of the pedestrians' bodies
  std::vector<SignalColour> signals_;
  Av av_;
  int ticks_ = 0;
  int max_ticks_ = 0;
  int origin_ = 0;
  // Counts the changes of what agents perceive from `id` on; see Percepts::keep_rest.
  std::uint64_t rest_number_ = 1;
  CrossingResult result_;
};

}  // namespace jaywalk

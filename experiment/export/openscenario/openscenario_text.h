// SPDX-License-Identifier: Apache-2.0
#pragma once

// One test as an OpenSCENARIO document: entities, their starts and actions, the end of the test.
// Only what is valid in all of 1.0 to 1.3 is written. Read courses.h first.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "env/crossing/parameters.h"
#include "experiment/export/exporter.h"
#include "experiment/export/openscenario/courses.h"
#include "experiment/export/openscenario/road_plan.h"

namespace jaywalk {

/// Names of parameters with a test's values.
using ParameterValues = std::vector<std::pair<std::string, std::string>>;

/// For each actor the number of waypoints of its longest course in a batch.
using BatchShape = std::vector<std::size_t>;

class ScenarioText {
 public:
  /// All of them must outlive it.
  ScenarioText(const Recording& recording, const CrossingParameters& world, const RoadPlan& plan,
               ScenarioDialect dialect)
      : recording_(recording), world_(world), plan_(plan), dialect_(dialect) {}

  /// Everybody on a timetable, to the end of the test.
  [[nodiscard]] std::string trajectories(std::string_view description,
                                         const Courses& courses) const;
  /// The AV keeps to a timetable, pedestrians start as their courses say, when the AV comes near.
  /// Ends at a collision.
  [[nodiscard]] std::string reactive(std::string_view description, const Courses& courses) const;
  /// The reactive scenario with parameters for numbers, and these as their defaults.
  [[nodiscard]] std::string batch(std::string_view description, const BatchShape& shape,
                                  const ParameterValues& defaults) const;
  /// The test's values of a batch's parameters.
  [[nodiscard]] ParameterValues values(const Courses& courses, const BatchShape& shape) const;
  /// The signals' colours as a list of phases.
  [[nodiscard]] std::string signals(double stop_s) const;

 private:
  /// A place and the time of being there, as texts: numbers or references to parameters.
  struct Vertex {
    std::string time;
    std::string x;
    std::string y;
    std::string heading;
  };
  struct Parts {
    std::string declarations;
    std::string signals;
    std::string entities;
    std::string init;
    std::string groups;
    std::string stops;
  };

  [[nodiscard]] std::size_t actors() const { return recording_.actors().size(); }
  [[nodiscard]] bool is_entity(std::size_t actor) const {
    return recording_.actors()[actor].kind != ActorKind::signal;
  }
  [[nodiscard]] std::string entity(std::size_t actor) const;
  [[nodiscard]] std::string parameter(std::size_t actor, std::string_view what) const;
  [[nodiscard]] Vertex vertex(std::size_t actor, const Waypoint& point) const;
  [[nodiscard]] std::vector<Vertex> vertices(std::size_t actor, const Course& course) const;
  [[nodiscard]] std::vector<Vertex> parameters(std::size_t actor, std::size_t count) const;
  [[nodiscard]] std::string follow(std::size_t actor, const std::vector<Vertex>& vertices,
                                   std::string_view timing) const;
  [[nodiscard]] std::string group(std::size_t actor, std::string_view action,
                                  std::string_view conditions) const;
  [[nodiscard]] std::string by_av(std::string_view name, std::string_view condition) const;
  [[nodiscard]] std::string ttc_below(std::size_t actor, std::string_view seconds) const;
  [[nodiscard]] std::string begin(std::size_t actor, const Course& course) const;
  [[nodiscard]] std::string stop(std::string_view seconds, bool on_collision) const;
  [[nodiscard]] std::string box(const Actor& what, double ahead, double height) const;
  [[nodiscard]] std::string object(std::size_t actor) const;
  [[nodiscard]] std::string init(std::size_t actor, const Vertex& at, std::string_view speed) const;
  /// Parked cars and what else hides pedestrians.
  void add_obstacles(Parts& parts) const;
  [[nodiscard]] Parts played(const Courses& courses, bool reactive) const;
  [[nodiscard]] std::string document(std::string_view description, const Parts& parts) const;

  const Recording& recording_;
  const CrossingParameters& world_;
  const RoadPlan& plan_;
  ScenarioDialect dialect_;
};

}  // namespace jaywalk

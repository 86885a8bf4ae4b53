// SPDX-License-Identifier: Apache-2.0
#include "experiment/export/openscenario/openscenario_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

/// The reference point of a vehicle is the middle of its rear axle, this share of its length behind
/// its middle.
constexpr double kRearAxle = 0.3;

/// How much smaller obstacles are exported at each side, in metres: players count it as a collision
/// if the AV passes an obstacle in the cell beside it without a gap.
constexpr double kClearance = 0.01;

/// The value of a parameter of time that no condition of the test uses.
constexpr double kNever = 1e6;
/// At time 0 nothing is greater than 0 yet.
constexpr double kAtStart = -0.001;

std::string world_position(std::string_view x, std::string_view y, std::string_view h) {
  return fmt::format(
      "<Position><WorldPosition x=\"{}\" y=\"{}\" z=\"0\" h=\"{}\" p=\"0\" r=\"0\"/></Position>", x,
      y, h);
}

// Without the sign that what rounds to nothing would keep.
std::string number(double value) {
  std::string text = fmt::format("{:.4f}", value);
  return text == "-0.0000" ? "0.0000" : text;
}

std::string after(std::string_view name, std::string_view seconds) {
  return fmt::format(
      "<Condition name=\"{}\" delay=\"0\" conditionEdge=\"none\"><ByValueCondition>"
      "<SimulationTimeCondition value=\"{}\" rule=\"greaterThan\"/></ByValueCondition>"
      "</Condition>",
      name, seconds);
}

std::string condition_group(std::string_view condition) {
  return fmt::format("<ConditionGroup>{}</ConditionGroup>\n", condition);
}

std::string at_start() { return condition_group(after("at the start", number(kAtStart))); }

std::string speed_action(std::string_view speed) {
  return fmt::format(
      "<LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape=\"step\" value=\"0\" "
      "dynamicsDimension=\"time\"/><SpeedActionTarget><AbsoluteTargetSpeed value=\"{}\"/>"
      "</SpeedActionTarget></SpeedAction></LongitudinalAction>",
      speed);
}

/// At which speed a course begins.
double first_speed(const Course& course) {
  if (course.start != CourseStart::at_once) return 0;
  const Waypoint& from = course.points[0];
  const Waypoint& to = course.points[1];
  return std::hypot(to.x_m - from.x_m, to.y_m - from.y_m) / (to.time_s - from.time_s);
}

/// Red, amber and green light of a signal.
std::string_view lights(std::string_view colour) {
  if (colour == "red") return "on;off;off";
  return colour == "amber" ? "off;on;off" : "off;off;on";
}

}  // namespace

std::string ScenarioText::entity(std::size_t actor) const {
  if (actor == 0 && dialect_ == ScenarioDialect::carla) return "hero";
  return escaped_xml(recording_.actors()[actor].name);
}

std::string ScenarioText::parameter(std::size_t actor, std::string_view what) const {
  return fmt::format("{}_{}", escaped_xml(recording_.actors()[actor].name), what);
}

ScenarioText::Vertex ScenarioText::vertex(std::size_t actor, const Waypoint& point) const {
  const bool vehicle = recording_.actors()[actor].kind == ActorKind::vehicle;
  const double back = vehicle ? recording_.actors()[actor].length_m * kRearAxle : 0;
  return {number(point.time_s), number(point.x_m - back * std::cos(point.heading_rad)),
          number(point.y_m - back * std::sin(point.heading_rad)),
          fmt::format("{:.6f}", point.heading_rad)};
}

std::vector<ScenarioText::Vertex> ScenarioText::vertices(std::size_t actor,
                                                         const Course& course) const {
  std::vector<Vertex> result;
  for (const Waypoint& point : course.points) result.push_back(vertex(actor, point));
  return result;
}

std::vector<ScenarioText::Vertex> ScenarioText::parameters(std::size_t actor,
                                                           std::size_t count) const {
  std::vector<Vertex> result;
  for (std::size_t i = 0; i < count; ++i) {
    const auto reference = [&](char what) {
      return "$" + parameter(actor, fmt::format("{}{}", what, i));
    };
    result.push_back({reference('T'), reference('X'), reference('Y'), reference('H')});
  }
  return result;
}

// Standing still is a vertex repeated at a later time.
std::string ScenarioText::follow(std::size_t actor, const std::vector<Vertex>& vertices,
                                 std::string_view timing) const {
  std::string text;
  for (const Vertex& each : vertices) {
    text += fmt::format("<Vertex time=\"{}\">{}</Vertex>\n", each.time,
                        world_position(each.x, each.y, each.heading));
  }
  return fmt::format(
      "<RoutingAction><FollowTrajectoryAction>\n"
      "<Trajectory name=\"{} way\" closed=\"false\"><ParameterDeclarations/><Shape><Polyline>\n{}"
      "</Polyline></Shape></Trajectory>\n"
      "<TimeReference><Timing domainAbsoluteRelative=\"{}\" scale=\"1\" offset=\"0\"/>"
      "</TimeReference>\n<TrajectoryFollowingMode followingMode=\"position\"/>\n"
      "</FollowTrajectoryAction></RoutingAction>",
      entity(actor), text, timing);
}

std::string ScenarioText::group(std::size_t actor, std::string_view action,
                                std::string_view conditions) const {
  return fmt::format(
      "<ManeuverGroup maximumExecutionCount=\"1\" name=\"{0} group\">\n"
      "<Actors selectTriggeringEntities=\"false\"><EntityRef entityRef=\"{0}\"/></Actors>\n"
      "<Maneuver name=\"{0} maneuver\"><Event name=\"{0} event\" priority=\"overwrite\" "
      "maximumExecutionCount=\"1\">\n"
      "<Action name=\"{0} action\"><PrivateAction>{1}</PrivateAction></Action>\n"
      "<StartTrigger>{2}</StartTrigger>\n"
      "</Event></Maneuver></ManeuverGroup>\n",
      entity(actor), action, conditions);
}

std::string ScenarioText::by_av(std::string_view name, std::string_view condition) const {
  return fmt::format(
      "<Condition name=\"{}\" delay=\"0\" conditionEdge=\"none\"><ByEntityCondition>"
      "<TriggeringEntities triggeringEntitiesRule=\"any\"><EntityRef entityRef=\"{}\"/>"
      "</TriggeringEntities><EntityCondition>{}</EntityCondition></ByEntityCondition></Condition>",
      name, entity(0), condition);
}

// Time to the box of the standing pedestrian: the vehicle need not be on its way to hit it yet.
// 1.0 demands alongRoute; later versions still take it.
std::string ScenarioText::ttc_below(std::size_t actor, std::string_view seconds) const {
  return condition_group(
      by_av(fmt::format("the AV comes to {}", entity(actor)),
            fmt::format("<TimeToCollisionCondition value=\"{}\" freespace=\"true\" "
                        "alongRoute=\"false\" rule=\"lessThan\"><TimeToCollisionConditionTarget>"
                        "<EntityRef entityRef=\"{}\"/></TimeToCollisionConditionTarget>"
                        "</TimeToCollisionCondition>",
                        seconds, entity(actor))));
}

std::string ScenarioText::begin(std::size_t actor, const Course& course) const {
  switch (course.start) {
    case CourseStart::at_once:
      break;
    case CourseStart::time_to_collision:
      return ttc_below(actor, number(course.value_s));
    case CourseStart::at_time:
      return condition_group(after(fmt::format("{} sets out", entity(actor)),
                                   number(course.value_s > 0 ? course.value_s : kAtStart)));
  }
  return at_start();
}

std::string ScenarioText::stop(std::string_view seconds, bool on_collision) const {
  std::string groups = condition_group(after("the test is over", seconds));
  for (std::size_t i = 1; on_collision && i < actors(); ++i) {
    if (!is_entity(i)) continue;
    groups += condition_group(
        by_av(fmt::format("collision with {}", entity(i)),
              fmt::format("<CollisionCondition><EntityRef entityRef=\"{}\"/></CollisionCondition>",
                          entity(i))));
  }
  if (dialect_ == ScenarioDialect::carla) {
    groups += condition_group(
        "<Condition name=\"criteria_CollisionTest\" delay=\"0\" conditionEdge=\"rising\">"
        "<ByValueCondition><ParameterCondition parameterRef=\"\" value=\"\" rule=\"lessThan\"/>"
        "</ByValueCondition></Condition>");
  }
  return groups;
}

std::string ScenarioText::box(const Actor& what, double ahead, double height) const {
  return fmt::format(
      "<BoundingBox><Center x=\"{:.4f}\" y=\"0\" z=\"{:.3f}\"/><Dimensions width=\"{:.4f}\" "
      "length=\"{:.4f}\" height=\"{:.3f}\"/></BoundingBox>",
      ahead, height / 2, what.width_m, what.length_m, height);
}

std::string ScenarioText::object(std::size_t actor) const {
  const Actor& what = recording_.actors()[actor];
  const bool carla = dialect_ == ScenarioDialect::carla;
  const std::string properties =
      actor == 0 && carla
          ? "<Properties><Property name=\"type\" value=\"ego_vehicle\"/></Properties>"
          : "<Properties/>";
  if (what.kind == ActorKind::pedestrian) {
    const std::string_view walker = carla ? "walker.pedestrian.0001" : "pedestrian";
    return fmt::format(
        "<ScenarioObject name=\"{}\"><Pedestrian name=\"{}\" model=\"{}\" mass=\"75\" "
        "pedestrianCategory=\"pedestrian\"><ParameterDeclarations/>{}{}</Pedestrian>"
        "</ScenarioObject>\n",
        entity(actor), walker, walker, box(what, 0, 1.8), properties);
  }
  const bool vehicle = what.kind == ActorKind::vehicle;
  const std::string_view model = carla
                                     ? (vehicle ? "vehicle.volkswagen.t2" : "vehicle.bh.crossbike")
                                 : vehicle ? "car"
                                           : "bicycle";
  const std::string body = vehicle ? box(what, what.length_m * kRearAxle, 1.5) : box(what, 0, 1.8);
  return fmt::format(
      "<ScenarioObject name=\"{}\"><Vehicle name=\"{}\" vehicleCategory=\"{}\">"
      "<ParameterDeclarations/>{}"
      "<Performance maxSpeed=\"70\" maxDeceleration=\"10\" maxAcceleration=\"10\"/><Axles>"
      "<FrontAxle maxSteering=\"0.5\" wheelDiameter=\"0.6\" trackWidth=\"{:.3f}\" "
      "positionX=\"{:.4f}\" positionZ=\"0.3\"/><RearAxle maxSteering=\"0\" wheelDiameter=\"0.6\" "
      "trackWidth=\"{:.3f}\" positionX=\"0\" positionZ=\"0.3\"/></Axles>{}</Vehicle>"
      "</ScenarioObject>\n",
      entity(actor), model, vehicle ? "car" : "bicycle", body, what.width_m * 0.9,
      what.length_m * 2 * kRearAxle, what.width_m * 0.9, properties);
}

std::string ScenarioText::init(std::size_t actor, const Vertex& at, std::string_view speed) const {
  return fmt::format(
      "<Private entityRef=\"{}\"><PrivateAction><TeleportAction>{}</TeleportAction>"
      "</PrivateAction><PrivateAction>{}</PrivateAction></Private>\n",
      entity(actor), world_position(at.x, at.y, at.heading), speed_action(speed));
}

void ScenarioText::add_obstacles(Parts& parts) const {
  const double cell = world_.cell_m;
  for (std::size_t i = 0; i < world_.obstacles.size(); ++i) {
    const Obstacle& each = world_.obstacles[i];
    const double length = each.cells.size() * cell - 2 * kClearance;
    const double width = each.rows.size() * cell - 2 * kClearance;
    const Actor what{fmt::format("obstacle{}", i + 1), ActorKind::vehicle, length, width};
    const std::string_view model =
        dialect_ == ScenarioDialect::carla ? "static.prop.container" : "obstacle";
    parts.entities += fmt::format(
        "<ScenarioObject name=\"{}\"><MiscObject name=\"{}\" miscObjectCategory=\"obstacle\" "
        "mass=\"1500\"><ParameterDeclarations/>{}<Properties/></MiscObject></ScenarioObject>\n",
        what.name, model, box(what, 0, 1.5));
    parts.init += fmt::format(
        "<Private entityRef=\"{}\"><PrivateAction><TeleportAction>{}</TeleportAction>"
        "</PrivateAction></Private>\n",
        what.name,
        world_position(number((each.rows.first + each.rows.last + 1) / 2.0 * cell),
                       number((each.cells.first + each.cells.last + 1) / 2.0 * cell),
                       fmt::format("{:.6f}", std::numbers::pi / 2)));
  }
}

std::string ScenarioText::signals(double stop_s) const {
  std::string text;
  for (const SignalGroup& each : plan_.signals) {
    std::string phases;
    double begin = 0;
    std::string colour = "green";
    const auto end_phase = [&](double end) {
      if (end <= begin) return;
      std::string states;
      for (const int id : each.signals) {
        states += fmt::format("<TrafficSignalState trafficSignalId=\"{}\" state=\"{}\"/>", id,
                              lights(colour));
      }
      phases += fmt::format("<Phase name=\"{}\" duration=\"{:.4f}\">{}</Phase>\n", colour,
                            end - begin, states);
      begin = end;
    };
    for (const RecordedEvent& event : recording_.events()) {
      if (event.kind != "signal" || !event.actor) continue;
      if (recording_.actors()[*event.actor].name != each.name) continue;
      // A signal's new colour applies from the beginning of the tick.
      end_phase((event.tick - 1) * recording_.tick_s());
      colour = escaped_xml(event.text);
    }
    end_phase(std::max(stop_s, begin) + recording_.tick_s());
    text += fmt::format(
        "<TrafficSignalController name=\"{}\" delay=\"0\">\n{}</TrafficSignalController>\n",
        each.name, phases);
  }
  return text.empty() ? text : fmt::format("<TrafficSignals>\n{}</TrafficSignals>\n", text);
}

ScenarioText::Parts ScenarioText::played(const Courses& courses, bool reactive) const {
  Parts parts{.signals = signals(courses.stop_s), .stops = stop(number(courses.stop_s), reactive)};
  for (std::size_t i = 0; i < actors(); ++i) {
    if (!is_entity(i)) continue;
    const Course& course = courses.courses[i];
    const bool triggered = course.start != CourseStart::at_once;
    parts.entities += object(i);
    parts.init += init(i, vertex(i, course.points.front()), number(first_speed(course)));
    parts.groups += group(i, follow(i, vertices(i, course), triggered ? "relative" : "absolute"),
                          begin(i, course));
  }
  return parts;
}

std::string ScenarioText::trajectories(std::string_view description, const Courses& courses) const {
  return document(description, played(courses, false));
}

std::string ScenarioText::reactive(std::string_view description, const Courses& courses) const {
  return document(description, played(courses, true));
}

std::string ScenarioText::batch(std::string_view description, const BatchShape& shape,
                                const ParameterValues& defaults) const {
  Parts parts{.stops = stop("$Stop", true)};
  double stop_s = 0;
  for (const auto& [parameter, value] : defaults) {
    parts.declarations += fmt::format(
        "    <ParameterDeclaration name=\"{}\" parameterType=\"double\" value=\"{}\"/>\n",
        parameter, value);
    if (parameter == "Stop") stop_s = std::stod(value);
  }
  parts.signals = signals(stop_s);
  for (std::size_t i = 0; i < actors(); ++i) {
    if (!is_entity(i)) continue;
    parts.entities += object(i);
    const std::vector<Vertex> way = parameters(i, shape[i]);
    const auto reference = [&](std::string_view what) { return "$" + parameter(i, what); };
    std::string conditions =
        condition_group(after(fmt::format("{} sets out", entity(i)), reference("Time")));
    if (recording_.actors()[i].kind == ActorKind::pedestrian) {
      conditions += ttc_below(i, reference("Ttc"));
    }
    parts.init += init(i, way.front(), reference("V"));
    parts.groups += group(i, follow(i, way, "relative"), conditions);
  }
  return document(description, parts);
}

ParameterValues ScenarioText::values(const Courses& courses, const BatchShape& shape) const {
  ParameterValues result{{"Stop", number(courses.stop_s)}};
  for (std::size_t i = 0; i < actors(); ++i) {
    if (!is_entity(i)) continue;
    const Course& course = courses.courses[i];
    const auto add = [&](std::string_view what, std::string value) {
      result.emplace_back(parameter(i, what), std::move(value));
    };
    const bool by_ttc = course.start == CourseStart::time_to_collision;
    const bool at_time = course.start == CourseStart::at_time && course.value_s > 0;
    add("Time", number(by_ttc ? kNever : at_time ? course.value_s : kAtStart));
    // Below 0 no time to collision is.
    if (recording_.actors()[i].kind == ActorKind::pedestrian) {
      add("Ttc", number(by_ttc ? course.value_s : -1));
    }
    add("V", number(first_speed(course)));
    std::vector<Vertex> way = vertices(i, course);
    // An actor with fewer waypoints than the longest course stands at its last one.
    double time = course.points.back().time_s;
    while (way.size() < shape[i]) {
      way.push_back(way.back());
      way.back().time = number(time += recording_.tick_s());
    }
    for (std::size_t k = 0; k < way.size(); ++k) {
      add(fmt::format("T{}", k), way[k].time);
      add(fmt::format("X{}", k), way[k].x);
      add(fmt::format("Y{}", k), way[k].y);
      add(fmt::format("H{}", k), way[k].heading);
    }
  }
  return result;
}

std::string ScenarioText::document(std::string_view description, const Parts& parts) const {
  Parts all = parts;
  add_obstacles(all);
  const std::string start = at_start();
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenSCENARIO>\n"
      "<FileHeader revMajor=\"1\" revMinor=\"0\" date=\"2020-01-01T00:00:00\" "
      "description=\"{}\" author=\"jaywalk\"/>\n"
      "<ParameterDeclarations>\n{}</ParameterDeclarations>\n<CatalogLocations/>\n"
      "<RoadNetwork><LogicFile filepath=\"road.xodr\"/>{}</RoadNetwork>\n"
      "<Entities>\n{}</Entities>\n<Storyboard>\n<Init><Actions>\n{}</Actions></Init>\n"
      "<Story name=\"test\"><ParameterDeclarations/><Act name=\"test\">\n{}<StartTrigger>{}"
      "</StartTrigger></Act></Story>\n"
      "<StopTrigger>\n{}</StopTrigger>\n</Storyboard>\n</OpenSCENARIO>\n",
      description, all.declarations, all.signals, all.entities, all.init, all.groups, start,
      all.stops);
}

}  // namespace jaywalk

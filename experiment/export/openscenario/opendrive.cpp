// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "experiment/export/openscenario/road_plan.h"

namespace jaywalk {
namespace {

std::string_view name(LaneType type) {
  switch (type) {
    case LaneType::driving:
      return "driving";
    case LaneType::sidewalk:
      return "sidewalk";
    case LaneType::none:
      return "none";
  }
  return "none";
}

struct ObjectLook {
  std::string_view type;
  double height_m;
};

ObjectLook look(ObjectType type) {
  switch (type) {
    case ObjectType::crosswalk:
      return {"crosswalk", 0};
    case ObjectType::obstacle:
      return {"obstacle", 1.5};
    case ObjectType::building:
      return {"building", 8};
  }
  return {"none", 0};
}

std::string lane(int id, const PlannedLane& lane) {
  return fmt::format(
      "            <lane id=\"{}\" type=\"{}\" level=\"false\">\n"
      "              <width sOffset=\"0\" a=\"{:.4f}\" b=\"0\" c=\"0\" d=\"0\"/>\n"
      "              <roadMark sOffset=\"0\" type=\"solid\" weight=\"standard\" color=\"white\" "
      "width=\"0.12\"/>\n"
      "            </lane>\n",
      id, name(lane.type), lane.width_m);
}

std::string side(std::string_view name, const std::string& lanes) {
  if (lanes.empty()) return {};
  return fmt::format("          <{0}>\n{1}          </{0}>\n", name, lanes);
}

std::string centre(std::string_view mark) {
  return fmt::format(
      "          <center>\n"
      "            <lane id=\"0\" type=\"none\" level=\"false\">\n"
      "              <roadMark sOffset=\"0\" type=\"{}\" weight=\"standard\" color=\"white\" "
      "width=\"0.12\"/>\n"
      "            </lane>\n"
      "          </center>\n",
      mark);
}

// From left to right the ids fall.
std::string lanes_of(const PlannedRoad& road) {
  std::string left;
  std::string right;
  for (std::size_t i = 0; i < road.lanes.size(); ++i) {
    (i < road.left ? left : right) += lane(lane_id(road, i), road.lanes[i]);
  }
  return fmt::format(
      "    <lanes>\n      <laneSection s=\"0\">\n{}{}{}      </laneSection>\n    </lanes>\n",
      side("left", left), centre("broken"), side("right", right));
}

std::string link(const PlannedRoad& road) {
  const auto end = [](std::string_view name, std::optional<int> junction) {
    if (!junction) return std::string();
    return fmt::format("      <{} elementType=\"junction\" elementId=\"{}\"/>\n", name, *junction);
  };
  if (!road.from && !road.to) return {};
  return fmt::format("    <link>\n{}{}    </link>\n", end("predecessor", road.from),
                     end("successor", road.to));
}

std::string object(const PlannedRoad& road, const PlannedObject& object, int id, double cell_m) {
  const double begin = object.cells.first * cell_m - road.y_m;
  const double length = object.cells.size() * cell_m;
  const double left = road.x_m - object.rows.first * cell_m;
  const double width = object.rows.size() * cell_m;
  // The origin has to lie on the road, the outline need not.
  const double s = std::clamp(begin + length / 2, 0.0, road.length_m);
  const double t = left - width / 2;
  const ObjectLook as = look(object.type);
  std::string corners;
  int corner = 0;
  const auto add = [&](double u, double v) {
    corners += fmt::format(
        "            <cornerLocal id=\"{}\" u=\"{:.4f}\" v=\"{:.4f}\" z=\"0\" height=\"{}\"/>\n",
        corner++, u, v, as.height_m);
  };
  add(begin - s, -width / 2);
  add(begin - s + length, -width / 2);
  add(begin - s + length, width / 2);
  add(begin - s, width / 2);
  return fmt::format(
      "      <object type=\"{}\" id=\"{}\" name=\"{}\" s=\"{:.4f}\" t=\"{:.4f}\" zOffset=\"0\" "
      "orientation=\"none\" length=\"{:.4f}\" width=\"{:.4f}\" height=\"{}\" hdg=\"0\" "
      "pitch=\"0\" roll=\"0\">\n"
      "        <outlines>\n          <outline id=\"0\" outer=\"true\" closed=\"true\">\n"
      "{}          </outline>\n        </outlines>\n      </object>\n",
      as.type, id, object.name, s, t, length, width, as.height_m, corners);
}

std::string signals_of(const PlannedRoad& road) {
  std::string text;
  for (const PlannedSignal& each : road.signals) {
    text += fmt::format(
        "      <signal s=\"{:.4f}\" t=\"{:.4f}\" id=\"{}\" name=\"{}\" dynamic=\"yes\" "
        "orientation=\"{}\" zOffset=\"2.5\" country=\"OpenDRIVE\" type=\"1000001\" "
        "subtype=\"-1\" height=\"0.9\" width=\"0.3\"/>\n",
        each.s_m, each.t_m, each.id, each.name, each.forward ? "+" : "-");
  }
  return text.empty() ? text : fmt::format("    <signals>\n{}    </signals>\n", text);
}

std::string road_of(const PlannedRoad& road, double cell_m, int& objects) {
  std::string things;
  for (const PlannedObject& each : road.objects) things += object(road, each, ++objects, cell_m);
  if (!things.empty()) things = fmt::format("    <objects>\n{}    </objects>\n", things);
  return fmt::format(
      "  <road name=\"{}\" length=\"{:.4f}\" id=\"{}\" junction=\"-1\" rule=\"LHT\">\n"
      "{}"
      "    <planView>\n"
      "      <geometry s=\"0\" x=\"{:.4f}\" y=\"{:.4f}\" hdg=\"{:.12f}\" length=\"{:.4f}\">"
      "<line/></geometry>\n"
      "    </planView>\n{}{}{}  </road>\n",
      road.name, road.length_m, road.id, link(road), road.x_m, road.y_m, road.heading_rad,
      road.length_m, lanes_of(road), things, signals_of(road));
}

/// A cubic curve from one lane's end to the other's, with their headings, in the coordinates of the
/// first: u = bu p + cu p^2 + du p^3 and so v, for p from 0 to 1.
struct Curve {
  double bu = 0;
  double cu = 0;
  double du = 0;
  double cv = 0;
  double dv = 0;
  double length_m = 0;
};

Curve curve(const LaneEnd& from, const LaneEnd& to) {
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  const double c = std::cos(from.heading_rad);
  const double s = std::sin(from.heading_rad);
  const double u = dx * c + dy * s;
  const double v = dy * c - dx * s;
  const double turn = to.heading_rad - from.heading_rad;
  const double pull = std::hypot(u, v);
  Curve result{.bu = pull,
               .cu = 3 * u - pull * (2 + std::cos(turn)),
               .du = pull * (1 + std::cos(turn)) - 2 * u,
               .cv = 3 * v - pull * std::sin(turn),
               .dv = pull * std::sin(turn) - 2 * v};
  constexpr int kParts = 1000;
  double last_u = 0;
  double last_v = 0;
  for (int i = 1; i <= kParts; ++i) {
    const double p = static_cast<double>(i) / kParts;
    const double at_u = p * (result.bu + p * (result.cu + p * result.du));
    const double at_v = p * p * (result.cv + p * result.dv);
    result.length_m += std::hypot(at_u - last_u, at_v - last_v);
    last_u = at_u;
    last_v = at_v;
  }
  return result;
}

// One lane, with its middle on the reference line.
std::string connecting_road(int junction, const Connection& way) {
  const Curve shape = curve(way.from, way.to);
  const double growth = (way.to.width_m - way.from.width_m) / shape.length_m;
  const auto contact = [](const LaneEnd& end) { return end.at_end ? "end" : "start"; };
  return fmt::format(
      "  <road name=\"road {0} to {1}\" length=\"{2:.4f}\" id=\"{3}\" junction=\"{4}\" "
      "rule=\"LHT\">\n"
      "    <link>\n"
      "      <predecessor elementType=\"road\" elementId=\"{0}\" contactPoint=\"{5}\"/>\n"
      "      <successor elementType=\"road\" elementId=\"{1}\" contactPoint=\"{6}\"/>\n"
      "    </link>\n"
      "    <planView>\n"
      "      <geometry s=\"0\" x=\"{7:.4f}\" y=\"{8:.4f}\" hdg=\"{9:.12f}\" length=\"{2:.4f}\">"
      "<paramPoly3 pRange=\"normalized\" aU=\"0\" bU=\"{10:.6f}\" cU=\"{11:.6f}\" dU=\"{12:.6f}\" "
      "aV=\"0\" bV=\"0\" cV=\"{13:.6f}\" dV=\"{14:.6f}\"/></geometry>\n"
      "    </planView>\n"
      "    <lanes>\n"
      "      <laneOffset s=\"0\" a=\"{15:.4f}\" b=\"{16:.6f}\" c=\"0\" d=\"0\"/>\n"
      "      <laneSection s=\"0\">\n"
      "          <left>\n"
      "            <lane id=\"1\" type=\"driving\" level=\"false\">\n"
      "              <link><predecessor id=\"{17}\"/><successor id=\"{18}\"/></link>\n"
      "              <width sOffset=\"0\" a=\"{19:.4f}\" b=\"{20:.6f}\" c=\"0\" d=\"0\"/>\n"
      "            </lane>\n"
      "          </left>\n{21}"
      "      </laneSection>\n"
      "    </lanes>\n  </road>\n",
      way.from.road, way.to.road, shape.length_m, way.road, junction, contact(way.from),
      contact(way.to), way.from.x_m, way.from.y_m, way.from.heading_rad, shape.bu, shape.cu,
      shape.du, shape.cv, shape.dv, -way.from.width_m / 2, -growth / 2, way.from.lane, way.to.lane,
      way.from.width_m, growth, centre("none"));
}

std::string junction_of(const PlannedJunction& junction) {
  std::string text = fmt::format("  <junction id=\"{0}\" name=\"junction {0}\">\n", junction.id);
  for (std::size_t i = 0; i < junction.connections.size(); ++i) {
    const Connection& each = junction.connections[i];
    text += fmt::format(
        "    <connection id=\"{}\" incomingRoad=\"{}\" connectingRoad=\"{}\" "
        "contactPoint=\"start\">\n"
        "      <laneLink from=\"{}\" to=\"1\"/>\n    </connection>\n",
        i, each.from.road, each.road, each.from.lane);
  }
  return text + "  </junction>\n";
}

std::string controller_of(const SignalGroup& group) {
  std::string controls;
  for (const int id : group.signals) {
    controls += fmt::format("    <control signalId=\"{}\" type=\"0\"/>\n", id);
  }
  return fmt::format("  <controller id=\"{}\" name=\"{}\">\n{}  </controller>\n", group.id,
                     group.name, controls);
}

}  // namespace

std::string to_opendrive(const RoadPlan& plan, double cell_m) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<OpenDRIVE>\n"
      "  <header revMajor=\"1\" revMinor=\"6\" name=\"jaywalk crossing\" version=\"1\" "
      "north=\"{:.4f}\" south=\"0\" east=\"{:.4f}\" west=\"0\"/>\n",
      plan.length_m, plan.width_m);
  int objects = 0;
  for (const PlannedRoad& road : plan.roads) text += road_of(road, cell_m, objects);
  for (const PlannedJunction& junction : plan.junctions) {
    for (const Connection& way : junction.connections) text += connecting_road(junction.id, way);
  }
  for (const SignalGroup& group : plan.signals) text += controller_of(group);
  for (const PlannedJunction& junction : plan.junctions) text += junction_of(junction);
  return text + "</OpenDRIVE>\n";
}

}  // namespace jaywalk

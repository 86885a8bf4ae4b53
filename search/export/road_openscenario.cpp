// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "env/lane/drive.h"
#include "search/export/exports.h"

namespace jaywalk::search {
namespace {

/// OpenSCENARIO's reference point is the middle of the rear axle on the ground.
std::string vehicle(const lane::DriveSettings& drive) {
  const lane::VehicleParameters& car = drive.vehicle;
  return fmt::format(
      "    <ScenarioObject name=\"Ego\">\n"
      "      <Vehicle name=\"car\" vehicleCategory=\"car\">\n"
      "        <ParameterDeclarations/>\n"
      "        <BoundingBox>\n"
      "          <Center x=\"{:.4g}\" y=\"0\" z=\"0.75\"/>\n"
      "          <Dimensions width=\"{}\" length=\"{}\" height=\"1.5\"/>\n"
      "        </BoundingBox>\n"
      "        <Performance maxSpeed=\"{:.6g}\" maxAcceleration=\"{}\" maxDeceleration=\"10\"/>\n"
      "        <Axles>\n"
      "          <FrontAxle maxSteering=\"{}\" wheelDiameter=\"0.65\" trackWidth=\"1.6\" "
      "positionX=\"{:.5g}\" positionZ=\"0.325\"/>\n"
      "          <RearAxle maxSteering=\"0\" wheelDiameter=\"0.65\" trackWidth=\"1.6\" "
      "positionX=\"0\" positionZ=\"0.325\"/>\n"
      "        </Axles>\n        <Properties/>\n      </Vehicle>\n    </ScenarioObject>\n",
      car.rear_axle_m, car.width_m, car.length_m, drive.speed_limit_mps, car.most_acceleration,
      car.most_steering_rad, car.wheelbase_m());
}

std::string lane_position(double s) {
  return fmt::format(
      "<Position><LanePosition roadId=\"1\" laneId=\"-1\" offset=\"0\" s=\"{:.6g}\"/></Position>",
      s);
}

/// Nothing is later than 0 at the start yet: for the start, a little before.
std::string later_than(std::string_view name, double seconds) {
  return fmt::format(
      "<ConditionGroup><Condition name=\"{}\" delay=\"0\" conditionEdge=\"none\">"
      "<ByValueCondition><SimulationTimeCondition value=\"{:.6g}\" rule=\"greaterThan\"/>"
      "</ByValueCondition></Condition></ConditionGroup>",
      name, seconds);
}

/// From standing it accelerates as the car of env/lane can, up to the parameter SpeedLimit.
std::string story(const lane::DriveSettings& drive) {
  return fmt::format(
      "    <Story name=\"drive\">\n      <Act name=\"drive\">\n"
      "        <ManeuverGroup name=\"drive\" maximumExecutionCount=\"1\">\n"
      "          <Actors selectTriggeringEntities=\"false\"><EntityRef "
      "entityRef=\"Ego\"/></Actors>\n"
      "          <Maneuver name=\"drive\">\n"
      "            <Event name=\"set out\" priority=\"overwrite\" maximumExecutionCount=\"1\">\n"
      "              <Action name=\"accelerate to the speed limit\">\n"
      "                <PrivateAction><LongitudinalAction><SpeedAction>\n"
      "                  <SpeedActionDynamics dynamicsShape=\"linear\" value=\"{:.6g}\" "
      "dynamicsDimension=\"rate\"/>\n"
      "                  <SpeedActionTarget><AbsoluteTargetSpeed value=\"$SpeedLimit\"/>"
      "</SpeedActionTarget>\n"
      "                </SpeedAction></LongitudinalAction></PrivateAction>\n"
      "              </Action>\n              <StartTrigger>{}</StartTrigger>\n"
      "            </Event>\n          </Maneuver>\n        </ManeuverGroup>\n"
      "        <StartTrigger>{}</StartTrigger>\n      </Act>\n    </Story>\n",
      drive.vehicle.most_acceleration, later_than("at the start", -0.001),
      later_than("at the start", -0.001));
}

}  // namespace

std::string to_openscenario(const lane::Polyline& points, std::string_view road_file,
                            const lane::DriveSettings& drive) {
  const double length = lane::length(lane::interpolate(points).value_or(points));
  const double goal = length - 1;
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenSCENARIO>\n"
      "  <FileHeader revMajor=\"1\" revMinor=\"0\" date=\"2022-01-01T00:00:00\" "
      "description=\"drive to the end of the road without leaving the right lane\" "
      "author=\"jaywalk\"/>\n"
      "  <ParameterDeclarations>\n"
      "    <ParameterDeclaration name=\"SpeedLimit\" parameterType=\"double\" value=\"{0:.6g}\"/>\n"
      "  </ParameterDeclarations>\n"
      "  <CatalogLocations/>\n"
      "  <RoadNetwork>\n    <LogicFile filepath=\"{1}\"/>\n  </RoadNetwork>\n"
      "  <Entities>\n{2}  </Entities>\n"
      "  <Storyboard>\n    <Init>\n      <Actions>\n        <Private entityRef=\"Ego\">\n"
      "          <PrivateAction><TeleportAction>{3}</TeleportAction></PrivateAction>\n"
      "          <PrivateAction><RoutingAction><AcquirePositionAction>{4}"
      "</AcquirePositionAction></RoutingAction></PrivateAction>\n"
      "        </Private>\n      </Actions>\n    </Init>\n{6}"
      "    <StopTrigger>\n      <ConditionGroup>\n"
      "        <Condition name=\"arrived\" delay=\"0\" conditionEdge=\"none\">\n"
      "          <ByEntityCondition>\n"
      "            <TriggeringEntities triggeringEntitiesRule=\"any\">"
      "<EntityRef entityRef=\"Ego\"/></TriggeringEntities>\n"
      "            <EntityCondition><ReachPositionCondition tolerance=\"{5}\">{4}"
      "</ReachPositionCondition></EntityCondition>\n"
      "          </ByEntityCondition>\n        </Condition>\n      </ConditionGroup>\n"
      "      {7}\n    </StopTrigger>\n"
      "  </Storyboard>\n</OpenSCENARIO>\n",
      drive.speed_limit_mps, road_file, vehicle(drive), lane_position(drive.start_m),
      lane_position(goal), drive.goal_m, story(drive), later_than("time is over", drive.most_s));
}

}  // namespace jaywalk::search

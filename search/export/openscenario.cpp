#include <fmt/format.h>

#include "env/lane/drive.h"
#include "search/export/exports.h"

namespace jaywalk::search {
namespace {

/// The car of env/lane; OpenSCENARIO's reference point is the middle of the rear axle on the
/// ground.
std::string vehicle() {
  const lane::VehicleParameters car;
  return fmt::format(
      "    <ScenarioObject name=\"Ego\">\n"
      "      <Vehicle name=\"car\" vehicleCategory=\"car\">\n"
      "        <ParameterDeclarations/>\n"
      "        <BoundingBox>\n"
      "          <Center x=\"{:.4g}\" y=\"0\" z=\"0.75\"/>\n"
      "          <Dimensions width=\"{}\" length=\"{}\" height=\"1.5\"/>\n"
      "        </BoundingBox>\n"
      "        <Performance maxSpeed=\"83.3\" maxAcceleration=\"{}\" maxDeceleration=\"10\"/>\n"
      "        <Axles>\n"
      "          <FrontAxle maxSteering=\"{}\" wheelDiameter=\"0.65\" trackWidth=\"1.6\" "
      "positionX=\"{:.5g}\" positionZ=\"0.325\"/>\n"
      "          <RearAxle maxSteering=\"0\" wheelDiameter=\"0.65\" trackWidth=\"1.6\" "
      "positionX=\"0\" positionZ=\"0.325\"/>\n"
      "        </Axles>\n        <Properties/>\n      </Vehicle>\n    </ScenarioObject>\n",
      car.rear_axle_m, car.width_m, car.length_m, car.most_acceleration, car.most_steering_rad,
      car.wheelbase_m());
}

std::string lane_position(double s) {
  return fmt::format(
      "<Position><LanePosition roadId=\"1\" laneId=\"-1\" offset=\"0\" s=\"{:.6g}\"/></Position>",
      s);
}

}  // namespace

std::string to_openscenario(const lane::Polyline& points, std::string_view road_file,
                            double speed_limit_mps) {
  const lane::DriveSettings defaults;
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
      "        </Private>\n      </Actions>\n    </Init>\n"
      "    <StopTrigger>\n      <ConditionGroup>\n"
      "        <Condition name=\"arrived\" delay=\"0\" conditionEdge=\"none\">\n"
      "          <ByEntityCondition>\n"
      "            <TriggeringEntities triggeringEntitiesRule=\"any\">"
      "<EntityRef entityRef=\"Ego\"/></TriggeringEntities>\n"
      "            <EntityCondition><ReachPositionCondition tolerance=\"{5}\">{4}"
      "</ReachPositionCondition></EntityCondition>\n"
      "          </ByEntityCondition>\n        </Condition>\n      </ConditionGroup>\n"
      "      <ConditionGroup>\n"
      "        <Condition name=\"time is over\" delay=\"0\" conditionEdge=\"none\">\n"
      "          <ByValueCondition><SimulationTimeCondition value=\"{6}\" rule=\"greaterThan\"/>"
      "</ByValueCondition>\n"
      "        </Condition>\n      </ConditionGroup>\n    </StopTrigger>\n"
      "  </Storyboard>\n</OpenSCENARIO>\n",
      speed_limit_mps, road_file, vehicle(), lane_position(defaults.start_m), lane_position(goal),
      defaults.goal_m, defaults.most_s);
}

}  // namespace jaywalk::search

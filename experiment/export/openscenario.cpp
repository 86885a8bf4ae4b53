// Tests as ASAM OpenSCENARIO XML. Only what is valid in all of 1.0 to 1.3 is written, with 1.0 in
// the header, since some players refuse other minors; the parameter values of a batch came
// with 1.1. For each test:
//
//   STEM.xosc           every actor on its trajectory, at every tick where it was
//   STEM-reactive.xosc  the AV keeps its speed; each pedestrian steps out when the AV's time to
//                       collision with it falls to what it was in the test
//
// and for each behaviour and number of agents `…-batch.xosc`, the reactive scenario with
// parameters, and `…-batch-values.xosc`, a set of values for each test. The road is `road.xodr`.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "experiment/export/exporters.h"
#include "experiment/export/opendrive.h"

namespace jaywalk {
namespace {

/// The reference point of a vehicle is the middle of its rear axle, this share of its length behind
/// its middle.
constexpr double kRearAxle = 0.3;

/// When and where a pedestrian sets out across the road, and how.
struct StepOut {
  double ttc_s = 0;  // the AV's time to come to where the pedestrian crosses its way
  std::size_t tick = 0;
  std::size_t last = 0;  // the tick in which it comes to rest, or the test ends
};

std::optional<StepOut> step_out(const Recording& recording, std::size_t actor) {
  for (std::size_t tick = 0; tick + 1 < recording.scenes(); ++tick) {
    const ActorState& here = recording.scene(tick)[actor];
    if (std::abs(recording.scene(tick + 1)[actor].x_m - here.x_m) < 1e-9) continue;
    const ActorState& av = recording.scene(tick)[0];
    const double gap = here.y_m - av.y_m - recording.actors()[0].length_m / 2;
    if (gap <= 0 || av.speed_mps <= 0) return std::nullopt;
    std::size_t last = tick + 1;
    while (last + 1 < recording.scenes() &&
           recording.scene(last + 1)[actor].x_m != recording.scene(last)[actor].x_m) {
      ++last;
    }
    return StepOut{gap / av.speed_mps, tick, last};
  }
  return std::nullopt;
}

class Writer {
 public:
  Writer(const Recording& recording, ScenarioDialect dialect)
      : recording_(recording), dialect_(dialect) {}

  [[nodiscard]] std::string trajectories(std::string_view description) const {
    std::string events;
    for (std::size_t i = 0; i < recording_.actors().size(); ++i) {
      if (is_entity(i)) events += group(i, follow(i, 0, end(), "absolute"), at_start());
    }
    return document(description, "", events, stop(false));
  }

  [[nodiscard]] std::string reactive(std::string_view description) const {
    std::string events = group(0, keep_speed(), at_start());
    for (std::size_t i = 1; i < recording_.actors().size(); ++i) {
      const std::optional<StepOut> out = step_out(recording_, i);
      if (!is_entity(i) || !out) continue;
      events += group(i, follow(i, out->tick, out->last, "relative"),
                      ttc_below(i, fmt::format("{:.4f}", out->ttc_s)));
    }
    return document(description, "", events, stop(true));
  }

  /// The reactive scenario whose numbers are parameters, with this test's as their defaults.
  [[nodiscard]] std::string batch(std::string_view description) const {
    std::string declarations;
    for (const auto& [parameter, value] : values()) {
      declarations += fmt::format(
          "    <ParameterDeclaration name=\"{}\" parameterType=\"double\" value=\"{}\"/>\n",
          parameter, value);
    }
    std::string events = group(0, keep_speed(), at_start());
    for (std::size_t i = 1; i < recording_.actors().size(); ++i) {
      if (is_entity(i)) events += group(i, walk(i), ttc_below(i, reference(i, "Ttc")));
    }
    return document(description, declarations, events, stop(true), Places::parameters);
  }

  [[nodiscard]] std::vector<std::pair<std::string, std::string>> values() const {
    std::vector<std::pair<std::string, std::string>> result;
    for (std::size_t i = 1; i < recording_.actors().size(); ++i) {
      if (!is_entity(i)) continue;
      const std::optional<StepOut> out = step_out(recording_, i);
      const StepOut still{.ttc_s = -1, .tick = 0, .last = 0};
      const StepOut& step = out ? *out : still;
      const ActorState& from = recording_.scene(step.tick)[i];
      const ActorState& to = recording_.scene(step.last)[i];
      const auto add = [&](std::string_view what, double value) {
        result.emplace_back(parameter(i, what), fmt::format("{:.4f}", value));
      };
      add("X", from.x_m);
      add("Y", from.y_m);
      add("H", recording_.scene(std::min(step.tick + 1, end()))[i].heading_rad);
      add("EndX", to.x_m);
      add("EndY", to.y_m);
      add("Duration", std::max(static_cast<double>(step.last - step.tick) * recording_.tick_s(),
                               recording_.tick_s()));
      // Below 0 it never steps out.
      add("Ttc", step.ttc_s);
    }
    return result;
  }

 private:
  enum class Places { recorded, parameters };

  [[nodiscard]] std::size_t end() const { return recording_.scenes() - 1; }
  [[nodiscard]] bool is_entity(std::size_t actor) const {
    return recording_.actors()[actor].kind != ActorKind::signal;
  }
  [[nodiscard]] std::string entity(std::size_t actor) const {
    if (actor == 0 && dialect_ == ScenarioDialect::carla) return "hero";
    return recording_.actors()[actor].name;
  }
  [[nodiscard]] std::string parameter(std::size_t actor, std::string_view what) const {
    return fmt::format("{}_{}", recording_.actors()[actor].name, what);
  }
  [[nodiscard]] std::string reference(std::size_t actor, std::string_view what) const {
    return "$" + parameter(actor, what);
  }

  static std::string world_position(std::string_view x, std::string_view y, std::string_view h) {
    return fmt::format(
        "<Position><WorldPosition x=\"{}\" y=\"{}\" z=\"0\" h=\"{}\" p=\"0\" r=\"0\"/></Position>",
        x, y, h);
  }

  [[nodiscard]] std::string position(std::size_t actor, std::size_t tick) const {
    const ActorState& state = recording_.scene(tick)[actor];
    const bool vehicle = recording_.actors()[actor].kind == ActorKind::vehicle;
    const double back = vehicle ? recording_.actors()[actor].length_m * kRearAxle : 0;
    return world_position(fmt::format("{:.4f}", state.x_m - back * std::cos(state.heading_rad)),
                          fmt::format("{:.4f}", state.y_m - back * std::sin(state.heading_rad)),
                          fmt::format("{:.6f}", state.heading_rad));
  }

  static std::string following(std::string_view name, std::string_view vertices,
                               std::string_view timing) {
    return fmt::format(
        "<RoutingAction><FollowTrajectoryAction>\n"
        "<Trajectory name=\"{}\" closed=\"false\"><ParameterDeclarations/><Shape><Polyline>\n{}"
        "</Polyline></Shape></Trajectory>\n"
        "<TimeReference><Timing domainAbsoluteRelative=\"{}\" scale=\"1\" offset=\"0\"/>"
        "</TimeReference>\n<TrajectoryFollowingMode followingMode=\"position\"/>\n"
        "</FollowTrajectoryAction></RoutingAction>",
        name, vertices, timing);
  }

  // Standing still is a vertex repeated at a later time, so that each tick has its place.
  [[nodiscard]] std::string follow(std::size_t actor, std::size_t from, std::size_t to,
                                   std::string_view timing) const {
    std::string vertices;
    for (std::size_t tick = from; tick <= to; ++tick) {
      vertices += fmt::format("<Vertex time=\"{:.4f}\">{}</Vertex>\n",
                              static_cast<double>(tick - from) * recording_.tick_s(),
                              position(actor, tick));
    }
    return following(entity(actor) + " way", vertices, timing);
  }

  [[nodiscard]] std::string walk(std::size_t actor) const {
    const auto at = [&](std::string_view x, std::string_view y) {
      return world_position(reference(actor, x), reference(actor, y), reference(actor, "H"));
    };
    return following(
        entity(actor) + " way",
        fmt::format("<Vertex time=\"0\">{}</Vertex>\n<Vertex time=\"{}\">{}</Vertex>\n",
                    at("X", "Y"), reference(actor, "Duration"), at("EndX", "EndY")),
        "relative");
  }

  [[nodiscard]] std::string speed_of(std::size_t actor) const {
    return fmt::format(
        "<LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape=\"step\" value=\"0\" "
        "dynamicsDimension=\"time\"/><SpeedActionTarget><AbsoluteTargetSpeed value=\"{:.4f}\"/>"
        "</SpeedActionTarget></SpeedAction></LongitudinalAction>",
        recording_.scene(0)[actor].speed_mps);
  }
  [[nodiscard]] std::string keep_speed() const { return speed_of(0); }

  [[nodiscard]] std::string group(std::size_t actor, std::string_view action,
                                  std::string_view condition) const {
    const std::string name = entity(actor);
    return fmt::format(
        "<ManeuverGroup maximumExecutionCount=\"1\" name=\"{0} group\">\n"
        "<Actors selectTriggeringEntities=\"false\"><EntityRef entityRef=\"{0}\"/></Actors>\n"
        "<Maneuver name=\"{0} maneuver\"><Event name=\"{0} event\" priority=\"overwrite\" "
        "maximumExecutionCount=\"1\">\n"
        "<Action name=\"{0} action\"><PrivateAction>{1}</PrivateAction></Action>\n"
        "<StartTrigger><ConditionGroup>{2}</ConditionGroup></StartTrigger>\n"
        "</Event></Maneuver></ManeuverGroup>\n",
        name, action, condition);
  }

  static std::string after(std::string_view name, double seconds) {
    return fmt::format(
        "<Condition name=\"{}\" delay=\"0\" conditionEdge=\"none\"><ByValueCondition>"
        "<SimulationTimeCondition value=\"{:.4f}\" rule=\"greaterThan\"/></ByValueCondition>"
        "</Condition>",
        name, seconds);
  }
  // At time 0 nothing is greater than 0 yet: a little before.
  static std::string at_start() { return after("at the start", -0.001); }

  [[nodiscard]] std::string by_av(std::string_view name, std::string_view condition) const {
    return fmt::format(
        "<Condition name=\"{}\" delay=\"0\" conditionEdge=\"none\"><ByEntityCondition>"
        "<TriggeringEntities triggeringEntitiesRule=\"any\"><EntityRef entityRef=\"{}\"/>"
        "</TriggeringEntities><EntityCondition>{}</EntityCondition></ByEntityCondition></"
        "Condition>",
        name, entity(0), condition);
  }

  // Time to the place where the pedestrian stands: the vehicle need not be on its way to hit it
  // yet. 1.0 demands alongRoute; later versions still take it.
  [[nodiscard]] std::string ttc_below(std::size_t actor, std::string_view seconds) const {
    return by_av(fmt::format("the AV comes to {}", entity(actor)),
                 fmt::format("<TimeToCollisionCondition value=\"{}\" freespace=\"true\" "
                             "alongRoute=\"false\" "
                             "rule=\"lessThan\"><TimeToCollisionConditionTarget><EntityRef "
                             "entityRef=\"{}\"/></TimeToCollisionConditionTarget>"
                             "</TimeToCollisionCondition>",
                             seconds, entity(actor)));
  }

  [[nodiscard]] std::string stop(bool on_collision) const {
    std::string groups =
        fmt::format("<ConditionGroup>{}</ConditionGroup>\n",
                    after("the test is over", static_cast<double>(end()) * recording_.tick_s()));
    for (std::size_t i = 1; on_collision && i < recording_.actors().size(); ++i) {
      if (!is_entity(i)) continue;
      groups += fmt::format(
          "<ConditionGroup>{}</ConditionGroup>\n",
          by_av(
              fmt::format("collision with {}", entity(i)),
              fmt::format("<CollisionCondition><EntityRef entityRef=\"{}\"/></CollisionCondition>",
                          entity(i))));
    }
    if (dialect_ == ScenarioDialect::carla) {
      groups +=
          "<ConditionGroup><Condition name=\"criteria_CollisionTest\" delay=\"0\" "
          "conditionEdge=\"rising\"><ByValueCondition><ParameterCondition parameterRef=\"\" "
          "value=\"\" rule=\"lessThan\"/></ByValueCondition></Condition></ConditionGroup>\n";
    }
    return groups;
  }

  [[nodiscard]] std::string object(std::size_t actor) const {
    const Actor& what = recording_.actors()[actor];
    const bool pedestrian = what.kind == ActorKind::pedestrian;
    const bool cyclist = what.kind == ActorKind::cyclist;
    const bool vehicle = what.kind == ActorKind::vehicle;
    const double ahead = vehicle ? what.length_m * kRearAxle : 0;
    const double height = vehicle ? 1.5 : 1.8;
    const std::string box = fmt::format(
        "<BoundingBox><Center x=\"{:.4f}\" y=\"0\" z=\"{:.3f}\"/><Dimensions width=\"{:.4f}\" "
        "length=\"{:.4f}\" height=\"{:.3f}\"/></BoundingBox>",
        ahead, height / 2, what.width_m, what.length_m, height);
    const std::string properties =
        actor == 0 && dialect_ == ScenarioDialect::carla
            ? "<Properties><Property name=\"type\" value=\"ego_vehicle\"/></Properties>"
            : "<Properties/>";
    if (pedestrian) {
      return fmt::format(
          "<ScenarioObject name=\"{}\"><Pedestrian name=\"{}\" model=\"{}\" mass=\"75\" "
          "pedestrianCategory=\"pedestrian\"><ParameterDeclarations/>{}{}</Pedestrian>"
          "</ScenarioObject>\n",
          entity(actor), walker_name(), walker_name(), box, properties);
    }
    return fmt::format(
        "<ScenarioObject name=\"{}\"><Vehicle name=\"{}\" vehicleCategory=\"{}\">"
        "<ParameterDeclarations/>{}"
        "<Performance maxSpeed=\"70\" maxDeceleration=\"10\" maxAcceleration=\"10\"/><Axles>"
        "<FrontAxle maxSteering=\"0.5\" wheelDiameter=\"0.6\" trackWidth=\"{:.3f}\" "
        "positionX=\"{:.4f}\" positionZ=\"0.3\"/><RearAxle maxSteering=\"0\" wheelDiameter=\"0.6\" "
        "trackWidth=\"{:.3f}\" positionX=\"0\" positionZ=\"0.3\"/></Axles>{}</Vehicle>"
        "</ScenarioObject>\n",
        entity(actor), vehicle_name(cyclist), cyclist ? "bicycle" : "car", box, what.width_m * 0.9,
        what.length_m * 2 * kRearAxle, what.width_m * 0.9, properties);
  }

  [[nodiscard]] std::string walker_name() const {
    return dialect_ == ScenarioDialect::carla ? "walker.pedestrian.0001" : "pedestrian";
  }
  [[nodiscard]] std::string vehicle_name(bool bicycle) const {
    if (dialect_ == ScenarioDialect::carla) {
      return bicycle ? "vehicle.bh.crossbike" : "vehicle.volkswagen.t2";
    }
    return bicycle ? "bicycle" : "car";
  }

  [[nodiscard]] std::string init(std::size_t actor, Places places) const {
    const std::string where =
        places == Places::parameters && actor > 0
            ? world_position(reference(actor, "X"), reference(actor, "Y"), reference(actor, "H"))
            : position(actor, 0);
    return fmt::format(
        "<Private entityRef=\"{}\"><PrivateAction><TeleportAction>{}</TeleportAction>"
        "</PrivateAction><PrivateAction>{}</PrivateAction></Private>\n",
        entity(actor), where, speed_of(actor));
  }

  [[nodiscard]] std::string document(std::string_view description, std::string_view declarations,
                                     std::string_view groups, std::string_view stops,
                                     Places places = Places::recorded) const {
    std::string entities;
    std::string actions;
    for (std::size_t i = 0; i < recording_.actors().size(); ++i) {
      if (!is_entity(i)) continue;
      entities += object(i);
      actions += init(i, places);
    }
    const std::string story = groups.empty()
                                  ? ""
                                  : fmt::format(
                                        "<Story name=\"test\"><ParameterDeclarations/><Act "
                                        "name=\"test\">\n{}<StartTrigger><ConditionGroup>{}"
                                        "</ConditionGroup></StartTrigger></Act></Story>\n",
                                        groups, at_start());
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenSCENARIO>\n"
        "<FileHeader revMajor=\"1\" revMinor=\"0\" date=\"2020-01-01T00:00:00\" "
        "description=\"{}\" author=\"jaywalk\"/>\n"
        "<ParameterDeclarations>\n{}</ParameterDeclarations>\n<CatalogLocations/>\n"
        "<RoadNetwork><LogicFile filepath=\"road.xodr\"/></RoadNetwork>\n"
        "<Entities>\n{}</Entities>\n<Storyboard>\n<Init><Actions>\n{}</Actions></Init>\n{}"
        "<StopTrigger>\n{}</StopTrigger>\n</Storyboard>\n</OpenSCENARIO>\n",
        description, declarations, entities, actions, story, stops);
  }

  const Recording& recording_;
  ScenarioDialect dialect_;
};

/// The sets of values of one batch: OpenSCENARIO 1.1's parameter distribution.
std::string distribution(const std::string& scenario_file, const std::string& sets) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenSCENARIO>\n"
      "<FileHeader revMajor=\"1\" revMinor=\"1\" date=\"2020-01-01T00:00:00\" "
      "description=\"a set of values for each test\" author=\"jaywalk\"/>\n"
      "<ParameterValueDistribution><ScenarioFile filepath=\"{}\"/><Deterministic>"
      "<DeterministicMultiParameterDistribution><ValueSetDistribution>\n{}"
      "</ValueSetDistribution></DeterministicMultiParameterDistribution></Deterministic>"
      "</ParameterValueDistribution>\n</OpenSCENARIO>\n",
      scenario_file, sets);
}

std::string value_set(const Writer& writer) {
  std::string text = "<ParameterValueSet>\n";
  for (const auto& [name, value] : writer.values()) {
    text += fmt::format("<ParameterAssignment parameterRef=\"{}\" value=\"{}\"/>\n", name, value);
  }
  return text + "</ParameterValueSet>\n";
}

/// What the tests of one behaviour and number of agents have in common.
struct Batch {
  std::string scenario;
  std::string sets;
};

class Export {
 public:
  explicit Export(const ExportRequest& request) : request_(request) {}

  ExportedFiles run() {
    const auto prepared = request_.store.prepared();
    if (!prepared.ok()) return prepared.diagnostics();
    write("road.xodr", to_opendrive(prepared.value()->scenario().world));
    for (const StoredTest& test : request_.tests) {
      if (diagnostics_.has_errors()) break;
      const Result<Recording> recording = request_.store.recording(test.id);
      if (!recording.ok()) return recording.diagnostics();
      if (recording.value().scenes() > 0) write_test(test, recording.value());
    }
    for (const auto& [stem, batch] : batches_) {
      write(stem + "-batch.xosc", batch.scenario);
      write(stem + "-batch-values.xosc", distribution(stem + "-batch.xosc", batch.sets));
    }
    if (diagnostics_.has_errors()) return diagnostics_;
    return written_;
  }

 private:
  void write(const std::string& name, std::string_view text) {
    if (diagnostics_.has_errors()) return;
    (void)write_export(request_, name, text, written_, diagnostics_);
  }

  void write_test(const StoredTest& test, const Recording& recording) {
    const Writer writer(recording, request_.dialect);
    const std::string stem = file_stem(request_.store, test.test);
    write(stem + ".xosc", writer.trajectories(stem));
    write(stem + "-reactive.xosc", writer.reactive(stem + ", reactive"));
    const std::string& behaviour =
        request_.store.description().behaviours[test.test.behaviour].name;
    const std::string group = fmt::format("{}-{}", behaviour, test.test.agents);
    Batch& batch = batches_[group];
    if (batch.scenario.empty()) batch.scenario = writer.batch(group + ", all tests");
    batch.sets += value_set(writer);
  }

  const ExportRequest& request_;
  std::map<std::string, Batch> batches_;
  std::vector<std::string> written_;
  Diagnostics diagnostics_;
};

}  // namespace

ExportedFiles export_openscenario(const ExportRequest& request) { return Export(request).run(); }

}  // namespace jaywalk

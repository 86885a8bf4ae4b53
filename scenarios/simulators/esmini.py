#!/usr/bin/env python3
"""esmini moves the automated vehicle (AV): any of its controllers, on the scenario's own road.

Speaks the simulator protocol (docs/guides/own_simulator.md). Needs esmini's C library, version 3: its
path as an argument (command: [python3, simulators/esmini.py, /opt/esmini/bin/libesminiLib.so]), in
the environment variable ESMINI_LIB, or where the system looks for libraries. Options (`world.simulator.options`): `controller` (an esmini controller: ALKS_R157SM_Controller
unless given, ACCController, NaturalDriver, … or none, which keeps the speed), and any property
of that controller (`model: RSS`, `cruise: false`). The road and all actors are written as
OpenDRIVE and OpenSCENARIO for each test, in Jaywalk's axes.
"""
import ctypes
import ctypes.util
import json
import math
import os
import sys
import tempfile

MARGIN = 200  # m of road before the scenario's and after it
PROPERTIES = {
    "ALKS_R157SM_Controller": {"mode": "override", "logLevel": "0", "model": "ReferenceDriver",
                    "cruise": "true", "cutInPerceptionDelayMode": "Time", "fullStop": "true",
                    "alwaysTrigOnScenario": "true", "pedestrianRiskEvaluationTime": "0.4",
                    "overlapTolerance": "0.0"},
    "ACCController": {"mode": "override", "timeGap": "1.5", "lateralDist": "3"},
}


class State(ctypes.Structure):
    """SE_ScenarioObjectState of esmini 3."""

    _fields_ = [(name, kind) for kind, names in [
        (ctypes.c_int, ["id", "model_id", "ctrl_type"]),
        (ctypes.c_double, ["timestamp", "x", "y", "z", "h", "p", "r"]),
        (ctypes.c_uint32, ["road_id", "junction_id"]),
        (ctypes.c_double, ["t"]), (ctypes.c_int, ["lane_id"]),
        (ctypes.c_double, ["lane_offset", "s", "speed", "center_x", "center_y", "center_z",
                           "width", "length", "height"]),
        (ctypes.c_int, ["object_type", "object_category"]),
        (ctypes.c_double, ["wheel_angle", "wheel_rot"]),
        (ctypes.c_int, ["visibility"])] for name in names]


class Trouble(Exception):
    """What the user is told."""


def load():
    path = ([*sys.argv[1:2], os.environ.get("ESMINI_LIB")][0]
            or ctypes.util.find_library("esminiLib"))
    if not path:
        raise Trouble("no esmini library: name libesminiLib.so after the script or in ESMINI_LIB")
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise Trouble(f"cannot load esmini's library: {error}") from error
    library.SE_StepDT.argtypes = [ctypes.c_double]
    library.SE_ReportObjectPosXYH.argtypes = [ctypes.c_int] + 3 * [ctypes.c_double]
    library.SE_ReportObjectSpeed.argtypes = [ctypes.c_int, ctypes.c_double]
    library.SE_GetObjectState.argtypes = [ctypes.c_int, ctypes.POINTER(State)]
    library.SE_GetObjectName.restype = ctypes.c_char_p
    library.SE_GetObjectAcceleration.restype = ctypes.c_double
    return library


def version_of(library):
    """esmini 3 has no function for it; its builds have a tag, which one's own may lack."""
    for name in ("ESMINI_GIT_TAG", "ESMINI_BUILD_VERSION"):
        try:
            text = (ctypes.c_char_p.in_dll(library, name).value or b"").decode()
        except ValueError:
            continue
        number = text.lstrip("v")
        if number[:1].isdigit():
            if number.split(".")[0] != "3":
                raise Trouble(f"esmini {text}: this script is for version 3")
            return number
    return "3 (without a tag)"


def element(tag, text="", /, **attributes):
    pairs = "".join(f' {key}="{value}"' for key, value in attributes.items())
    return f"<{tag}{pairs}>{text}</{tag}>"


def lanes_xml(bands, reference):
    """Lanes on both sides of the reference line, counted from it."""
    def lane(number, band):
        width = band["across"][1] - band["across"][0]
        kind = "driving" if band["kind"] == "lane" else "sidewalk"
        return element("lane", element("width", sOffset=0, a=width, b=0, c=0, d=0),
                       id=number, type=kind, level="false")
    left = [b for b in bands if b["across"][1] <= reference]
    right = [b for b in bands if b["across"][0] >= reference]
    text = ""
    if left:
        text += element("left", "".join(lane(len(left) - i, b) for i, b in enumerate(left)))
    text += element("center", element("lane", id=0, type="none", level="false"))
    if right:
        text += element("right", "".join(lane(-1 - i, b) for i, b in enumerate(right)))
    return element("lanes", element("laneSection", text, s=0))


def road_xml(road, av):
    """The road runs along y. Its reference line is between the two ways of traffic."""
    bands = road["bands"]
    if not bands:
        raise Trouble("a road that is drawn as a map has no lanes that esmini could drive on")
    mine = [b for b in bands if b["kind"] == "lane" and not b["oncoming"]]
    others = [b for b in bands if b["kind"] == "lane" and b["oncoming"]]
    on_the_left = bool(others) and others[0]["across"][0] > av["x"]
    if on_the_left:
        reference = others[0]["across"][0]
    else:
        reference = mine[0]["across"][0] if mine else bands[0]["across"][0]
    length = road["length"] + 2 * MARGIN
    line = element("geometry", "<line/>", s=0, x=reference, y=-MARGIN, hdg=math.pi / 2,
                   length=length)
    return '<?xml version="1.0"?>' + element("OpenDRIVE", '<header revMajor="1" revMinor="6"/>'
                   + element("road", element("planView", line) + lanes_xml(bands, reference),
                             name="road", length=length, id=1, junction=-1,
                             rule="LHT" if on_the_left else "RHT"))


def box_xml(actor):
    # The point that a place is about is the middle of the box, of vehicles that of the rear axle.
    return element("BoundingBox", element("Center", x=rear_axle(actor), y=0, z=0.8) + element(
        "Dimensions", width=actor["width"], length=actor["length"], height=1.6))


def rear_axle(actor):
    """How far behind the middle of the box."""
    return 0 if actor["kind"] == "pedestrian" else actor["length"] * 0.3


def place(actor):
    back = rear_axle(actor)
    return (actor["x"] - back * math.cos(actor["heading"]),
            actor["y"] - back * math.sin(actor["heading"]), actor["heading"])


def body_xml(actor):
    if actor["kind"] == "pedestrian":
        return element("Pedestrian", box_xml(actor) + "<Properties/>", mass=80, model="person",
                       name="person", pedestrianCategory="pedestrian")
    category = "bicycle" if actor["kind"] == "cyclist" else "car"
    axles = "".join(element(name, maxSteering=0.5, wheelDiameter=0.6, trackWidth=actor["width"],
                            positionX=x, positionZ=0.3)
                    for name, x in (("FrontAxle", 2 * rear_axle(actor)), ("RearAxle", 0)))
    return element("Vehicle", box_xml(actor)
                   + '<Performance maxSpeed="100" maxDeceleration="10" maxAcceleration="10"/>'
                   + element("Axles", axles) + "<Properties/>", name=category,
                   vehicleCategory=category)


def controller_xml(name, properties):
    listed = "".join(element("Property", name=key, value=value)
                     for key, value in {"esminiController": name, **properties}.items())
    return element("ObjectController", element("Controller", element("Properties", listed),
                                               name=name))


def init_xml(actor, is_driven):
    x, y, heading = place(actor)
    where = element("WorldPosition", x=x, y=y, z=0, h=heading, p=0, r=0)
    actions = [element("TeleportAction", element("Position", where)),
               element("LongitudinalAction", element("SpeedAction",
                       '<SpeedActionDynamics dynamicsShape="step" dynamicsDimension="time" '
                       'value="0"/>' + element("SpeedActionTarget", element(
                           "AbsoluteTargetSpeed", value=actor["speed"]))))]
    if is_driven:
        actions.append('<ControllerAction><ActivateControllerAction longitudinal="true" '
                       'lateral="false"/></ControllerAction>')
    return element("Private", "".join(element("PrivateAction", each) for each in actions),
                   entityRef=actor["name"])


def scenario_xml(av, actors, road_file, options):
    name = options.get("controller", "ALKS_R157SM_Controller")
    known = PROPERTIES.get(name, {})
    if name == "ACCController":
        known = {**known, "setSpeed": av["cruise"]}
    given = {k: v for k, v in options.items() if k != "controller"}
    drives = controller_xml(name, {**known, **given}) if name != "none" else ""
    entities = element("ScenarioObject", body_xml(av) + drives, name=av["name"])
    init = init_xml(av, name != "none")
    for actor in actors:
        entities += element("ScenarioObject",
                            body_xml(actor) + controller_xml("ExternalController", {}),
                            name=actor["name"])
        init += init_xml(actor, True)
    forever = ('<StopTrigger><ConditionGroup><Condition name="never" delay="0" conditionEdge="none">'
               '<ByValueCondition><SimulationTimeCondition value="1e9" rule="greaterThan"/>'
               '</ByValueCondition></Condition></ConditionGroup></StopTrigger>')
    return '<?xml version="1.0"?>' + element(
        "OpenSCENARIO", '<FileHeader revMajor="1" revMinor="2" date="2000-01-01T00:00:00" '
        'description="a test" author="Jaywalk"/><ParameterDeclarations/><CatalogLocations/>'
        + element("RoadNetwork", element("LogicFile", filepath=road_file))
        + element("Entities", entities)
        + element("Storyboard", element("Init", element("Actions", init)) + forever))


class Road:
    NAME = "esmini"
    library = None

    @classmethod
    def hello(cls):
        cls.library = load()
        return version_of(cls.library)

    def __init__(self, reset):
        options = reset["options"]
        self.library.SE_Close()  # of the test before
        self.actors = [a for a in reset["actors"] if a["kind"] != "signal"]
        self.moved = [a["kind"] != "signal" for a in reset["actors"]]
        self.av = reset["av"]
        self.time = 0.0
        with tempfile.TemporaryDirectory() as folder:
            road_file = os.path.join(folder, "road.xodr")
            with open(road_file, "w", encoding="utf-8") as file:
                file.write(road_xml(reset["road"], self.av))
            scenario = os.path.join(folder, "test.xosc")
            with open(scenario, "w", encoding="utf-8") as file:
                file.write(scenario_xml(self.av, self.actors, road_file, options))
            self.start(scenario)
        self.check_layout()
        controller = options.get("controller")
        if controller != "none" and self.state(self.av_id).ctrl_type == 0:
            raise Trouble(f"esmini has no controller '{controller}'")

    def start(self, scenario):
        words = [b"esmini", b"--osc", scenario.encode(), b"--headless", b"--disable_stdout",
                 b"--disable_log"]
        arguments = (ctypes.c_char_p * len(words))(*words)
        if self.library.SE_InitWithArgs(len(words), arguments) != 0:
            raise Trouble("esmini does not take the scenario")
        names = {self.library.SE_GetObjectName(number): number
                 for number in map(self.library.SE_GetId,
                                   range(self.library.SE_GetNumberOfObjects()))}
        self.av_id = names[self.av["name"].encode()]
        self.ids = [names[actor["name"].encode()] for actor in self.actors]

    def check_layout(self):
        """Other major versions lay out a state differently: what comes back is no number of ours."""
        state = self.state(self.av_id)
        x, y, _ = place(self.av)
        for found, wanted in ((state.x, x), (state.y, y),
                              (state.length, self.av["length"]), (state.speed, self.av["speed"])):
            if not abs(found - wanted) < 0.01:
                raise Trouble("its library is of another version than 3: it does not give back "
                              "where the AV was put")

    def state(self, number):
        state = State()
        if self.library.SE_GetObjectState(number, ctypes.byref(state)) != 0:
            raise Trouble("esmini has lost an object")
        return state

    def scene(self):
        state = self.state(self.av_id)
        return {"time": self.time,
                "av": {"x": state.x + state.center_x * math.cos(state.h),
                       "y": state.y + state.center_x * math.sin(state.h), "heading": state.h,
                       "speed": max(state.speed, 0.0),
                       "acceleration": self.library.SE_GetObjectAcceleration(self.av_id)}}

    def step(self, dt, actors, _signals):
        moved = [actor for actor, is_moved in zip(actors, self.moved) if is_moved]
        for number, described, actor in zip(self.ids, self.actors, moved):
            self.library.SE_ReportObjectPosXYH(number, *place({**described, **actor}))
            self.library.SE_ReportObjectSpeed(number, actor["speed"])
        if self.library.SE_StepDT(dt) != 0:
            raise Trouble(f"esmini ends after {self.time:g} s")
        self.time += dt


def serve(answers):
    road = None
    for line in sys.stdin:
        message = json.loads(line)
        kind = message["type"]
        if kind == "bye":
            return
        answer = {"step": message["step"]}
        try:
            if kind == "hello":
                answer.update(protocol=1, name=Road.NAME, version=Road.hello(), deterministic=True)
            else:
                answer["test"] = message["test"]
                if kind == "reset":
                    road = Road(message)
                else:
                    road.step(message["dt"], message["actors"], message["signals"])
                answer.update(road.scene())
        except Trouble as trouble:
            answer["error"] = str(trouble)
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    # Discard the library's output: standard output is for answers alone.
    ours = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    serve(ours)

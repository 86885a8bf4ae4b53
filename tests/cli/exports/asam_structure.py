"""check(path): what the schemas of OpenSCENARIO XML 1.0 to 1.3 and of OpenDRIVE 1.6 and 1.7 demand of
the elements that Jaywalk writes: which children, in which order and how many, which attributes, which
words. Written after the published schemas, which cannot be distributed; whoever has them runs
`xmllint --noout --schema` in addition.

    asam_structure.py FILE...            checks files
    asam_structure.py --breaking FILE... checks itself: whatever breaks such a file is noticed
"""
import re
import sys
import xml.etree.ElementTree as xml

NUMBER = re.compile(r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?$")
NAME = re.compile(r"[^$].*|$", re.S)
REFERENCE = re.compile(r"\$[A-Za-z_][A-Za-z0-9_]*$")


def number(text):
    """A double, or a parameter's name in its place."""
    return bool(NUMBER.match(text) or REFERENCE.match(text))


def natural(text):
    return text.isdigit()


def moment(text):
    return bool(re.match(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?(Z|[-+]\d\d:\d\d)?$", text))


def words(*allowed):
    return lambda text: text in allowed


def text(_):
    return True


RULE = words("greaterThan", "lessThan", "equalTo")
BOOLEAN = words("true", "false")
# Element or parent/element: (kind, children, attributes). Kinds: `seq` in this order, `all` in any, `one`
# exactly one of them. Children: name, least, most (0: any number). Attributes: name -> its form; a name
# that ends in `?` may be left out. What differs from version to version is written as all of 1.0 to 1.3
# take it.
SCENARIO = {
    "OpenSCENARIO": ("seq", [("FileHeader", 1, 1), ("ParameterDeclarations", 0, 1), ("CatalogLocations", 1, 1),
                             ("RoadNetwork", 1, 1), ("Entities", 1, 1), ("Storyboard", 1, 1)], {}),
    "FileHeader": ("seq", [], {"revMajor": words("1"), "revMinor": words("0", "1", "2", "3"), "date": moment,
                               "description": text, "author": text}),
    "ParameterDeclarations": ("seq", [("ParameterDeclaration", 0, 0)], {}),
    "ParameterDeclaration": ("seq", [], {
        "name": text, "value": text,
        "parameterType": words("double", "string", "unsignedInt", "unsignedShort", "boolean", "dateTime")}),
    "CatalogLocations": ("all", [], {}),
    "RoadNetwork": ("seq", [("LogicFile", 0, 1), ("SceneGraphFile", 0, 1), ("TrafficSignals", 0, 1)], {}),
    "TrafficSignals": ("seq", [("TrafficSignalController", 0, 0)], {}),
    "TrafficSignalController": ("seq", [("Phase", 0, 0)], {"name": text, "delay": number}),
    "Phase": ("seq", [("TrafficSignalState", 0, 0)], {"name": text, "duration": number}),
    "TrafficSignalState": ("seq", [], {"trafficSignalId": text, "state": text}),
    "LogicFile": ("seq", [], {"filepath": text}),
    "Entities": ("seq", [("ScenarioObject", 0, 0)], {}),
    "ScenarioObject": ("one", [("Vehicle", 1, 1), ("Pedestrian", 1, 1), ("MiscObject", 1, 1)], {"name": text}),
    "Vehicle": ("all", [("ParameterDeclarations", 0, 1), ("BoundingBox", 1, 1), ("Performance", 1, 1),
                        ("Axles", 1, 1), ("Properties", 1, 1)],
                {"name": text, "vehicleCategory": words("car", "van", "truck", "trailer", "semitrailer", "bus",
                                                        "motorbike", "bicycle", "train", "tram")}),
    "Pedestrian": ("all", [("ParameterDeclarations", 0, 1), ("BoundingBox", 1, 1), ("Properties", 1, 1)],
                   {"name": text, "model": text, "mass": number,
                    "pedestrianCategory": words("pedestrian", "wheelchair", "animal")}),
    "MiscObject": ("all", [("ParameterDeclarations", 0, 1), ("BoundingBox", 1, 1), ("Properties", 1, 1)],
                   {"name": text, "mass": number,
                    "miscObjectCategory": words("barrier", "building", "none", "obstacle", "parkingSpace", "pole",
                                                "tree", "vegetation")}),
    "BoundingBox": ("all", [("Center", 1, 1), ("Dimensions", 1, 1)], {}),
    "Center": ("seq", [], {"x": number, "y": number, "z": number}),
    "Dimensions": ("seq", [], {"width": number, "length": number, "height": number}),
    "Performance": ("seq", [], {"maxSpeed": number, "maxAcceleration": number, "maxDeceleration": number}),
    "Axles": ("seq", [("FrontAxle", 1, 1), ("RearAxle", 1, 1), ("AdditionalAxle", 0, 0)], {}),
    **{axle: ("seq", [], {"maxSteering": number, "wheelDiameter": number, "trackWidth": number,
                          "positionX": number, "positionZ": number}) for axle in ("FrontAxle", "RearAxle")},
    "Properties": ("seq", [("Property", 0, 0), ("File", 0, 0)], {}),
    "Property": ("seq", [], {"name": text, "value": text}),
    "Storyboard": ("seq", [("Init", 1, 1), ("Story", 1, 0), ("StopTrigger", 1, 1)], {}),
    "Init": ("seq", [("Actions", 1, 1)], {}),
    "Actions": ("seq", [("GlobalAction", 0, 0), ("UserDefinedAction", 0, 0), ("Private", 0, 0)], {}),
    "Private": ("seq", [("PrivateAction", 1, 0)], {"entityRef": text}),
    "PrivateAction": ("one", [("LongitudinalAction", 1, 1), ("TeleportAction", 1, 1), ("RoutingAction", 1, 1)], {}),
    "LongitudinalAction": ("one", [("SpeedAction", 1, 1)], {}),
    "SpeedAction": ("all", [("SpeedActionDynamics", 1, 1), ("SpeedActionTarget", 1, 1)], {}),
    "SpeedActionDynamics": ("seq", [], {"dynamicsShape": words("linear", "cubic", "sinusoidal", "step"),
                                        "value": number, "dynamicsDimension": words("rate", "time", "distance")}),
    "SpeedActionTarget": ("one", [("AbsoluteTargetSpeed", 1, 1)], {}),
    "AbsoluteTargetSpeed": ("seq", [], {"value": number}),
    "TeleportAction": ("one", [("Position", 1, 1)], {}),
    "Position": ("one", [("WorldPosition", 1, 1), ("LanePosition", 1, 1)], {}),
    "LanePosition": ("seq", [("Orientation", 0, 1)], {"roadId": text, "laneId": text, "s": number,
                                                      "offset?": number}),
    "WorldPosition": ("seq", [], {"x": number, "y": number, "z?": number, "h?": number, "p?": number,
                                  "r?": number}),
    "RoutingAction": ("one", [("FollowTrajectoryAction", 1, 1), ("AcquirePositionAction", 1, 1)], {}),
    "AcquirePositionAction": ("seq", [("Position", 1, 1)], {}),
    "FollowTrajectoryAction": ("all", [("Trajectory", 1, 1), ("TimeReference", 1, 1),
                                       ("TrajectoryFollowingMode", 1, 1)], {}),
    "Trajectory": ("seq", [("ParameterDeclarations", 0, 1), ("Shape", 1, 1)], {"name": text, "closed": BOOLEAN}),
    "Shape": ("one", [("Polyline", 1, 1)], {}),
    "Polyline": ("seq", [("Vertex", 2, 0)], {}),
    "Vertex": ("all", [("Position", 1, 1)], {"time": number}),
    "TimeReference": ("one", [("Timing", 1, 1), ("None", 1, 1)], {}),
    "Timing": ("seq", [], {"domainAbsoluteRelative": words("absolute", "relative"), "scale": number,
                           "offset": number}),
    "TrajectoryFollowingMode": ("seq", [], {"followingMode": words("position", "follow")}),
    "Story": ("seq", [("ParameterDeclarations", 0, 1), ("Act", 1, 0)], {"name": text}),
    "Act": ("seq", [("ManeuverGroup", 1, 0), ("StartTrigger", 1, 1), ("StopTrigger", 0, 1)], {"name": text}),
    "ManeuverGroup": ("seq", [("Actors", 1, 1), ("CatalogReference", 0, 0), ("Maneuver", 0, 0)],
                      {"name": text, "maximumExecutionCount": natural}),
    "Actors": ("seq", [("EntityRef", 0, 0)], {"selectTriggeringEntities": BOOLEAN}),
    "EntityRef": ("seq", [], {"entityRef": text}),
    "Maneuver": ("seq", [("ParameterDeclarations", 0, 1), ("Event", 1, 0)], {"name": text}),
    "Event": ("seq", [("Action", 1, 0), ("StartTrigger", 1, 1)],
              {"name": text, "priority": words("overwrite", "skip", "parallel"), "maximumExecutionCount?": natural}),
    "Action": ("one", [("PrivateAction", 1, 1)], {"name": text}),
    "StartTrigger": ("seq", [("ConditionGroup", 0, 0)], {}),
    "StopTrigger": ("seq", [("ConditionGroup", 0, 0)], {}),
    "ConditionGroup": ("seq", [("Condition", 1, 0)], {}),
    "Condition": ("one", [("ByEntityCondition", 1, 1), ("ByValueCondition", 1, 1)],
                  {"name": text, "delay": number,
                   "conditionEdge": words("rising", "falling", "risingOrFalling", "none")}),
    "ByEntityCondition": ("seq", [("TriggeringEntities", 1, 1), ("EntityCondition", 1, 1)], {}),
    "TriggeringEntities": ("seq", [("EntityRef", 1, 0)], {"triggeringEntitiesRule": words("any", "all")}),
    "EntityCondition": ("one", [("TimeToCollisionCondition", 1, 1), ("CollisionCondition", 1, 1),
                                ("ReachPositionCondition", 1, 1)], {}),
    "ReachPositionCondition": ("seq", [("Position", 1, 1)], {"tolerance": number}),
    "TimeToCollisionCondition": ("all", [("TimeToCollisionConditionTarget", 1, 1)],
                                 {"value": number, "freespace": BOOLEAN, "alongRoute": BOOLEAN, "rule": RULE}),
    "TimeToCollisionConditionTarget": ("one", [("Position", 1, 1), ("EntityRef", 1, 1)], {}),
    "CollisionCondition": ("one", [("EntityRef", 1, 1), ("ByType", 1, 1)], {}),
    "ByValueCondition": ("one", [("SimulationTimeCondition", 1, 1), ("ParameterCondition", 1, 1)], {}),
    "SimulationTimeCondition": ("seq", [], {"value": number, "rule": RULE}),
    "ParameterCondition": ("seq", [], {"parameterRef": text, "value": text, "rule": RULE}),
}
# Since 1.1: a file of parameters' values instead of a scenario.
VALUES = {
    "OpenSCENARIO": ("seq", [("FileHeader", 1, 1), ("ParameterValueDistribution", 1, 1)], {}),
    "FileHeader": SCENARIO["FileHeader"],
    "ParameterValueDistribution": ("seq", [("ScenarioFile", 1, 1), ("Deterministic", 1, 1)], {}),
    "ScenarioFile": ("seq", [], {"filepath": text}),
    "Deterministic": ("seq", [("DeterministicMultiParameterDistribution", 0, 0)], {}),
    "DeterministicMultiParameterDistribution": ("one", [("ValueSetDistribution", 1, 1)], {}),
    "ValueSetDistribution": ("seq", [("ParameterValueSet", 1, 0)], {}),
    "ParameterValueSet": ("seq", [("ParameterAssignment", 1, 0)], {}),
    "ParameterAssignment": ("seq", [], {"parameterRef": text, "value": text}),
}
LANES = [("lane", 1, 0)]
LANE = ("seq", [("link", 0, 1), ("width", 1, 0), ("roadMark", 0, 0)],
        {"id": lambda t: bool(re.match(r"-?[1-9]\d*$", t)),
         "type": words("driving", "sidewalk", "shoulder", "border", "none", "biking", "curb", "parking", "median"),
         "level?": BOOLEAN})
ROAD = {
    "OpenDRIVE": ("seq", [("header", 1, 1), ("road", 1, 0), ("controller", 0, 0), ("junction", 0, 0)], {}),
    "header": ("seq", [("geoReference", 0, 1), ("offset", 0, 1)],
               {"revMajor": words("1"), "revMinor": words("6", "7"), "name?": text, "version?": text, "north?": number,
                "south?": number, "east?": number, "west?": number, "date?": text, "vendor?": text}),
    "road": ("seq", [("link", 0, 1), ("type", 0, 0), ("planView", 1, 1), ("elevationProfile", 0, 1),
                     ("lateralProfile", 0, 1), ("lanes", 1, 1), ("objects", 0, 1), ("signals", 0, 1)],
             {"name?": text, "length": number, "id": text, "junction": text, "rule?": words("LHT", "RHT")}),
    "planView": ("seq", [("geometry", 1, 0)], {}),
    "geometry": ("one", [("line", 1, 1), ("paramPoly3", 1, 1)], {"s": number, "x": number, "y": number, "hdg": number, "length": number}),
    "line": ("seq", [], {}),
    "paramPoly3": ("seq", [], {"pRange": words("normalized", "arcLength"),
                               **{name: number for name in ("aU", "bU", "cU", "dU", "aV", "bV", "cV", "dV")}}),
    "road/link": ("seq", [("predecessor", 0, 1), ("successor", 0, 1)], {}),
    **{f"link/{end}": ("seq", [], {"elementType?": words("road", "junction"), "elementId?": text,
                                   "contactPoint?": words("start", "end"), "id?": text})
       for end in ("predecessor", "successor")},
    "lane/link": ("seq", [("predecessor", 0, 0), ("successor", 0, 0)], {}),
    "laneOffset": ("seq", [], {name: number for name in ("s", "a", "b", "c", "d")}),
    "objects": ("seq", [("object", 0, 0)], {}),
    "object": ("seq", [("outlines", 0, 1)],
               {"id": text, "s": number, "t": number, "zOffset": number, "name?": text,
                "type?": words("none", "obstacle", "building", "crosswalk"), "orientation?": words("+", "-", "none"),
                **{f"{name}?": number for name in ("length", "width", "height", "hdg", "pitch", "roll")}}),
    "outlines": ("seq", [("outline", 1, 0)], {}),
    "outline": ("seq", [("cornerLocal", 0, 0)], {"id?": natural, "outer?": BOOLEAN, "closed?": BOOLEAN}),
    "cornerLocal": ("seq", [], {"id?": natural, **{name: number for name in ("u", "v", "z", "height")}}),
    "signals": ("seq", [("signal", 0, 0)], {}),
    "signal": ("seq", [], {"s": number, "t": number, "id": text, "name?": text, "dynamic": words("yes", "no"),
                           "orientation": words("+", "-", "none"), "zOffset": number, "country?": text,
                           "type": text, "subtype": text, "height?": number, "width?": number}),
    "controller": ("seq", [("control", 1, 0)], {"id": text, "name?": text}),
    "control": ("seq", [], {"signalId": text, "type?": text}),
    "junction": ("seq", [("connection", 1, 0)], {"id": text, "name?": text}),
    "connection": ("seq", [("laneLink", 0, 0)], {"id": text, "incomingRoad?": text, "connectingRoad?": text,
                                                 "contactPoint?": words("start", "end")}),
    "laneLink": ("seq", [], {"from": text, "to": text}),
    "lanes": ("seq", [("laneOffset", 0, 0), ("laneSection", 1, 0)], {}),
    "laneSection": ("seq", [("left", 0, 1), ("center", 1, 1), ("right", 0, 1)], {"s": number, "singleSide?": BOOLEAN}),
    "left": ("seq", LANES, {}), "right": ("seq", LANES, {}), "center": ("seq", [("lane", 1, 1)], {}),
    "left/lane": LANE, "right/lane": LANE,
    "center/lane": ("seq", [("link", 0, 1), ("roadMark", 0, 0)],
                    {"id": words("0"), "type": words("none", "driving"), "level?": BOOLEAN}),
    "width": ("seq", [], {"sOffset": number, "a": number, "b": number, "c": number, "d": number}),
    "roadMark": ("seq", [], {"sOffset": number, "type": words("broken", "solid", "none", "curb"),
                             "weight?": words("standard", "bold"), "color": words("white", "yellow", "standard"),
                             "width?": number}),
}


def order_problem(kind, wanted, found):
    names = [name for name, _, _ in wanted]
    for name in found:
        if name not in names:
            return f"has a child {name}"
    if kind == "one":
        return "" if len(found) == 1 else f"has {len(found)} children, not one"
    if kind == "seq" and [names.index(name) for name in found] != sorted(names.index(name) for name in found):
        return f"has its children in the order {', '.join(found)}"
    for name, least, most in wanted:
        count = found.count(name)
        if count < least or (most and count > most):
            return f"has {count} children {name}"
    return ""


def problems(element, model, parent="", path=""):
    path = f"{path}/{element.tag}"
    rule = model.get(f"{parent}/{element.tag}") or model.get(element.tag)
    if rule is None:
        return [f"{path}: unknown"]
    kind, children, attributes = rule
    result = []
    problem = order_problem(kind, children, [child.tag for child in element])
    if problem:
        result.append(f"{path}: {problem}")
    known = {name.rstrip("?"): form for name, form in attributes.items()}
    for name in attributes:
        if not name.endswith("?") and name not in element.attrib:
            result.append(f"{path}: no attribute {name}")
    for name, value in element.attrib.items():
        if name not in known:
            result.append(f"{path}: an attribute {name}")
        elif not known[name](value):
            result.append(f"{path}: {name} is '{value}'")
    for child in element:
        result += problems(child, model, element.tag, path)
    return result


def references(root):
    """Entities and parameters that are named exist; names are unique where they have to be."""
    entities = [each.get("name") for each in root.iter("ScenarioObject")]
    declared = [each.get("name") for each in root.iter("ParameterDeclaration")]
    result = [f"a second {name}" for name in set(entities) if entities.count(name) > 1]
    for element in root.iter():
        entity = element.get("entityRef")
        if entity is not None and entity not in entities:
            result.append(f"{element.tag}: no entity {entity}")
        for value in element.attrib.values():
            if value.startswith("$") and value[1:] not in declared:
                result.append(f"{element.tag}: no parameter {value}")
    for parent in root.iter():
        times = [float(each.get("time")) for each in parent if each.tag == "Vertex" and NUMBER.match(each.get("time", ""))]
        if times != sorted(set(times)):
            result.append("vertices are not in the order of their times")
    return result


def lanes(root):
    """Lanes stand from left to right: ids fall by one from lane to lane."""
    for section in root.iter("laneSection"):
        ids = [each.get("id", "") for each in section.iter("lane")]
        if not all(re.match(r"-?\d+$", each) for each in ids):
            return ["a lane without a number"]
        ids = [int(each) for each in ids]
        if ids != list(range(ids[0], ids[0] - len(ids), -1)):
            return [f"lanes are numbered {ids}"]
    return []


def check(path):
    root = xml.parse(path).getroot()
    return check_tree(root)


def check_tree(root):
    if root.tag == "OpenDRIVE":
        return problems(root, ROAD) + lanes(root)
    if root.find("ParameterValueDistribution") is not None:
        return problems(root, VALUES)
    return problems(root, SCENARIO) + references(root)


def breaks(path):
    """Each way to break a file is noticed: a child gone or moved, an attribute gone, unknown or odd."""
    source = open(path).read()
    unnoticed = []

    def attempt(what, change):
        root = xml.fromstring(source)
        if change(root) is not False and not check_tree(root):
            unnoticed.append(f"{path}: {what}")

    for tag in sorted({each.tag for each in xml.fromstring(source).iter()}):
        model = {**SCENARIO, **VALUES} if not path.endswith(".xodr") else ROAD
        rule = model.get(tag) or model.get("left/" + tag)
        if rule is None:
            continue
        attempt(f"{tag} with an unknown attribute", lambda root: next(root.iter(tag)).set("colourful", "yes"))
        attempt(f"{tag} with an unknown child", lambda root: xml.SubElement(next(root.iter(tag)), "Unknown"))
        for name, form in rule[2].items():
            if name.endswith("?"):
                continue
            attempt(f"{tag} without {name}", lambda root: next(root.iter(tag)).attrib.pop(name, None))
            if form is not text:
                attempt(f"{tag} with an odd {name}", lambda root: next(root.iter(tag)).set(name, "odd one"))

        def swap(root):
            each = next((e for e in root.iter(tag) if len({child.tag for child in e}) > 1), None)
            if each is None or rule[0] != "seq":
                return False
            children = list(each)
            for child in children:
                each.remove(child)
            each.extend(reversed(children))
            return None

        attempt(f"{tag} with its children reversed", swap)
    return unnoticed


if __name__ == "__main__":
    breaking = sys.argv[1] == "--breaking"
    files = sys.argv[2:] if breaking else sys.argv[1:]
    if breaking:
        found = [f"unnoticed: {each}" for path in files for each in breaks(path)]
    else:
        found = [f"{path}: {problem}" for path in files for problem in check(path)]
    print("\n".join(found[:40]))
    sys.exit(1 if found or not files else 0)

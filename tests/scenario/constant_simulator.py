"""A simulator whose AV keeps its speed, for tests: it can be told to do something wrong once.

constant_simulator.py [FAULT]: in the third step of test 1 it does what the fault says.
"""
import json
import os
import sys
import time

FAULT = sys.argv[1] if len(sys.argv) > 1 else ""


def wrong(answer):
    av = answer["av"]
    if FAULT == "hangs":
        time.sleep(60)
    elif FAULT == "dies":
        os._exit(3)
    elif FAULT == "nonsense":
        return "nonsense"
    elif FAULT == "back":
        answer["time"] = 0.05
    elif FAULT == "early":
        answer["time"] -= 0.05
    elif FAULT == "other_test":
        answer["test"] += 1
    elif FAULT == "no_test":
        del answer["test"]
    elif FAULT == "other_step":
        answer["step"] += 1
    elif FAULT == "no_step":
        del answer["step"]
    elif FAULT == "no_av":
        del answer["av"]
    elif FAULT == "no_speed":
        del av["speed"]
    elif FAULT == "word":
        av["x"] = "left"
    elif FAULT == "reverse":
        av["speed"] = -3
    elif FAULT == "far":
        av["y"] = 1e300
    elif FAULT == "gone":
        av["present"] = False
    elif FAULT == "complains":
        answer["error"] = "no engine"
    elif FAULT == "traffic":
        answer["traffic"] = [{}]
    elif FAULT == "contact":
        answer["contacts"] = [99]
    elif FAULT == "two_lines":
        return json.dumps(answer) + "\n" + json.dumps(answer)
    return json.dumps(answer)


for line in sys.stdin:
    asked = json.loads(line)
    kind, step = asked["type"], asked.get("step")
    if kind == "bye":
        break
    if kind == "hello":
        said = {"protocol": 2 if FAULT == "protocol" else 1, "name": "constant", "version": "7.1",
                "deterministic": FAULT != "random", "step": step, "surprise": [1]}
        print(json.dumps(said), flush=True)
        continue
    if kind == "reset":
        time_s, av = 0.0, dict(asked["av"])
        if FAULT == "start" and asked["test"] == 1:
            av["y"] += 1
    else:
        time_s += asked["dt"]
        av["y"] += av["speed"] * asked["dt"]
    said = {"test": asked["test"], "step": step, "time": time_s, "surprise": None,
            "av": {key: av[key] for key in ("x", "y", "heading", "speed")}}
    hurt = asked["test"] == 1 and step == 3
    print(wrong(said) if hurt else json.dumps(said), flush=True)

"""A room with a door that has to be unlocked: room.py is started by Jaywalk."""

import json
import sys

locked, state, greeted = True, "shut", False


def hello(question):
    print("arguments:", *question["arguments"], file=sys.stderr)
    return {"protocol": 1, "name": "room", "version": "1", "tick_ms": 500, "deterministic": True,
            "percepts": [{"form": "door(State)", "meaning": "shut or open"}],
            "actions": [{"form": "open(Thing)", "meaning": "opens it, if it is unlocked"},
                        {"form": "unlock(Thing)", "meaning": "unlocks it"},
                        {"form": "greet", "meaning": "ends the visit"}]}


def act(action):
    """Why it failed; None if it did not."""
    global locked, state, greeted
    if action["name"] == "open":
        if locked:
            return "the door is locked"
        state = "open"
    elif action["name"] == "unlock":
        locked = False
    elif action["name"] == "greet":
        greeted = True
    else:
        return "no such action"
    return None


for line in sys.stdin:
    question = json.loads(line)
    answer = {"n": question["n"]}
    if question["type"] == "hello":
        answer.update(hello(question))
    elif question["type"] == "bye":
        break
    else:
        done = []
        for action in question.get("actions", []):
            why = act(action)
            done.append({"id": action["id"], **({"failed": why} if why else {})})
        answer.update(percepts={"*": [f"door({state})"]}, done=done, finished=greeted,
                      text=f"[{'|' if state == 'shut' else ' '}]\n")
    print(json.dumps(answer), flush=True)

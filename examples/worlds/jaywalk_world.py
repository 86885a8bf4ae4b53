"""Worlds for agents, in Python: copy this file to where your own world is. It needs the standard library alone.

Derive a class from World and call its run(). docs/reference/environment_protocol.md has the lines that it reads and writes.
"""
import inspect
import json
import sys
import traceback


class World:
    """A world that moves in steps: in each tick agents act, the world goes on, and agents look at it."""

    tick_ms = 1000          # how long a tick is, in virtual time
    picture_every = 1       # ticks from one picture to the next; argument `live`: each tick, in the same place
    PERCEPTS = {}           # {"at(Who,Place)": "what it means"}: for the warnings of `jaywalk run`, and for readers
    ACTIONS = {}

    def init(self, agents, seed):
        """Begins anew. All chance comes from the seed. `self.ticks` counts from now on; `self.arguments` are the program's."""

    def percepts(self, agent):
        """All that the agent perceives now: texts of literals."""
        return []

    def act(self, agent, name, args):
        """Does an action. It fails with the text that is returned or raised. What `yield`s takes a tick longer each time."""
        action = f"{name}({', '.join(map(str, args))})" if args else name
        return f"there is no action {action}, but " + ", ".join(self.ACTIONS)

    def tick(self):
        """What happens by itself, after the agents' actions."""

    def finished(self):
        """Whether the run is over, here a minute after the last action. It ends a tick later, so that agents see why."""
        return self.idle_ms >= 60_000

    def picture(self):
        """The world as text, at most 80 columns and 23 lines."""
        return ""

    def run(self):
        """Answers Jaywalk's questions, line by line. What the world prints goes to standard error, beside the answers."""
        answers, sys.stdout = sys.stdout, sys.stderr
        for line in sys.stdin:
            question = json.loads(line)
            if question["type"] == "bye":
                break
            try:
                answer = getattr(self, "_" + question["type"])(question)
            except Exception as mistake:
                traceback.print_exc()
                answer = {"error": repr(mistake)}
            print(json.dumps({"n": question["n"], **answer}), file=answers, flush=True)

    def _hello(self, question):
        self.arguments = [*sys.argv[1:], *question.get("arguments", [])]
        words = {kind: [{"form": form, "meaning": meaning} for form, meaning in forms.items()]
                 for kind, forms in (("percepts", self.PERCEPTS), ("actions", self.ACTIONS))}
        return {"protocol": 1, "name": type(self).__name__, "version": "1", "tick_ms": self.tick_ms,
                "deterministic": True, **words}

    def _init(self, question):
        self.agents, self._seen, self._under_way, self.ticks, self._shown = question["agents"], {}, {}, 0, ""
        self._over = False
        self.idle_ms = 0        # since the last action
        self.init(self.agents, question["seed"])
        return self._view([])

    def _agents(self, question):
        self.agents = question["agents"]
        return self._view([])

    def _tick(self, question):
        self.ticks += 1
        self.idle_ms = 0 if question["actions"] or self._under_way else self.idle_ms + self.tick_ms
        self._under_way.update((action["id"], self._steps(action)) for action in question["actions"])
        done = [result for result in map(self._result, list(self._under_way)) if result]
        self.tick()
        return self._view(done)

    def _steps(self, action):
        result = self.act(action["agent"], action["name"], action["args"])
        return (yield from result) if inspect.isgenerator(result) else result

    def _result(self, number):
        """Goes on with an action. None while it is under way."""
        try:
            next(self._under_way[number])
            return None
        except StopIteration as end:
            reason = end.value
        except Exception as mistake:
            reason = f"{type(mistake).__name__}: {mistake}"
        del self._under_way[number]
        return {"id": number} if reason in (None, True) else {"id": number, "failed": reason or "the world refuses"}

    def _view(self, done):
        percepts = {agent: list(self.percepts(agent)) for agent in self.agents}
        changed = {agent: those for agent, those in percepts.items() if those != self._seen.get(agent)}
        self._seen = percepts
        answer = {"percepts": changed, "done": done, "finished": self._over}
        self._over = self.finished()
        live = "live" in self.arguments
        if (live or answer["finished"] or self.ticks % self.picture_every == 0) and self.picture() != self._shown:
            self._shown = self.picture()
            answer["text"] = ("\x1b[H\x1b[J" if live else "") + self._shown + "\n"
        return answer


def boxed(rows, *notes):
    """Lines of one width in a frame, with notes on the right."""
    edge = "+" + "-" * len(rows[0]) + "+"
    notes = [*notes, *[""] * len(rows)]
    return "\n".join([edge, *(f"|{row}|  {note}".rstrip() for row, note in zip(rows, notes)), edge])

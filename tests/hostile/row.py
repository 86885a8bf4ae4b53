"""What a row of the table is: files, a command, and how it has to end."""

import dataclasses


@dataclasses.dataclass
class Row:
    """`says`: a piece of what is printed, on either stream; several must all be there."""

    name: str
    words: list  # of the command `jaywalk`, or of a shell with it on its path if they are one text
    code: int
    says: object = ""
    files: dict = dataclasses.field(default_factory=dict)  # texts or bytes by names
    stdin: object = ""
    never: str = ""  # what must not be printed
    most: int = 20_000  # characters that may be printed
    seconds: int = 20
    most_mb: float = 0  # memory that the process may hold, all of it; 0: as much as any

    def pieces(self):
        return [self.says] if isinstance(self.says, str) else list(self.says)


def program(name, text, code, says="", *options, command="run", **more):
    """A program that is run alone: `options` follow the file's name."""
    return Row(name, [command, "agent.asl", *options], code, says, {"agent.asl": text}, **more)


def checked(name, text, code, says="", **more):
    return program(name, text, code, says, command="check", **more)


def project(name, text, code, says="", *options, files=None, **more):
    agents = {"a.asl": "!go. +!go <- .print(here).\n", "b.asl": "!go. +!go.\n"}
    return Row(name, ["run", "project.mas2j", *options], code, says,
               {**agents, "project.mas2j": text, **(files or {})}, **more)


WALKER = "!go. +!go <- !wait; !go. +!wait <- move(forward). -!wait. -!go <- !go.\n"


def scenario(name, text, code, says="", *options, files=None, command="run", **more):
    """A scenario that is run once; `{world}` values go below `world:`, the behaviour is a walker."""
    if "behaviours" not in text:
        text += "\nbehaviours: [walker.asl]\n"
    return Row(name, [command, "scenario.yaml", *options], code, says,
               {"walker.asl": WALKER, "scenario.yaml": text, **(files or {})}, **more)

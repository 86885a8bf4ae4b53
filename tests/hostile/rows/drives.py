"""Tables of drives from elsewhere (judge --trace)."""

from row import Row

HEAD = "time,actor,kind,x,y\n"


def drive(name, text, code, says="drive.csv"):
    return Row(name, ["judge", "--trace", "drive.csv", "--metrics"], code, says, {"drive.csv": text})


ROWS = [
    drive("a sound drive", HEAD + "0,av,vehicle,6,0\n1,av,vehicle,6,9\n", 0, ""),
    drive("an empty table", "", 2),
    drive("a table without rows", HEAD, 2),
    drive("a table without a column", "time,actor,kind,x\n0,av,vehicle,6\n", 2, "drive.csv:1"),
    drive("a column twice", "time,time,actor,kind,x,y\n0,0,av,vehicle,6,0\n", 2, "drive.csv:1"),
    drive("a value that is no number", HEAD + "0,av,vehicle,six,0\n", 2, "drive.csv:2"),
    drive("a value that is infinite", HEAD + "0,av,vehicle,inf,0\n1,av,vehicle,6,0\n", 2, "drive.csv:2"),
    drive("a value beyond doubles", HEAD + "0,av,vehicle,1e999,0\n1,av,vehicle,6,0\n", 2, "drive.csv:2"),
    drive("times that are not even", HEAD + "0,av,vehicle,6,0\n1,av,vehicle,6,0\n1.5,av,vehicle,6,0\n", 2, "drive.csv:4"),
    drive("times beyond all numbers", HEAD + "0,av,vehicle,6,0\n1e300,av,vehicle,6,0\n", 2),
    drive("a kind that there is not", HEAD + "0,av,tram,6,0\n", 2, "drive.csv:2"),
    drive("nobody who drives", HEAD + "0,a,pedestrian,6,0\n1,a,pedestrian,6,0\n", 2),
    drive("an actor twice at a time", HEAD + "0,av,vehicle,6,0\n0,av,vehicle,7,0\n1,av,vehicle,7,0\n", 2, "drive.csv:3"),
    drive("an actor who is missing at a time", HEAD + "0,av,vehicle,6,0\n0,a,pedestrian,6,0\n1,av,vehicle,6,9\n", 2),
    drive("a row that is too short", HEAD + "0,av\n", 2, "drive.csv:2"),
    drive("quotes that are not closed", HEAD + '0,"av,vehicle,6,0\n', 2, "drive.csv:2"),
    drive("bytes that are no UTF-8", HEAD.encode() + b"0,\xff,vehicle,6,0\n1,\xff,vehicle,6,0\n", 2),
    drive("a zero byte in a name", HEAD + "0,a\0v,vehicle,6,0\n1,a\0v,vehicle,6,0\n", 2, "cannot be the name of an actor"),
    drive("a line of a million commas", HEAD + "," * 1_000_000 + "\n", 2, "drive.csv:2"),
]

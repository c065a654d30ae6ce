"""freecadcmd solid_worker.py: makes solids of chips, one for each line that comes in.

A line is a JSON object with the arguments of solids.chip; the answer is one with the fields of a
SolidChip, or {"refused": sentence}. It ends where the lines do. solid_processes.py starts it.
"""

import dataclasses
import json
import os
import sys

if __name__ != "evenload.ball_end.solid_worker":  # FreeCAD runs this file as a module of its own
    _folder = os.path.dirname(os.path.abspath(__file__))
    sys.path[:] = [p for p in sys.path if os.path.abspath(p) != _folder]  # our modules' short names
    sys.path.append(os.path.dirname(os.path.dirname(_folder)))

from evenload.ball_end import solids  # noqa: E402
from evenload.ball_end.solid_processes import READY  # noqa: E402


def answer(line):
    """To one line."""
    try:
        return dataclasses.asdict(solids.chip(**json.loads(line)))
    except ValueError as error:
        return {"refused": str(error)}


def main():
    """Answers line after line."""
    output = os.fdopen(os.dup(1), "w", encoding="utf-8")
    sys.stdout.flush()
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what FreeCAD says meanwhile
    print(READY, file=output, flush=True)
    for line in os.fdopen(os.dup(0), encoding="utf-8"):
        print(json.dumps(answer(line)), file=output, flush=True)


if __name__ != "evenload.ball_end.solid_worker":
    main()
    os._exit(0)  # FreeCAD would wait for commands

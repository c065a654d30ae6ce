"""Paths with a fault put into them: a gouge, a rapid through what stands, a plunge."""

import math

import Path
from FreeCAD import Vector

KINDS = ("gouge", "rapid", "plunge")
DEPTH = 0.06  # mm of the gouge beyond what is there already
AWAY = 2.0  # mm further than the wall, of a rapid through it
TOUCHES = 0.02  # mm: a tool that is so near to a wall stands at it


def with_fault(commands, kind, models, stock, radius):
    """(commands with a fault, where it is as (x, y, z)), or None where the path has no place for
    one: no wall that the tool touches, no first descent over the stock, a shape.
    """
    if kind == "plunge":
        return _straight_down(commands, "G1", stock)
    at, level = {}, None
    for number, command in enumerate(commands):
        before = dict(at)
        at.update({k: v for k, v in command.Parameters.items() if k in "XYZ"})
        if command.Name not in ("G1", "G2", "G3") or len(before) < 3 or at["Z"] != before["Z"]:
            continue
        level = at["Z"]
        wall = _nearest_wall(models, at["X"], at["Y"], level, radius)
        if wall is None:
            continue
        (x, y), (u, v) = wall, _unit(wall[0] - at["X"], wall[1] - at["Y"])
        by = DEPTH if kind == "gouge" else radius + AWAY
        name = "G1" if kind == "gouge" else "G0"
        out = {"X": at["X"] + by * u, "Y": at["Y"] + by * v, "Z": level}
        feed = {"F": command.Parameters.get("F", 10.0)} if kind == "gouge" else {}
        made = [
            Path.Command(name, {**out, **feed}),
            Path.Command(name, {**{k: at[k] for k in "XYZ"}, **feed}),
        ]
        return [*commands[: number + 1], *made, *commands[number + 1 :]], (x, y, level)
    return _straight_down(commands, "G0", stock) if kind == "rapid" else None


def _straight_down(commands, name, stock):
    """Down to the path's depth where it enters first over the stock, before anything is cut."""
    depth = min(c.Parameters["Z"] for c in commands if "Z" in c.Parameters)
    at = {}
    for number, command in enumerate(commands):
        at.update({k: v for k, v in command.Parameters.items() if k in "XYZ"})
        if command.Name in ("G2", "G3") or (command.Name == "G1" and len(command.Parameters) > 2):
            return None
        if len(at) == 3 and stock.isInside(Vector(at["X"], at["Y"], depth + 0.1), 1e-6, True):
            down = {"X": at["X"], "Y": at["Y"], "Z": depth}
            if name == "G1":
                down["F"] = 5.0
            up = Path.Command("G0", {"X": at["X"], "Y": at["Y"], "Z": at["Z"]})
            made = [Path.Command(name, down), up]
            place = at["X"], at["Y"], depth
            return [*commands[: number + 1], *made, *commands[number + 1 :]], place
    return None


def _nearest_wall(models, x, y, level, radius):
    """(x, y) of a wall of the models that a tool touches; None where it touches none."""
    best = None
    for model in models:
        for edge in model.Edges:
            if edge.Degenerated or edge.BoundBox.ZMin < level + 0.5:
                continue
            for p in edge.discretize(Number=max(2, math.ceil(edge.Length / 0.2) + 1)):
                away = math.hypot(p.x - x, p.y - y)
                if abs(away - radius) < TOUCHES and (best is None or away < best[0]):
                    best = away, (p.x, p.y)
    return best[1] if best else None


def _unit(x, y):
    length = math.hypot(x, y)
    return x / length, y / length

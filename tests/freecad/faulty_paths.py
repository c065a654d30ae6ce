"""Paths with a fault put into them: a gouge, a rapid through what stands, a plunge."""

import math

import numpy
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
    at, level, walls = {}, None, _walls(models)
    for number, command in enumerate(commands):
        before = dict(at)
        at.update({k: v for k, v in command.Parameters.items() if k in "XYZ"})
        if command.Name not in ("G1", "G2", "G3") or len(before) < 3 or at["Z"] != before["Z"]:
            continue
        level = at["Z"]
        wall = _nearest_wall(walls, at["X"], at["Y"], level, radius)
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


def _walls(models):
    """Points of the models' edges, n x 3: x, y and the lowest z of the edge."""
    rows = [
        (p.x, p.y, edge.BoundBox.ZMin)
        for model in models
        for edge in model.Edges
        if not edge.Degenerated
        for p in edge.discretize(Number=max(2, math.ceil(edge.Length / 0.2) + 1))
    ]
    return numpy.array(rows).reshape(-1, 3)


def _nearest_wall(walls, x, y, level, radius):
    """(x, y) of a wall that a tool touches; None where it touches none."""
    away = numpy.hypot(walls[:, 0] - x, walls[:, 1] - y)
    touched = (walls[:, 2] >= level + 0.5) & (abs(away - radius) < TOUCHES)
    if not touched.any():
        return None
    nearest = numpy.argmin(numpy.where(touched, away, math.inf))
    return tuple(walls[nearest, :2])


def _unit(x, y):
    length = math.hypot(x, y)
    return x / length, y / length

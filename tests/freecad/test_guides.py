"""Guides of finishing passes from edges in any order, each running either way."""

import math
import random

import Part
import pytest
from evenload.geometry import guides
from FreeCAD import Vector

CORNERS = [(0, 0), (10, 2), (20, -1), (30, 3), (37, 9)]


def edges_of(corners, chance, y=0):
    """Lines and arcs from corner to corner, in any order, each running either way."""
    places, edges = [Vector(x, y + each, 0) for x, each in corners], []
    for a, b in zip(places, places[1:]):
        start, end = (a, b) if chance.random() < 0.5 else (b, a)
        middle = (a + b) / 2 + Vector(0, 0.7, 0)
        is_line = chance.random() < 0.5
        edge = Part.makeLine(start, end) if is_line else Part.Arc(start, middle, end).toShape()
        if chance.random() < 0.5:
            edge.reverse()
        edges.append(edge)
    chance.shuffle(edges)
    return edges


def feature(doc, edges):
    obj = doc.addObject("Part::Feature", "Edges")
    obj.Shape = Part.makeCompound(edges)
    return obj


@pytest.mark.parametrize("seed", range(12))
def test_edges_that_meet_are_one_line(doc, seed):
    chance = random.Random(seed)
    pairs = [edges_of(CORNERS[: 2 + seed % 4], chance), edges_of(CORNERS, chance, y=40)]
    found = guides.of([(feature(doc, edges), ("",)) for edges in pairs])
    for edges, corners in zip(pairs, (CORNERS[: 2 + seed % 4], CORNERS)):
        (line,) = (each for each in found if (each[0][1] > 20) == (edges[0].CenterOfMass.y > 20))
        length = sum(map(math.dist, line, line[1:]))
        assert length == pytest.approx(sum(edge.Length for edge in edges), rel=1e-3)
        ends = sorted((line[0][0], line[-1][0]))
        assert ends == pytest.approx([corners[0][0], corners[-1][0]], abs=1e-6)


@pytest.mark.parametrize("count", [1, 3])
def test_other_numbers_of_lines_are_refused(doc, count):
    chance = random.Random(count)
    edges = [edge for k in range(count) for edge in edges_of(CORNERS, chance, y=40 * k)]
    with pytest.raises(ValueError, match="need two of them .* makes %d lines" % count):
        guides.of([(feature(doc, edges), ("",))])

"""A floor with the ground beyond those of its sides that have no wall, but stock beyond them.

The tool could not clear such a floor from within it: every corner between two such sides would stay
as round as the tool, and what narrows towards one would stay as a whole. So the floor goes on to
the edge of the stock, or, where that is far away, as far as the tool must come out.
"""

from dataclasses import dataclass

import FreeCAD
import Part

from evenload import compiled
from evenload.geometry.floor import (
    CURVE_SHARE,
    LEAST_OVERLAP,
    Floor,
    face_of,
    faces_within,
    inside,
    is_exact,
    oriented,
    wire_of,
)
from evenload.geometry.ground_beside import (
    around,
    beside_bare,
    border_of,
    farthest,
    middle,
    nearest_distance,
    split,
)
from evenload.planar import DEFLECTION, flattened

# Tool diameters: the floor goes on to the edge of the stock where no stock is further out than the
# first, and none up to the second.
TO_THE_EDGE, NONE_UP_TO = 2.5, 3.0
# Otherwise by the tool's radius, as FreeCAD's own extensions do by default; by its diameter where
# what stands near an edge, such as a boss, would leave the tool no way round it, and over a lower
# floor, whose own corners are as round as those of this one.
LITTLE, ENOUGH = 0.5, 1.0
FAR = 1.0  # tool diameters: Report names what is cleared further out than this
SAME_POINT = 1e-6  # mm: vertices nearer to each other than this are one


@dataclass
class Continuation:
    """What `continued` makes of a floor."""

    outer: list  # of (x, y, bulge, open)
    islands: list
    slack: float  # mm, as that of a Floor
    distance: float  # mm from the floor, up to which its ground goes at the most
    to_the_edge: bool  # of the stock, which lies nowhere beyond that


@dataclass
class Beyond:
    """Where stock stood beyond a floor, for what Report says of it."""

    before: list  # the outer chain that the floor had
    places: list  # (x, y) where those of its pieces begin
    left: list  # (such a place, (x, y) further out where stock stays for this floor's part)
    distance: float = 0.0  # mm from the floor, up to which it is cleared there


def continued(
    floor, walled, walls, z, others, over_lower, tool_diameter, tolerance, partly_open=True
):
    """The Continuation of `floor` beyond those pieces of its outer chain, which goes
    counter-clockwise, that are not `walled`, a truth value each. None where there is no ground.

    On that ground the stock stands higher than z, mm, and the model nowhere, nor is it part of
    `others`, Floors. over_lower: whether it may lead over lower floors, at whose sides the tool
    leaves round corners, too. tool_diameter and tolerance in mm.
    partly_open: as for shape.floors. Without it the ground goes on out of the stock, or corners at
    the stock's edge would stay, where the tool does not come in. Raises ValueError or Part.OCCError
    where the geometry has errors.
    """
    within = CURVE_SHARE * tolerance
    obstacles = walls.model_outlines(z, floor.z) + [_outlines_of(o, floor.z) for o in others]
    bare = beside_bare(floor, walled, NONE_UP_TO * tool_diameter)
    ground = _divided(bare, obstacles, False)
    if partly_open:
        in_stock = _divided(ground, walls.stock_outlines(z, floor.z), True)
    else:
        in_stock = ground
    to_the_edge = partly_open and _is_edge_near(floor, ground, in_stock, tool_diameter)
    reach, grown = NONE_UP_TO, None
    if to_the_edge:
        grown = _joined(floor, in_stock, obstacles, within)
    else:
        found = {}
        for diameters in (ENOUGH,) if over_lower else (LITTLE, ENOUGH):
            near = around(floor, diameters * tool_diameter)
            border = [wire_of(chain, floor.z) for chain in near], [flattened(c) for c in near]
            faces = _divided(in_stock, [border], True)
            found[diameters] = _joined(floor, faces, obstacles, within)
        reach = ENOUGH if over_lower else _best(found, floor, tool_diameter)
        grown = found[reach]
    if grown is None:
        return None
    region, is_exactly_so = grown
    outer = oriented(list(region.outer), counter_clockwise=True)
    islands = [oriented(list(island), counter_clockwise=False) for island in region.islands]
    return Continuation(
        outer,
        floor.islands + islands,
        floor.slack if is_exactly_so else max(floor.slack, within),
        reach * tool_diameter,
        to_the_edge,
    )


def note_of(floor, floors, tool_diameter):
    """What Report says of the stock beyond one of the `floors`, which has become one with others,
    it may be: where some of it stays, or that it is cleared although it is far from the floor. None
    otherwise.
    """
    left = [
        place
        for beyond in floor.beyond
        for place, further in beyond.left
        if not any(each.contains(*further) for each in floors)
    ]
    if left:
        return "%s: it is cleared up to %g mm from the face, and what lies further out stays." % (
            sides_of(floor.name, left),
            round(max(beyond.distance for beyond in floor.beyond if beyond.left), 3),
        )
    befores = [beyond.before for beyond in floor.beyond]
    known = {_rounded(vertex) for before in befores for vertex in before}
    new = [vertex[:2] for vertex in floor.outer if _rounded(vertex) not in known]
    distance = farthest(new, befores)
    if distance <= FAR * tool_diameter:
        return None
    places = [place for beyond in floor.beyond for place in beyond.places]
    return "%s: it is cleared to the edge of the stock, up to %g mm from the face." % (
        sides_of(floor.name, places),
        round(distance, 3),
    )


def note_of_nothing(name, places):
    """The same of a floor that could not be continued."""
    return (
        "%s: it is cleared no further than %s, for the ground there lies behind walls or belongs "
        "to another face or outline of the operation."
        % (sides_of(name, places), "these sides" if len(places) > 1 else "that side")
    )


def sides_of(name, places):
    """The beginning of a sentence on a floor's sides that begin in `places`."""
    at = "near (%.3f, %.3f)" % places[0]
    if len(places) == 1:
        return "%s has stock beyond a side without a wall, %s" % (name, at)
    return "%s has stock beyond %d sides without a wall, the first %s" % (name, len(places), at)


def _outlines_of(floor, z):
    """A floor as the outlines that walls.model_outlines gives."""
    chains = [floor.outer, *floor.islands]
    return [wire_of(chain, z) for chain in chains], [flattened(chain) for chain in chains]


def _divided(faces, outlines, are_within):
    """The parts of faces that lie within some outlines, or outside of all."""
    edges = [edge for wires, _ in outlines for wire in wires for edge in wire.Edges]
    covers = [cover for wires, _ in outlines for cover in faces_within(wires)]
    result = []
    for face in split(faces, edges):
        at = FreeCAD.Vector(*middle(face), face.BoundBox.ZMax)
        # Of the geometry itself: chords would not see what lies between them and an arc.
        if any(cover.isInside(at, SAME_POINT, True) for cover in covers) == are_within:
            result.append(face)
    return result


def _is_edge_near(floor, ground, in_stock, tool_diameter):
    """Whether a floor's ground ends at the edge of the stock, within TO_THE_EDGE of the floor and
    not just at walls of the model, where the tool cannot come in.
    """
    beside = _adjoining(floor, in_stock)
    area = sum(face.Area for face in _adjoining(floor, ground))
    if area <= sum(face.Area for face in beside) + LEAST_OVERLAP:
        return False
    points = [point for face in beside for point in border_of(face)[0]]
    return farthest(points, [floor.outer]) <= TO_THE_EDGE * tool_diameter + DEFLECTION


def _adjoining(floor, faces):
    """Those of the faces, which lie beside a floor, that have part of an edge in common with it."""
    return [
        face
        for face in faces
        if nearest_distance(
            [
                (p.x, p.y)
                for e in face.Edges
                for p in [e.valueAt(0.5 * (e.FirstParameter + e.LastParameter))]
            ],
            floor.outer,
        )
        <= SAME_POINT + DEFLECTION
    ]


def _joined(floor, faces, obstacles, within):
    """(Region, whether it has every curve exactly) of a floor without its islands and the faces
    that adjoin it; None where none does. Its islands have something of the obstacles in them;
    others are gaps of the stock.
    """
    own = _face(floor.outer, floor.z)
    if not faces:
        return None
    fused = own.fuse(faces).removeSplitter()
    inner = FreeCAD.Vector(*middle(own), floor.z)
    whole = next(face for face in fused.Faces if face.isInside(inner, SAME_POINT, True))
    if whole.Area < own.Area + LEAST_OVERLAP:
        return None
    regions = compiled.occt().regions_from_brep(whole.exportBrepToString(), within)
    ((_, outer, islands),) = regions
    islands = [list(island) for island in islands]
    kept = [island for island in islands if _has_within(island, obstacles)]
    return compiled.core().Region(list(outer), kept), is_exact(whole)


def _has_within(chain, outlines):
    """Whether any point of the outlines lies within a chain, or on it."""
    polygon = flattened(chain)
    return any(
        nearest_distance(points, chain) <= DEFLECTION or inside(points, [polygon]).any()
        for _, polygons in outlines
        for points in polygons
    )


def _face(chain, z):
    return Part.Face(wire_of(chain, z))


def _best(found, floor, tool_diameter):
    """LITTLE or ENOUGH, the keys of `found`, whose values are as _joined gives them: the one with
    which the tool reaches more of a floor.
    """
    if found[LITTLE] is None or found[ENOUGH] is None:
        return ENOUGH if found[LITTLE] is None else LITTLE
    face = face_of(floor)
    little, enough = (
        _reached(found[key][0], floor, face, tool_diameter) for key in (LITTLE, ENOUGH)
    )
    return ENOUGH if enough > little + LEAST_OVERLAP else LITTLE


def _reached(region, floor, face, tool_diameter):
    """mm2 of a floor's face that the tool reaches in a region."""
    core = compiled.core()
    islands = [*map(list, region.islands), *floor.islands]
    reach = core.reachable_ground([core.Region(list(region.outer), islands)], tool_diameter, 0.0)
    faces = [
        face_of(Floor("", floor.z, list(each.outer), [*map(list, each.islands)], True))
        for each in reach
    ]
    return sum(part.Area for part in face.common(faces).Faces) if faces else 0.0


def _rounded(vertex):
    return tuple(round(value / SAME_POINT) for value in vertex[:2])

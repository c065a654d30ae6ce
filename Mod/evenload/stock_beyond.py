"""A floor with the ground beyond those of its sides that have no wall, but stock beyond them.

The tool could not clear such a floor from within it: every corner between two such sides would stay
as round as the tool, and what narrows towards one would stay as a whole. So the floor goes on to
the edge of the stock, or, where that is far away, as far as the tool must come out.
"""

import math

import Part

from evenload import compiled
from evenload.floor import LEAST_OVERLAP, Floor, face_of, oriented

# Tool diameters: the floor goes on to the edge of the stock where no stock is further out than the
# first, and none up to the second.
TO_THE_EDGE, NONE_UP_TO = 2.5, 3.0
# Otherwise by the tool's radius, as FreeCAD's own extensions do by default; by its diameter where
# what stands near an edge, such as a boss, would leave the tool no way round it.
LITTLE, ENOUGH = 0.5, 1.0
# mm above a floor: walls are looked for there, too. At its foot a fillet leaves a strip between
# itself and the edge, of which less than this is cut away.
AT_FOOT = 0.001
SMOOTH = 1e-6  # rad: less is no corner
AT_CENTRE = 1e-3  # share of an arc's radius: so near its centre there is no ground to speak of


def continued(floor, walled, walls, heights, tool_diameter):
    """(outer chain, islands) of `floor` with the ground beyond those pieces of its outer chain that
    are not `walled`, a truth value each. On that ground stands the stock at the first of `heights`,
    mm, the lowest first, and the model at none of them. None where the floor would not stay one
    piece, as where the stock has gaps in it.
    """
    face = face_of(floor)
    stock = walls.stock_faces(heights[0], floor.z)
    standing = _behind(floor, walled, NONE_UP_TO * tool_diameter)
    for height in [floor.z + AT_FOOT, *heights]:
        standing += walls.model_faces(height, floor.z)
    # The floor stays as it is, whatever hangs over it.
    standing = [
        part
        for each in standing
        for part in (each.cut(face).Faces if each.common(face).Area > LEAST_OVERLAP else [each])
    ]

    def region_with(distance):
        grown = compiled.core().offset([_region(floor.outer)], distance * tool_diameter)
        ground = Part.Compound([_face(each, floor.z) for each in grown]).common(stock)
        regions = _regions(ground.cut(standing) if standing else ground)
        own = [r for r in regions if face.common(_face(r, floor.z)).Area > LEAST_OVERLAP]
        return own[0] if len(own) == 1 else None

    region = region_with(TO_THE_EDGE)
    if region is None:
        return None
    if region_with(NONE_UP_TO).area > region.area + LEAST_OVERLAP:
        region, further = region_with(LITTLE), region_with(ENOUGH)
        if _reached(further, face, tool_diameter) > _reached(region, face, tool_diameter):
            region = further
    outer = oriented(list(region.outer), counter_clockwise=True)
    return outer, [oriented(list(island), counter_clockwise=False) for island in region.islands]


def _behind(floor, walled, distance):
    """Faces on the ground behind the walled pieces of a floor's outer chain, up to a distance in
    mm, that does not lie beyond the others.
    """
    beside = {True: [], False: []}
    n = len(floor.outer)
    for i, is_walled in enumerate(walled):
        beside[bool(is_walled)].append(_strip(floor, i, distance))
        wedge = _wedge(floor, i, distance)
        if wedge is not None:
            beside[bool(is_walled or walled[(i - 1) % n])].append(wedge)
    return [
        part
        for each in beside[True]
        for part in (each.cut(beside[False]).Faces if beside[False] else [each])
    ]


def _directions(floor, i):
    """rad: of piece i of the outer chain at its start and its end."""
    (x0, y0, bulge, *_), (x1, y1, *_) = floor.outer[i], floor.outer[(i + 1) % len(floor.outer)]
    along, half = math.atan2(y1 - y0, x1 - x0), 2 * math.atan(bulge)
    return along - half, along + half


def _out(point, direction, distance):
    """`distance` mm to the right of a direction in rad."""
    x, y = point[:2]
    return x + distance * math.sin(direction), y - distance * math.cos(direction)


def _strip(floor, i, distance):
    """The face of all that lies to the right of piece i, along its normals."""
    start, end = floor.outer[i], floor.outer[(i + 1) % len(floor.outer)]
    first, last = _directions(floor, i)
    bulge = start[2]
    if bulge < 0:  # about a centre outside: no further than there
        radius = 0.5 * math.dist(start[:2], end[:2]) / math.sin(2 * math.atan(-bulge))
        distance = min(distance, (1 - AT_CENTRE) * radius)
    chain = [
        (*start[:2], bulge, False),
        (*end[:2], 0.0, False),
        (*_out(end, last, distance), -bulge, False),
        (*_out(start, first, distance), 0.0, False),
    ]
    return face_of(Floor("", floor.z, chain, [], True))


def _wedge(floor, i, distance):
    """The face of all that lies between the normals at the start of piece i and at the end of the
    one before; None where these meet or are one.
    """
    before, after = _directions(floor, i - 1)[1], _directions(floor, i)[0]
    turn = math.remainder(after - before, 2 * math.pi)
    if turn < SMOOTH:
        return None
    at = floor.outer[i]
    chain = [
        (*at[:2], 0.0, False),
        (*_out(at, before, distance), math.tan(turn / 4), False),
        (*_out(at, after, distance), 0.0, False),
    ]
    return face_of(Floor("", floor.z, chain, [], True))


def _reached(region, face, tool_diameter):
    """mm2 of a face that the tool reaches in a region, less what is rounding."""
    reach = compiled.core().reachable_ground([region], tool_diameter, 0.0)
    if not reach:
        return 0.0
    area = face.common([_face(each, face.BoundBox.ZMax) for each in reach]).Area
    return round(area / LEAST_OVERLAP) * LEAST_OVERLAP


def _region(outer, islands=()):
    return compiled.core().Region(outer, list(islands))


def _regions(faces):
    """The Regions of a shape's level faces, those that adjoin each other as one."""
    faces = faces.removeSplitter().Faces
    if not faces:
        return []
    return [
        _region(list(outer), [list(island) for island in islands])
        for _, outer, islands in compiled.occt().regions_from_brep(
            Part.Compound(faces).exportBrepToString(), AT_FOOT
        )
    ]


def _face(region, z):
    islands = [list(island) for island in region.islands]
    return face_of(Floor("", z, list(region.outer), islands, True))

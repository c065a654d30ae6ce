"""Base geometry of an operation -> regions of the core.

Faces parallel to XY, whole sketches and closed edges become regions. A face's edges that have no
wall above them, and nothing of the stock beyond them, are marked open: there the tool may come in
from outside.
"""

from dataclasses import replace

from evenload import compiled, waiting
from evenload.geometry import covered, open_edges, stock_beyond
from evenload.geometry.floor import CURVE_SHARE, SAME_HEIGHT, Floor
from evenload.geometry.items import element_of, items_of, placed, sentence_of, slack_of
from evenload.geometry.meeting import (
    joined,
    kept_apart,
    may_cover,
    may_join,
    refuse_overlaps,
)
from evenload.geometry.slots import slots_of, united, within_stock


def floors(
    base, models, stock, tool_diameter, tolerance, slot=None, partly_open=True, depth_of=None
):
    """The floors that `base` ([(object, sub-element names), ...]) describes, in its order.

    models: shapes of the job's model, stock: shape of its stock or None, both in place;
    tool_diameter and tolerance in mm. slot: callable(chain, closed, name of the geometry) -> the
    core's Region of the slot round a sketch's or edges' curve, or None where it is an outline;
    slots that meet are one floor. Without it open curves are refused. partly_open: False for
    operations that cannot take an outline that is open beside walls; where stock stands beyond a
    floor's sides, it goes on by no more than it must then, and has no open edge. depth_of:
    callable(z, whether it is a face) -> z in mm down to which what lies at that height is cut;
    None: down to each face, or to where outlines are drawn. Ground that the model covers is left
    out of its faces. Raises ValueError with a sentence that names the geometry.
    """
    found, slots = [], []
    for item in items_of(base, models):
        waiting.go_on()
        read = slots_of(item, tolerance, slot) if slot and not item.is_face else []
        slots += read
        if read:
            continue
        read = _read(item, tolerance)
        if item.is_face and open_edges.enclosed(item.shape, models):
            for floor in read:
                floor.enclosed = True
        found += read
    slots = united(slots)
    if depth_of is not None:
        for floor in (*found, *slots):
            floor.depth = depth_of(floor.z, floor.is_face)
    for each in slots:
        found += within_stock(each, stock)
    if not found:
        raise ValueError("The operation has no base geometry: pick a face or a sketch for it.")
    refuse_overlaps(found)
    found = [
        part for floor in found for part in _uncovered(floor, models, tool_diameter, tolerance)
    ]
    walls = open_edges.Walls(models, stock)
    for floor in found:
        if floor.is_face:
            open_edges.drop_holes(floor, walls)
    before = [replace(floor) for floor in found]
    for floor in found:
        if floor.is_face:
            others = [o for o in before if not (may_join(floor, o) or may_cover(floor, o))]
            over = any(may_cover(floor, other) for other in before)
            open_edges.extend(floor, walls, others, over, tool_diameter, tolerance, partly_open)
    found = joined(kept_apart(found, before), tolerance)
    for floor in found:
        if floor.is_face and (partly_open or not floor.grown):
            open_edges.mark(floor, walls, tool_diameter)
        note = stock_beyond.note_of(floor, found, tool_diameter) if floor.grown else None
        floor.notes += [note] if note else []
    return found


def _uncovered(floor, models, tool_diameter, tolerance):
    if not floor.of_solid:  # drawn by itself, it may well lie in the model
        return [floor]
    return covered.uncovered(floor, models, tool_diameter, tolerance)


def heights(base):
    """The z in mm of everything in `base` that is there and parallel to XY."""
    result = []
    for obj, names in base:
        shape = placed(obj)
        if shape is None:
            continue
        for name in names or ("",):
            part = element_of(shape, name)
            if part is not None and part.Vertexes:
                z = [v.Z for v in part.Vertexes]
                if max(z) - min(z) < SAME_HEIGHT and part.BoundBox.ZLength < SAME_HEIGHT:
                    result.append(z[0])
    return result


def _read(item, tolerance):
    occt = compiled.occt()
    within = CURVE_SHARE * tolerance
    try:
        found = occt.regions_from_brep(item.shape.exportBrepToString(), within)
    except occt.ShapeError as error:
        raise ValueError(sentence_of(item, error)) from None
    slack = slack_of(item, within)
    return [
        Floor(
            item.name,
            z,
            list(outer),
            [list(i) for i in islands],
            item.is_face,
            of_solid=item.of_solid,
            slack=slack,
            parts=item.parts,
        )
        for z, outer, islands in found
    ]

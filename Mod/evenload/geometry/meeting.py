"""Floors that meet: refused, joined, or kept apart."""

from dataclasses import replace

import Part

from evenload import compiled
from evenload.geometry import stock_beyond
from evenload.geometry.floor import (
    CURVE_SHARE,
    LEAST_OVERLAP,
    SAME_HEIGHT,
    Floor,
    face_of,
    is_exact,
)
from evenload.words import in_order, name_of


def refuse_overlaps(found):
    """Raises ValueError where two floors at one height overlap, which would be cut as one."""
    for i, floor in enumerate(found):
        for other in found[:i]:
            if abs(floor.z - other.z) <= SAME_HEIGHT and _overlap(floor, other):
                raise ValueError(
                    "%s and %s overlap: draw what they enclose together as one, or use two "
                    "operations." % (other.name, floor.name)
                )


def _overlap(a, b):
    """Whether two floors have more in common than an edge, seen from above."""
    a, b = face_of(a), face_of(replace(b, z=a.z))
    return a.BoundBox.intersect(b.BoundBox) and a.common(b).Area > LEAST_OVERLAP


def may_join(floor, other):
    """Whether two floors may become one when they grow; a sketch's outline is the limit of what it
    encloses.
    """
    return floor.is_face and other.is_face and abs(floor.z - other.z) <= SAME_HEIGHT


def may_cover(floor, other):
    """Whether a floor may go on over another when it grows: a lower face, which is cut after it."""
    return floor.is_face and other.is_face and floor.depth > other.depth + SAME_HEIGHT


def kept_apart(found, before):
    """The floors, those as they were before they grew which overlap now with one before them that
    they can neither join nor cover, nor be covered by.
    """
    result = []
    for floor, own in zip(found, before):
        blockers = (o for o in result if not _get_along(floor, o) and _overlap(floor, o))
        other = next(blockers, None) if floor.grown else None
        if other is not None:
            places = [place for beyond in floor.beyond for place in beyond.places]
            own.notes = [
                "%s: it is not cleared there, for it would meet what is cleared beyond %s."
                % (stock_beyond.sides_of(floor.name, places), other.name)
            ]
            floor = own
        result.append(floor)
    return result


def _get_along(floor, other):
    return may_join(floor, other) or may_cover(floor, other) or may_cover(other, floor)


def joined(found, tolerance):
    """The floors, each that has grown as one with those faces at its height that it overlaps or
    touches now, in the place of the first.
    """
    groups = []
    for floor in found:
        met = [group for group in groups if any(_met(floor, other) for other in group)]
        if not met:
            groups.append([floor])
            continue
        met[0] += [other for group in met[1:] for other in group] + [floor]
        groups = [group for group in groups if not any(group is gone for gone in met[1:])]
    return [joined for group in groups for joined in _union(group, tolerance)]


def _met(floor, other):
    """Whether two floors, one of which has grown, are one now."""
    if not (may_join(floor, other) and (floor.grown or other.grown)):
        return False
    a, b = face_of(floor), face_of(other)
    return a.BoundBox.intersect(b.BoundBox) and len(a.fuse(b).removeSplitter().Faces) == 1


def _union(group, tolerance):
    """The floors of a group as one."""
    if len(group) == 1:
        return group
    faces = [face_of(floor) for floor in group]
    fused = Part.Compound(faces[0].fuse(faces[1:]).removeSplitter().Faces)
    parts = in_order(dict.fromkeys(part for floor in group for part in floor.parts))
    within = CURVE_SHARE * tolerance
    slack = max([floor.slack for floor in group] + ([] if is_exact(fused) else [within]))
    notes = list(dict.fromkeys(note for floor in group for note in floor.notes))
    try:
        found = compiled.occt().regions_from_brep(fused.exportBrepToString(), within)
    except compiled.occt().ShapeError as error:
        raise ValueError("%s: %s" % (name_of(parts), error)) from None
    return [
        Floor(
            name_of(parts),
            group[0].z,
            list(outer),
            [list(island) for island in islands],
            True,
            of_solid=group[0].of_solid,
            depth=group[0].depth,
            slack=slack,
            notes=notes,
            parts=parts,
            grown=True,
            beyond=[beyond for floor in group for beyond in floor.beyond],
        )
        for _, outer, islands in found
    ]

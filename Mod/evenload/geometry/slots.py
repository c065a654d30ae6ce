"""Slots round the curves of sketches and edges, as floors within the stock."""

from dataclasses import replace

import Part

from evenload import compiled
from evenload.geometry import body
from evenload.geometry.floor import (
    ABOVE_FLOOR,
    CURVE_SHARE,
    LEAST_OVERLAP,
    SAME_HEIGHT,
    UP,
    Floor,
    face_of,
    wire_of,
)
from evenload.geometry.items import sentence_of, slack_of
from evenload.words import listed


def slots_of(item, tolerance, slot):
    """The floors of slots round an item's curves; none where they are outlines."""
    within = CURVE_SHARE * tolerance
    occt = compiled.occt()
    try:
        curves = occt.curves_from_brep(item.shape.exportBrepToString(), within)
    except occt.ShapeError as error:
        raise ValueError(sentence_of(item, error)) from None
    slack, result = slack_of(item, within), []
    for z, chain, closed in curves:
        region = slot(chain, closed, item.name)
        if region is not None:
            outer, islands = list(region.outer), [list(island) for island in region.islands]
            result.append(Floor(item.name, z, outer, islands, False, slack=slack))
    return result


def united(slots):
    """The slots, those at one height that overlap as one floor."""
    result = []
    for z in dict.fromkeys(round(slot.z, 5) for slot in slots):
        level = [slot for slot in slots if round(slot.z, 5) == z]
        if len(level) == 1:
            result += level
            continue
        faces = [face_of(slot) for slot in level]
        fused = Part.Compound(faces[0].fuse(faces[1:]).removeSplitter().Faces)
        name = listed([slot.name for slot in level], " and ", "others")
        slack = max(slot.slack for slot in level)
        result += [
            Floor(name, z, list(outer), [list(island) for island in islands], False, slack=slack)
            for _, outer, islands in compiled.occt().regions_from_brep(
                fused.exportBrepToString(), SAME_HEIGHT
            )
        ]
    return result


def within_stock(slot, stock):
    """The floors that the stock above its depth leaves of a slot, open where it runs out of the
    stock.
    """
    if stock is None:
        return [slot]
    standing = body.of(stock).standing(slot.depth + ABOVE_FLOOR)
    face, ground = face_of(slot), [each.translated(UP * slot.z) for each in standing]
    inside = face.common(ground) if ground else Part.Shape()
    if not inside.Faces:
        raise ValueError(
            "%s lies outside the stock: move it, or make the stock larger." % slot.name
        )
    if inside.Area > face.Area - LEAST_OVERLAP:
        return [slot]
    border = Part.Compound([wire for each in ground for wire in each.Wires])
    result = []
    for _, outer, islands in compiled.occt().regions_from_brep(
        Part.Compound(inside.removeSplitter().Faces).exportBrepToString(), SAME_HEIGHT
    ):
        edges = wire_of(outer, slot.z).OrderedEdges
        middles = [edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter)) for edge in edges]
        outside = [border.distToShape(Part.Vertex(p))[0] < SAME_HEIGHT for p in middles]
        chain = [(*vertex[:3], is_open) for vertex, is_open in zip(outer, outside)]
        islands = [list(island) for island in islands]
        result.append(replace(slot, outer=chain, islands=islands))
    return result

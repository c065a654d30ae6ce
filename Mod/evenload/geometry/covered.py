"""What stands above a floor is never milled: the ground under it is left out of the floor.

That may be of the same model, as the lips of a T-slot are, or of another one of the job, such as
a pin in a pocket.
"""

import Part

from evenload import compiled
from evenload.geometry import body
from evenload.geometry.floor import (
    ABOVE_FLOOR,
    CURVE_SHARE,
    LEAST_OVERLAP,
    UP,
    face_of,
    is_exact,
    with_chains,
)


def uncovered(floor, models, tool_diameter, tolerance):
    """The Floors that are left of one, a face, with a note where that is not all of it.

    models: shapes in place; tool_diameter and tolerance in mm. Raises ValueError, with the floor's
    name and a place, where nothing is left or the ground cannot be found.
    """
    z, region = floor.z + ABOVE_FLOOR, floor.region()
    bodies = [body.of(model) for model in models]
    found = [(each, each.highest_over(region, z, tool_diameter)) for each in bodies]
    found = [(each, place) for each, place in found if place is not None]
    if not found:
        return [floor]
    x, y, _ = max((place for _, place in found), key=lambda place: place[2])
    try:
        covers = [face for each, _ in found for face in each.standing(z)]
        left = face_of(floor).cut([face.translated(UP * floor.z) for face in covers])
        left = [face for face in left.removeSplitter().Faces if face.Area > LEAST_OVERLAP]
    except (ValueError, Part.OCCError) as error:
        raise ValueError(
            "%s lies partly under the model, near (%.3f, %.3f), and the rest of it could not be "
            "found (%s): draw what is to be cleared as a sketch." % (floor.name, x, y, error)
        ) from None
    if not left:
        raise ValueError(
            "%s lies wholly under the model, which stands above it near (%.3f, %.3f): no tool "
            "reaches it from above. Pick another face." % (floor.name, x, y)
        )
    within = CURVE_SHARE * tolerance
    whole = Part.Compound(left)
    regions = compiled.occt().regions_from_brep(whole.exportBrepToString(), within)
    note = "%s lies partly under the model, near (%.3f, %.3f): what is covered is left out." % (
        floor.name,
        x,
        y,
    )
    result = [with_chains(floor, outer, islands) for _, outer, islands in regions]
    for part in result:
        part.slack = floor.slack if is_exact(whole) else max(floor.slack, within)
        part.notes = []
    result[0].notes = [*floor.notes, note]
    return result

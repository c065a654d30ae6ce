"""Guides of finishing passes: picked edges and sketches as two lines, seen from above."""

import Part

from evenload.geometry.items import element_of, placed

CHORDS = 0.002  # mm by which chords may leave the edges
NEEDED = "Passes between guides need two of them beside the faces: pick two edges, or two chains."


def of(base):
    """[[(x, y), ...], [(x, y), ...]] of the edges and whole objects in `base`, [(object, names),
    ...]; what meets end to end is one guide. Raises ValueError where that is not two lines.
    """
    edges = [edge for obj, names in base for name in names or ("",) for edge in _edges(obj, name)]
    chains = Part.sortEdges(edges) if edges else []
    if len(chains) != 2:
        raise ValueError("%s What is picked makes %d lines." % (NEEDED, len(chains)))
    return [_points(chain) for chain in chains]


def _edges(obj, name):
    shape = placed(obj)
    part = element_of(shape, name) if shape is not None else None
    if part is None or not part.Edges:
        what = "%s on %s" % (name, obj.Label) if name else "edge on %s" % obj.Label
        raise ValueError("There is no %s: pick the geometry anew." % what)
    return part.Edges


def _points(chain):
    """Places along edges that follow each other, whichever way each of them runs."""
    pieces = [edge.discretize(Deflection=CHORDS) for edge in chain]
    if len(pieces) > 1 and _is_nearer(pieces[1], pieces[0][0], pieces[0][-1]):
        pieces[0].reverse()
    points = pieces[0]
    for piece in pieces[1:]:
        if _is_nearer(points[-1:], piece[-1], piece[0]):
            piece.reverse()
        points += piece[1:]
    return [(p.x, p.y) for p in points]


def _is_nearer(piece, one, other):
    """Whether an end of a piece is nearer to one place than to another."""

    def off(place):
        return min(place.distanceToPoint(end) for end in (piece[0], piece[-1]))

    return off(one) < off(other)

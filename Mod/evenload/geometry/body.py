"""A model or the stock of a job as what stands over the plane.

Made from the shape as it is, once for each state of it: heights over the plane, the ground over
which it stands higher than a given height, and points of its surface. All shapes are in place, in
mm.
"""

import functools

import numpy
import Part

from evenload import compiled, waiting
from evenload.geometry.body_face import STRIP, BodyFace
from evenload.geometry.floor import UP, faces_within, points_of
from evenload.geometry.in_plane import (
    DEFLECTION,
    FLAT,
    drawn_in_plane,
    is_seam,
    points_along,
    triangles_of,
    under_triangles,
)

COARSE = 0.01  # mm: triangles leave round surfaces by this where no wall is taken from them
# mm: nearer to a region's border stand its own walls, as wide as triangles leave them.
INSET = 0.02
LOOKS = 0.25  # tool diameters between places where something is looked for over a region
MOST_LEANING = 80  # faces that are united exactly; more, or such that lean both ways, as triangles
MOST_LEVEL = 300  # level faces of which the same holds
MOST_KEPT = 64  # bodies that are remembered

_kept = []  # of (shape, Body), the latest last


def of(shape):
    """The Body of a shape, the same one as long as the shape is."""
    for i, (known, body) in enumerate(_kept):
        if known.isSame(shape):
            _kept.append(_kept.pop(i))
            return body
    body = Body(shape)
    _kept.append((shape, body))
    del _kept[:-MOST_KEPT]
    return body


def models_of(job):
    """[(label, Body), ...] of a job's models that have a shape."""
    shapes = [(model.Label, getattr(model, "Shape", None)) for model in job.Model.Group]
    return [(label, of(shape)) for label, shape in shapes if shape and not shape.isNull()]


class Body:
    """A shape's heights, its standing parts and its points. Raises ValueError from its functions
    for shapes that OpenCASCADE cannot cut or project.
    """

    def __init__(self, shape):
        self.shape = shape
        self.box = shape.BoundBox
        self._is_closed = bool(shape.Solids)
        self._faces = [BodyFace(face) for face in shape.Faces]
        self._drawn = {}  # edges in the plane, by their hash: neighbours share them
        self._standing = {}
        self._outlines = {}

    @functools.cached_property
    def map(self):
        """Its upper side, as the core's HeightMap."""
        points, triangles = [], []
        for face in self._faces:
            if face.is_upright:
                continue
            waiting.go_on()
            own, corners = triangles_of(face.shape, COARSE)
            triangles += [[len(points) + k for k in triangle] for triangle in corners]
            points += own
        points = numpy.array([(p.x, p.y, p.z) for p in points]).reshape(-1, 3)
        return compiled.core().HeightMap(points, numpy.array(triangles).reshape(-1, 3))

    def highest_over(self, region, z, tool_diameter):
        """(x, y, z) of its highest place over a Region, off the region's border, where it stands
        higher than z; None without one. mm.
        """
        if not self.box.ZMax > z:
            return None
        return self.map.highest_within(region, z, INSET, LOOKS * tool_diameter)

    def is_prismatic(self, z):
        """Whether all that it has above a height is level or upright."""
        return not any(face.leans and face.box.ZMax > z + FLAT for face in self._faces)

    def standing(self, z):
        """Faces, in the plane z = 0, of the ground over which it stands higher than z. None
        overlaps another.
        """
        key = round(z, 6)
        if key not in self._standing:
            try:
                self._standing[key] = self._find_standing(z) if self.box.ZMax > z else []
            except Part.OCCError as error:
                sentence = str(error).strip().rstrip(".")
                raise ValueError(
                    "What stands above %g mm could not be found (%s)" % (round(z, 3), sentence)
                ) from None
        return self._standing[key]

    def prisms(self):
        """[(Region, top), ...] that fill the same heights over the plane; None for a body that
        leans anywhere.
        """
        if self._is_closed and self.is_prismatic(self.box.ZMin):
            return [
                (region, face.box.ZMax)
                for face in self._faces
                if face.looks_up
                for region in regions_of(face.shape)
            ]
        return None

    def outlines(self, z, at=0.0):
        """(wires in the plane z = `at`, the same as polygons) of what stands higher than z."""
        key = round(z, 6)
        if key not in self._outlines:
            wires = [wire for face in self.standing(z) for wire in face.Wires]
            self._outlines[key] = wires, [points_of(wire) for wire in wires]
        wires, polygons = self._outlines[key]
        return [wire.translated(UP * at) for wire in wires] if at else wires, polygons

    def edge_points(self, low, high, spacing):
        """Points of those of its faces' edges that reach into the box between two corners, or over
        it, n x 3, hardly further apart than `spacing` mm.
        """
        points = []
        for edge, box in self._borders:
            if _meets(box, low, high):
                waiting.go_on()
                points.append(points_along(edge, spacing))
        return numpy.vstack([numpy.zeros((0, 3)), *points])

    def section_points(self, heights, low, high, spacing):
        """The same of its faces that lean, where they pass some heights."""
        points = []
        for face in self._faces:
            if not (face.leans and _meets(face.box, low, high)):
                continue
            own = [z for z in [*heights, *face.turning] if face.box.ZMin < z < face.box.ZMax]
            for z in own:
                waiting.go_on()
                for wire in face.shape.slice(UP, z):
                    points += [points_along(edge, spacing) for edge in wire.Edges]
        return numpy.vstack([numpy.zeros((0, 3)), *points])

    @functools.cached_property
    def _borders(self):
        """[(edge, its box), ...] of all faces, each once; edges of no face bound nothing."""
        if not self.shape.Faces:
            return []
        edges = Part.Compound(self.shape.Faces).Edges
        return [(edge, edge.BoundBox) for edge in edges if not edge.Degenerated]

    def _find_standing(self, z):
        level, leaning = [], []
        for face in self._faces:
            if face.leans and face.box.ZMax > z:
                waiting.go_on()
                leaning += face.parts_above(z)
            elif not face.is_upright and face.box.ZMax > z:
                if not self._is_closed or face.looks_up:
                    level.append(face)
        shapes = [face.shape for face in level]
        if (
            len(leaning) > MOST_LEANING
            or len(level) > MOST_LEVEL
            or any(not inclination for _, inclination in leaning)
        ):
            return under_triangles(shapes + [part for part, _ in leaning])
        found = []
        for face in level:
            if face.is_askew:
                found += self._projected(face.shape)
            else:
                found.append(face.shape.translated(UP * -face.box.ZMax))
        for part, inclination in leaning:
            if not self._is_closed or inclination > 0:
                found += self._projected(part)
        if len(found) < 2:
            return found
        # Under faces that are upright but for a strip there are slits as wide as that.
        is_rounded = any(face.is_askew for face in level)
        try:
            fused = found[0].fuse(found[1:], 2 * STRIP if is_rounded else 0).removeSplitter()
            is_lost = fused.Area < max(face.Area for face in found) - STRIP
        except Part.OCCError:  # of 7.9, where 7.6 and 7.8 lose some of the faces
            is_lost = True
        return under_triangles(shapes + [part for part, _ in leaning]) if is_lost else fused.Faces

    def _projected(self, face):
        """The faces in the plane over which a face lies, none of whose lines up meets it twice."""
        waiting.go_on()
        border = [edge for edge in face.Edges if not is_seam(edge, face)]
        edges = [edge for edge in map(self._drawn_in_plane, border) if edge is not None]
        wires = [Part.Wire(each) for each in Part.sortEdges(edges)] if edges else []
        return faces_within([wire for wire in wires if wire.isClosed()])

    def _drawn_in_plane(self, edge):
        """An edge in the plane z = 0; None where it comes out as a point."""
        known = self._drawn.setdefault(edge.hashCode(), [])
        for other, drawn in known:
            if other.isSame(edge):
                return drawn
        drawn = drawn_in_plane(edge)
        known.append((edge, drawn))
        return drawn


def regions_of(shape):
    """The core's Regions of a shape's level faces and closed edges. Raises ValueError where they
    cannot be had.
    """
    core, occt = compiled.core(), compiled.occt()
    try:
        found = occt.regions_from_brep(shape.exportBrepToString(), DEFLECTION)
    except occt.ShapeError as error:
        raise ValueError(str(error)) from None
    return [core.Region(outer, islands) for _, outer, islands in found]


def _meets(box, low, high):
    """Whether a box of FreeCAD's reaches into the one between two corners, or over it."""
    return (
        box.ZMax > low[2]
        and box.XMin < high[0]
        and box.XMax > low[0]
        and box.YMin < high[1]
        and box.YMax > low[1]
    )

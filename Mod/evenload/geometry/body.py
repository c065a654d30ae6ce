"""A model or the stock of a job as what stands over the plane.

Made from the shape as it is, once for each state of it: heights over the plane, the ground over
which it stands higher than a given height, and points of its surface. All shapes are in place, in
mm.
"""

import functools
import math

import FreeCAD
import numpy
import Part

from evenload import compiled
from evenload.geometry.floor import UP, faces_within, points_of

LEVEL = 1e-9  # of unit vectors: what is as level, or as upright, as this is so exactly
# mm: planes that stand over a strip no wider than this are upright: files round directions.
STRIP = 1e-6
FLAT = 1e-9  # mm: edges that rise by less lie in a level plane
DEFLECTION = 0.005  # mm: triangles leave round surfaces by this at the most
COARSE = 0.01  # mm: the same of the heights, which no wall is taken from
# mm: nearer to a region's border stand its own walls, as wide as triangles leave them.
INSET = 0.02
LOOKS = 0.25  # tool diameters between places where something is looked for over a region
TURN = 0.5  # rad between neighbouring triangles, at the most
SAME_PARAMETER = 1e-6  # of surfaces
PROJECTED = 0.001  # mm: points on edges that are drawn anew in the plane lie as near as that
POINTS = 9  # the fewest of these on a curve
SHORTEST = 1e-7  # mm: edges that come out shorter have become points
SIGHTINGS = 7  # places along each side of a face where its inclination is looked at
MOST_LEVEL = 300  # level faces of which the same holds
MOST_LEANING = 80  # faces that are united exactly; more, or such that lean both ways, as triangles
MOST_KEPT = 64  # bodies that are remembered
OVER = 1.0  # mm by which boxes that cut a face reach beyond it

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
        self._faces = [_Face(face) for face in shape.Faces]
        self._drawn = {}  # edges in the plane, by their hash: neighbours share them
        self._standing = {}
        self._outlines = {}

    @functools.cached_property
    def map(self):
        """Its upper side, as the core's HeightMap."""
        faces = Part.Compound([face.shape for face in self._faces if not face.is_upright])
        points, triangles = _triangles(faces, COARSE)
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
        edges = [edge for edge, box in self._borders if _meets(box, low, high)]
        points = [_points_along(edge, spacing) for edge in edges]
        return numpy.vstack([numpy.zeros((0, 3)), *points])

    def section_points(self, heights, low, high, spacing):
        """The same of its faces that lean, where they pass some heights."""
        points = []
        for face in self._faces:
            if not (face.leans and _meets(face.box, low, high)):
                continue
            own = [z for z in [*heights, *face.turning] if face.box.ZMin < z < face.box.ZMax]
            for z in own:
                for wire in face.shape.slice(UP, z):
                    points += [_points_along(edge, spacing) for edge in wire.Edges]
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
            return _under_triangles(shapes + [part for part, _ in leaning])
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
        return _under_triangles(shapes + [part for part, _ in leaning]) if is_lost else fused.Faces

    def _projected(self, face):
        """The faces in the plane over which a face lies, none of whose lines up meets it twice."""
        border = [edge for edge in face.Edges if not _is_seam(edge, face)]
        edges = [edge for edge in map(self._drawn_in_plane, border) if edge is not None]
        wires = [Part.Wire(each) for each in Part.sortEdges(edges)] if edges else []
        return faces_within([wire for wire in wires if wire.isClosed()])

    def _drawn_in_plane(self, edge):
        """An edge in the plane z = 0; None where it comes out as a point."""
        known = self._drawn.setdefault(edge.hashCode(), [])
        for other, drawn in known:
            if other.isSame(edge):
                return drawn
        drawn = _in_plane(edge)
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


class _Face:
    """A face of a body, and which way it looks."""

    def __init__(self, shape):
        self.shape = shape
        self.box = shape.BoundBox
        surface = shape.Surface
        self.is_upright = is_upright(surface) or self._stands_over_a_strip(surface)
        is_level = isinstance(surface, Part.Plane) and abs(surface.Axis.z) > 1 - LEVEL
        self.looks_up = is_level and shape.normalAt(0, 0).z > 0
        self.is_askew = is_level and math.hypot(surface.Axis.x, surface.Axis.y) > LEVEL
        self.leans = not (is_level or self.is_upright)
        # Heights at which it turns over, if its axis is upright, or level.
        round_ = isinstance(surface, (Part.Sphere, Part.Toroid, Part.Cylinder))
        self.turning = [surface.Center.z] if round_ and self.leans else []

    def _stands_over_a_strip(self, surface):
        if not isinstance(surface, Part.Plane) or abs(surface.Axis.z) > 0.5:
            return False
        return abs(surface.Axis.z) * self.box.ZLength < STRIP

    def parts_above(self, z):
        """[(part of the face above z, its _inclination), ...]"""
        low, high = max(z, self.box.ZMin), self.box.ZMax
        ends = [low, *(z for z in self.turning if low + FLAT < z < high - FLAT), high]
        parts = [
            part for a, b in zip(ends, ends[1:]) for part in _between(self.shape, self.box, a, b)
        ]
        return [(part, _inclination(part)) for part in parts]


def _is_seam(edge, face):
    """Whether a face lies to both sides of an edge, where its surface closes. OpenCASCADE calls an
    edge that lies there a seam also where the face ends at it.
    """
    if edge.Degenerated or not edge.isSeam(face):
        return False
    surface = face.Surface
    middle = edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter))
    u, v = surface.parameter(middle)
    u0, u1, v0, v1 = face.ParameterRange
    whole_u0, whole_u1, whole_v0, whole_v1 = surface.bounds()
    for at, low, high, whole, closes in (
        (u, u0, u1, whole_u1 - whole_u0, surface.isUClosed()),
        (v, v0, v1, whole_v1 - whole_v0, surface.isVClosed()),
    ):
        is_at_end = min(abs(at - low), abs(at - high)) < SAME_PARAMETER
        if closes and is_at_end and high - low > whole - SAME_PARAMETER:
            return True
    return False


def is_upright(surface):
    """Whether a face's surface stands upright all over."""
    if isinstance(surface, Part.Plane):
        return abs(surface.Axis.z) < LEVEL
    if isinstance(surface, Part.Cylinder):
        return abs(surface.Axis.z) > 1 - LEVEL
    if isinstance(surface, Part.SurfaceOfExtrusion):
        return abs(surface.Direction.z) > 1 - LEVEL
    return False


def _between(face, box, low, high):
    """The parts of a face between two heights."""
    if box.ZMin > low - FLAT and box.ZMax < high + FLAT:
        return [face]
    corner = FreeCAD.Vector(box.XMin - OVER, box.YMin - OVER, low)
    slab = Part.makeBox(box.XLength + 2 * OVER, box.YLength + 2 * OVER, high - low, corner)
    return face.common(slab).Faces


def _inclination(face):
    """1 for a face that looks up wherever it is looked at, -1 for one that looks down, 0 for one
    that does both.
    """
    u0, u1, v0, v1 = face.ParameterRange
    shares = [(k + 0.5) / SIGHTINGS for k in range(SIGHTINGS)]
    z = [face.normalAt(u0 + a * (u1 - u0), v0 + b * (v1 - v0)).z for a in shares for b in shares]
    looks_up, looks_down = max(z) > LEVEL, min(z) < -LEVEL
    return int(looks_up) - int(looks_down) if looks_up != looks_down else 0


def _under_triangles(faces):
    """The faces in the plane that lie under any of some faces, as near as triangles are."""
    corners = []
    for face in faces:
        points, triangles = _triangles(face, DEFLECTION)
        corners += [[(points[k].x, points[k].y) for k in triangle] for triangle in triangles]
    wires = []
    for outline in compiled.core().united(corners, DEFLECTION / 2):
        points = [FreeCAD.Vector(x, y, 0) for x, y in outline]
        wires.append(Part.makePolygon([*points, points[0]]))
    return faces_within(wires)


def _triangles(shape, deflection):
    """(points, triangles as three of their numbers each) within `deflection` mm of a shape's faces.

    Shape.tessellate() turns by no more than 5 `deflection` rad from one triangle to the next, which
    made 13 000 of a countersink, and seconds of a dozen. For flat faces it is as good, and needs no
    module that takes 0.2 s to load.
    """
    if all(isinstance(face.Surface, Part.Plane) for face in shape.Faces):
        return shape.tessellate(deflection)
    import MeshPart  # here, since it is slow to load

    return MeshPart.meshFromShape(
        Shape=shape, LinearDeflection=deflection, AngularDeflection=TURN, Relative=False
    ).Topology


def _in_plane(edge):
    if edge.Degenerated:  # a pole, which has no curve
        return None
    box = edge.BoundBox
    if isinstance(edge.Curve, Part.Line):
        ends = [edge.valueAt(parameter) for parameter in edge.ParameterRange]
        start, end = (FreeCAD.Vector(p.x, p.y, 0) for p in ends)
        return Part.makeLine(start, end) if (end - start).Length > SHORTEST else None
    if max(box.XLength, box.YLength) < SHORTEST:
        return None
    if box.ZLength < FLAT or _is_level_curve(edge.Curve):
        return edge.translated(UP * -edge.valueAt(edge.FirstParameter).z)
    if isinstance(edge.Curve, Part.Circle) and abs(edge.Curve.Axis.z) > 1 - LEVEL:
        return _flattened_arc(edge)
    points = edge.discretize(Deflection=PROJECTED)
    if len(points) < POINTS:
        points = edge.discretize(Number=POINTS)
    points = [FreeCAD.Vector(p.x, p.y, 0) for p in points]
    if _is_straight(points):
        return Part.makeLine(points[0], points[-1])
    curve = Part.BSplineCurve()
    if (points[0] - points[-1]).Length > SHORTEST:
        curve.interpolate(points)
    else:
        curve.interpolate(points[:-1], PeriodicFlag=True)
    return curve.toShape()


def _is_level_curve(curve):
    if not isinstance(curve, (Part.Circle, Part.Ellipse)):
        return False
    return math.hypot(curve.Axis.x, curve.Axis.y) < LEVEL


def _flattened_arc(edge):
    """An arc that lies askew by no more than level faces may, in the plane z = 0."""
    first, last = edge.ParameterRange
    ends = [edge.valueAt(first + share * (last - first)) for share in (0, 0.5, 1)]
    start, middle, end = (FreeCAD.Vector(p.x, p.y, 0) for p in ends)
    if (end - start).Length > SHORTEST:
        return Part.Arc(start, middle, end).toShape()
    centre = edge.Curve.Center
    return Part.makeCircle(edge.Curve.Radius, FreeCAD.Vector(centre.x, centre.y, 0))


def _is_straight(points):
    along = points[-1] - points[0]
    if along.Length < SHORTEST:
        return False
    return all(p.distanceToLine(points[0], along) < SHORTEST for p in points)


def _meets(box, low, high):
    """Whether a box of FreeCAD's reaches into the one between two corners, or over it."""
    return (
        box.ZMax > low[2]
        and box.XMin < high[0]
        and box.XMax > low[0]
        and box.YMin < high[1]
        and box.YMax > low[1]
    )


def _points_along(edge, spacing):
    """Points of an edge, n x 3; of an upright line only its upper end, which is what stands."""
    if isinstance(edge.Curve, Part.Line):
        a, b = (edge.valueAt(parameter) for parameter in edge.ParameterRange)
        if math.hypot(b.x - a.x, b.y - a.y) < SHORTEST:
            return numpy.array([tuple(max(a, b, key=lambda p: p.z))])
        share = numpy.linspace(0, 1, max(2, math.ceil((b - a).Length / spacing) + 1))[:, None]
        return numpy.array([tuple(a)]) * (1 - share) + numpy.array([tuple(b)]) * share
    count = max(POINTS, math.ceil(edge.Length / spacing) + 1)
    return numpy.array([tuple(p) for p in edge.discretize(Number=count)])

"""What makes a ball-end tool's chip, as solids of OpenCASCADE's: ball, stock and earlier passes.

Needs FreeCAD's Part. All is modelled at 1000 : 1, since the kernel's tolerances do not shrink with
the chip [Varga 2023, 4.1]; the origin is the centre of the tool's ball.
"""

import math

import Part
from FreeCAD import Matrix, Placement, Vector

from evenload.ball_end.sections import section
from evenload.ball_end.solid_surfaces import Ball, Stock, Way

SCALE = 1000.0
PROFILE = 70.0  # degrees of the swept arc on both sides of the point of contact: all that cuts
WEDGE = 160.0  # degrees around the ball's axis: its lower side, without a seam
PIPE = (
    1e-3  # of the model's mm, a millionth of ours: how near a swept surface comes to the true one
)
ROOM = 1.25  # of half the chip's length: how far models reach on both sides of the contact
SAME = 1e-2  # of the model's mm: points nearer than this to a surface lie on it


class Place:
    """Where the tool stands: the frame of its feed, and the model around its centre."""

    def __init__(self, surface, radius, allowance, direction, position):
        self.radius, self.y = SCALE * radius, SCALE * position
        pieces = section(surface)
        if any(each.is_arc and each.radius < 0 <= each.radius + radius for each in pieces):
            raise ValueError("The ball does not fit into the concave surface.")
        self._centres = [_scaled(each.offset(radius)) for each in pieces]
        self._stock = [_scaled(each.offset(allowance)) for each in pieces]
        angle = math.radians(direction)
        self.feed = Vector(math.cos(angle), math.sin(angle), 0)
        if abs(self.feed.y) < 1e-12:
            self.feed = Vector(math.copysign(1, self.feed.x), 0, 0)
        self.left = Vector(-self.feed.y, self.feed.x, 0)
        piece = self._piece_at(self.y)
        self.z = piece.height(self.y)
        self.normal = Vector(0, *piece.normal(self.y))
        self.reach = ROOM * _half_length(pieces, radius, allowance, position)

    def _piece_at(self, y):
        for piece in self._centres:
            begin, end = piece.ordinates
            if begin <= y <= end:
                return piece
        raise ValueError("The tool stands beyond the surface's end.")

    def centre(self, along, left):
        """Of the ball, at a place in plan from the tool's own, the model's origin."""
        at = along * self.feed + left * self.left
        y = self.y + at.y
        return Vector(at.x, at.y, self._piece_at(y).height(y) - self.z)

    def ball(self, centre, pole, is_whole):
        """With a pole that way, as far as it leads along the surface; its seam is on the far side
        of the contact, or is cut off with it.
        """
        pole = (pole - pole.dot(self.normal) * self.normal).normalize()
        if is_whole:
            ball = Part.makeSphere(self.radius)
            ball.Placement = Placement(_frame(self.normal, pole, centre))
            return ball
        ends = Vector(), Vector(0, 0, 1)
        ball = Part.makeSphere(self.radius, *ends, -PROFILE, PROFILE, WEDGE)
        ball.rotate(*ends, -WEDGE / 2)
        ball.Placement = Placement(_frame(-self.normal, pole, centre)).multiply(ball.Placement)
        return ball

    def stock(self, is_spline):
        """Around the point of contact, down to below it. is_spline: its surface is one spline, over
        joints, too; else it is planes and cylinders.
        """
        x = -self.reach
        curves, ends = self._stock_curves(x)
        edges = [curve.toShape() for curve in curves]
        if is_spline:
            spline, *others = [curve.toBSpline() for curve in curves]
            for other in others:
                spline.join(other)
            edges = [spline.toShape()]
        bottom = min(each.z for each in ends) - self.reach
        first, last = ends[0], ends[-1]
        under = [Vector(x, last.y, bottom), Vector(x, first.y, bottom)]
        corners = [last, *under, first]
        edges += [Part.makeLine(a, b) for a, b in zip(corners, corners[1:])]
        solid = Part.Face(Part.Wire(edges)).extrude(Vector(2 * self.reach, 0, 0))
        return solid.toNurbs() if is_spline else solid

    def _stock_curves(self, x):
        """(curves of its section at an x, their ends)"""
        contact = self.y - self.radius * self.normal.y
        low, high = contact - self.reach, contact + self.reach
        curves, ends = [], []
        for piece in self._stock:
            begin, end = piece.ordinates
            begin, end = max(begin, low), min(end, high)
            if end - begin < SAME:
                continue
            points = [
                Vector(x, y - self.y, piece.height(y) - self.z)
                for y in (begin, (begin + end) / 2, end)
            ]
            line = Part.LineSegment(points[0], points[2])
            curves.append(Part.Arc(*points) if piece.is_arc else line)
            ends += [points[0], points[2]]
        return curves, ends

    def surfaces(self, before, lefts):
        """What may leave the faces of a chip: the tool, the tooth before with its centre `before`,
        passes a stepover to the left each, and the stock.
        """
        balls = [Ball("tool", (0.0, 0.0, 0.0), self.radius)]
        balls.append(Ball("previous", tuple(before), self.radius))
        feed, beside = (self.feed.x, self.feed.y), (self.left.x, self.left.y)
        passes = [
            Way(
                self._centres,
                (left * beside[0], left * beside[1]),
                feed,
                self.y,
                self.z,
                self.radius,
            )
            for left in lefts
        ]
        return [*balls, *passes, Stock(self._stock, self.y, self.z)]

    def way(self, left):
        """The wire of the ball's centres along a pass beside, as far as the chip may reach."""
        reach = self.reach
        if self.feed.y == 0:
            return Part.Wire([Part.makeLine(self.centre(-reach, left), self.centre(reach, left))])
        middle = self.y + left * self.left.y  # y where the pass is beside the tool
        ends = sorted(middle + each * self.feed.y for each in (-reach, reach))
        edges = []
        for piece in self._centres:
            begin, end = piece.ordinates
            begin, end = max(begin, ends[0]), min(end, ends[1])
            if end - begin > SAME:
                edges.append(self._way_on(piece, left, (begin, end), middle))
        return Part.Wire(edges if self.feed.y > 0 else edges[::-1])

    def _way_on(self, piece, left, ends, middle):
        """An arc's section along an upright plane is that of an ellipse."""

        def at(y, z):
            along = (y - middle) / self.feed.y
            return along * self.feed + left * self.left + Vector(0, 0, z - self.z)

        first, between, last = (
            at(y, piece.height(y)) for y in (ends[0], (ends[0] + ends[1]) / 2, ends[1])
        )
        if not piece.is_arc:
            return Part.makeLine(first, last)
        if abs(self.feed.y) > 1 - 1e-12:
            return Part.Arc(first, between, last).toShape()
        y, z = piece.middle
        ellipse = Part.Ellipse(at(y + abs(piece.radius), z), at(y, z + piece.radius), at(y, z))
        begin, end = sorted(ellipse.parameter(each) for each in (first, last))
        return ellipse.toShape(begin, end)

    def swept(self, way):
        """The lower part of what the ball sweeps along a way."""
        edge = way.OrderedEdges[0]
        start = way.OrderedVertexes[0].Point
        tangent = edge.tangentAt(edge.getParameterByLength(0))
        down = tangent.cross(self.left).normalize()
        middle = math.atan2(-self.normal.dot(self.left), -self.normal.dot(down))
        first, between, last = (
            start + self.radius * (math.cos(turn) * down + math.sin(turn) * self.left)
            for turn in (middle + each * math.radians(PROFILE) for each in (1, 0, -1))
        )
        arc = Part.Arc(first, between, last).toShape()
        made = Part.BRepOffsetAPI.MakePipeShell(way)
        made.setBiNormalMode(self.left)
        made.setTolerance(PIPE, PIPE, 1e-4)
        made.setMaxSegments(100)
        made.add(Part.Wire([arc, Part.makeLine(last, first)]), False, False)
        made.build()
        made.makeSolid()
        return made.shape()


def _half_length(pieces, radius, allowance, position):
    """Of the longest chip that a section near a position could have, by its curvature, in the
    model's mm: at most the ball's radius.
    """
    near = [
        each.radius
        for each in pieces
        if each.ordinates[0] < position + radius and position - radius < each.ordinates[1]
    ]
    bend = 1 / radius + min(0, *(1 / each for each in near), 0)
    return SCALE * min(radius, math.sqrt(2 * allowance / bend))


def _scaled(piece):
    y, z = piece.middle
    ends = (piece.begin, piece.end)
    if piece.is_arc:
        return type(piece)((SCALE * y, SCALE * z), SCALE * piece.radius, *ends)
    return type(piece)((SCALE * y, SCALE * z), piece.radius, *(SCALE * end for end in ends))


def _frame(x, z, origin):
    """The Matrix whose columns are x, z's cross product with it, z and the origin."""
    y = z.cross(x)
    rows = [(x[k], y[k], z[k], origin[k]) for k in range(3)]
    return Matrix(*(number for row in rows for number in row), 0, 0, 0, 1)

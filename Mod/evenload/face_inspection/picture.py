"""Pictures of measuring points and of deviations on the faces, by matplotlib."""

import numpy
from matplotlib.collections import PolyCollection, TriMesh
from matplotlib.tri import Triangulation

from evenload.face_inspection.evaluation import PROFILE
from evenload.face_inspection.mesh import between, mesh_of, nearest_of
from evenload.inspection.points import SHOWN, length_told, mm_per
from evenload.pictures.figure import new_figure
from evenload.pictures.figure import save as save_figure
from evenload.settings.sentences import shown_name
from evenload.translation import filled, translate

SIZE = 7.5, 6.2  # inches, of one view
ONE_SIDED = 0.3  # of the mean normal: below it the faces look to all sides
SLANTS = ((1.0, -1.0, 1.0), (-1.0, 1.0, 1.0))  # from where these are seen
STRAIGHT = 1 - 1e-9  # of a direction: along an axis, which has a name then
GROUND, INK, BAD = "#d7dadd", "#202124", "#d93025"
COLOURS = "viridis"  # its lightness rises evenly: the map can be read in grey


def save_samples(faces, samples, path, unit="mm"):
    """Draws Samples on PickedFaces into a PNG or SVG file. unit: "mm" or "inch", of the axes."""
    count, name = str(len(samples.points)), shown_name(faces.name)
    title = filled(translate("%1 points on %2"), (count, name))
    figure, views = _views(title, faces, unit)
    for view in views:
        view.draw(colour=GROUND)
        view.mark(samples.points, "o", color=INK, markersize=3.5)
    save_figure(figure, path)


def save_map(evaluation, path, unit="mm"):
    """Draws the deviations of an Evaluation into a PNG or SVG file.

    Colours are of the deviations at the measured points and, between these, of their means by
    distance. path: a name, or a file that is open for bytes, which becomes a PNG. unit: "mm" or
    "inch", of all lengths.
    """
    zone = length_told(evaluation.zone, unit)
    error = translate(evaluation.error)
    title = "%s: %s %s" % (shown_name(evaluation.faces.name), error, zone)
    figure, views = _views(title, evaluation.faces, unit)
    points, deviations = evaluation.measured.points, evaluation.deviations / mm_per(unit)
    largest = float(numpy.abs(deviations).max()) or 1.0
    contacts = points[numpy.asarray(evaluation.found.contacts, dtype=int)]
    beyond = evaluation.is_beyond
    for view in views:
        colours = view.draw(points, deviations, largest)
        view.mark(points, "o", color=INK, markersize=2.5)
        hollow = {"markerfacecolor": "none", "markeredgecolor": INK, "markersize": 9}
        view.mark(contacts, "s", label=translate("contact"), **hollow)
        if beyond is not None and beyond.any():
            label = translate("beyond the tolerance")
            view.mark(points[beyond], "o", color=BAD, markersize=4, label=label)
    above = translate(
        "too much material" if evaluation.kind == PROFILE else "outside of the feature"
    )
    figure.colorbar(
        colours,
        ax=[view.axes for view in views],
        shrink=0.8,
        label=translate("deviation, %s; above 0: %s") % (SHOWN[unit][0], above),
    )
    views[0].axes.legend(loc="upper left", bbox_to_anchor=(0, -0.1), ncols=2, frameon=False)
    save_figure(figure, path)


def _views(title, faces, unit):
    """(figure, the _View that show PickedFaces in it)."""
    mesh = mesh_of(faces)
    mean = (mesh.areas[:, None] * mesh.normals).sum(axis=0) / mesh.areas.sum()
    is_one_sided = numpy.linalg.norm(mean) > ONE_SIDED
    sides = [mean] if is_one_sided else numpy.array(SLANTS)
    figure = new_figure(SIZE[0] * (1 if is_one_sided else 1.4), SIZE[1], layout="constrained")
    figure.suptitle(title, fontsize=10)
    places = figure.subplots(1, len(sides), squeeze=False)[0]
    return figure, [_View(*each, mesh, is_one_sided, unit) for each in zip(places, sides)]


class _View:
    """Faces seen straight on where they look to one side; else at a slant, without what looks
    away.
    """

    def __init__(self, axes, towards, mesh, is_straight, unit):
        self.axes, self._mesh, self._unit = axes, mesh, unit
        self._towards = towards = towards / numpy.linalg.norm(towards)
        self._is_straight = is_straight
        if is_straight:  # as drawings have it: x to the right, or y where that is not seen
            right = numpy.eye(3)[0] - towards[0] * towards
            if numpy.linalg.norm(right) < 0.5:
                right = numpy.eye(3)[1] - towards[1] * towards
        else:  # z up
            right = numpy.cross([0.0, 0.0, 1.0], towards)
        self._right = right / numpy.linalg.norm(right)
        self._up = numpy.cross(towards, self._right)
        axes.set_aspect("equal")
        self._label(SHOWN[unit][0])

    def mark(self, points, sign, **how):
        """Draws those of n x 3 points that are seen."""
        if len(points) and not self._is_straight:
            normals = self._mesh.normals[nearest_of(points, self._mesh.corners.mean(axis=1))]
            points = points[normals @ self._towards > 0]
        self.axes.plot(*self._seen(points).T, sign, linestyle="none", **how)

    def draw(self, points=None, values=None, largest=None, colour=None):
        """The faces in one colour, or in those of values at points."""
        corners = self._mesh.corners
        if not self._is_straight:
            corners = corners[self._mesh.normals @ self._towards > 0]
        depth = corners.mean(axis=1) @ self._towards
        corners = corners[numpy.argsort(depth, kind="stable")]
        seen = self._seen(corners)
        if values is None:
            shown = PolyCollection(seen, rasterized=True, linewidths=0.3)
            shown.set_facecolor(colour)
            shown.set_edgecolor(colour)
        else:
            numbers = numpy.arange(3 * len(corners)).reshape(-1, 3)
            shown = TriMesh(Triangulation(*seen.reshape(-1, 2).T, numbers), rasterized=True)
            shown.set_array(between(corners.reshape(-1, 3), points, values))
            shown.set_cmap(COLOURS)
            shown.set_clim(-largest, largest)
        self.axes.add_collection(shown)
        self.axes.autoscale_view()
        return shown

    def _seen(self, points):
        """n x 2, in the unit that is shown, of n x 3."""
        seen = numpy.stack([points @ self._right, points @ self._up], axis=-1)
        return seen / mm_per(self._unit)

    def _label(self, unit):
        for direction, tell in (
            (self._right, self.axes.set_xlabel),
            (self._up, self.axes.set_ylabel),
        ):
            straight = [name for name, share in zip("xyz", direction) if share > STRAIGHT]
            tell("%s, %s" % (straight[0], unit) if straight else unit)

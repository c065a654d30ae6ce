"""The picture of docs/surface_simulation.md; see make_pictures.py."""

import sys

import numpy
from dynamics_pictures import kept
from evenload.pictures.figure import new_figure
from picture_parts import BLUE, DOCS, ORANGE

sys.path.insert(0, str(DOCS.parent / "tests" / "python"))
import finishing_cases as cases  # noqa: E402

DEFLECTION, STEPOVER = 1e-4, 0.35
SIDE, CELLS = 0.8, 320  # mm; the source's cut-off
SPEED, TEETH, FEED = 5100, 4, 1632  # [Varga 2023, 3]
MICRONS = 1e3


def patch(core):
    """Heights over CX at its crest, \u00b5m, rows along the feed."""
    points, triangles, picked = cases.triangles(True, DEFLECTION)
    arguments = {"tolerance": cases.TOLERANCE, "deflection": DEFLECTION, "stepover": STEPOVER}
    mesh = core.surface.FacetMesh(points, triangles, picked)
    finish = core.surface.finish(mesh, **cases.options(**{**arguments, "feed": FEED}))
    spacing = SIDE / CELLS
    found = core.surface_map(
        core.HeightMap(points, triangles),
        picked,
        finish.toolpath.moves,
        tool_diameter=10.0,
        corner_radius=5.0,
        first=(-SIDE / 2 + spacing / 2, -SIDE / 2 + spacing / 2),
        spacing=spacing,
        cells=(CELLS, CELLS),
        stock=0.3,
        teeth_per_minute=SPEED * TEETH,
    )
    return MICRONS * (found["above"] - found["above"].min())


def draw_roughness(core):
    """The marks of teeth and passes, from above and as profiles."""
    heights = patch(core)
    figure = new_figure(10, 4.2, layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(1, 1.3))
    half = SIDE / 2
    shown = left.imshow(heights, origin="lower", extent=(-half, half, -half, half), cmap="viridis")
    figure.colorbar(shown, ax=left, label="height, \u00b5m")
    left.set_xlabel("along the feed, mm")
    left.set_ylabel("across the feed, mm")
    places = numpy.linspace(-half, half, CELLS)
    lowest = int(heights.mean(axis=1).argmin())
    right.plot(places, heights[lowest], color=BLUE, label="along the feed, in a pass")
    right.plot(places, heights[:, CELLS // 2], color=ORANGE, label="across the feed")
    right.set_xlabel("mm from the middle")
    right.set_ylabel("height, \u00b5m")
    right.set_ylim(None, 1.3 * heights.max())  # room for the legend
    right.legend(fontsize=8, loc="upper right")
    kept(figure, "surface_roughness.png")


PICTURES = (draw_roughness,)

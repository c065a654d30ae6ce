"""The picture of docs/optimisation.md; see make_pictures.py."""

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from picture_parts import BLUE, GREEN, GREY, ORANGE, RED, rectangle, save

CUTTERS = [
    {
        "diameter": diameter,
        "teeth": teeth,
        "cutting_length": 2 * diameter,
        "max_chip_thickness": 0.006 * diameter,
        "surface_speed": (100, 200),
    }
    for diameter, teeth in ((4, 2), (6, 2), (8, 3), (10, 3))
]


def draw_optimisation(core):
    """Time over force of all candidates of docs/optimisation.md's example."""
    import evenload

    pocket = core.Region(rectangle(60, 40), [])
    options = {"depth": 10, "max_force": 300, "engagement_deg": (30, 45, 60, 75, 90)}
    found = evenload.optimise(pocket, CUTTERS, "Al7075-T6", "linuxcnc_mill", **options)
    figure = Figure(figsize=(7.2, 4.2))
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    for cutter, colour in zip(CUTTERS, (GREY, GREEN, BLUE, ORANGE)):
        rows = [c for c in found.ranked() if c.diameter == cutter["diameter"]]
        force, time = [c.force_peak_n for c in rows], [c.seconds for c in rows]
        name = "%g mm, %d teeth" % (cutter["diameter"], cutter["teeth"])
        axes.plot(force, time, "o", ms=4, color=colour, alpha=0.7, label=name, mew=0)
    axes.plot(found.best.force_peak_n, found.best.seconds, "o", ms=12, mfc="none", mec=RED)
    axes.axvline(options["max_force"], color=RED, lw=1, ls="--")
    axes.set(yscale="log", xlabel="peak force, N", ylabel="time on the machine, s")
    axes.set_yticks((100, 200, 500, 1000, 2000, 5000))
    axes.set_yticklabels(("100", "200", "500", "1000", "2000", "5000"))
    axes.minorticks_off()
    axes.legend(frameon=False)
    save(figure, "optimisation.png", found.table(3), fit=False)


PICTURES = (draw_optimisation,)

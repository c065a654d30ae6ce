"""Reference chips: closed forms on the plane, and values of an independent computation by rays from
the ball's centre on a fine grid of directions (tests/ball_end_chips.csv, mean of both sides).
"""

import csv
from pathlib import Path

import numpy
from evenload import ball_end

DIAMETER, ALLOWANCE = 10, 0.3
RADII = {"CX": 45, "CV": -45}
# Surface, position, feed direction, feed, stepover, uncut; V in 1e-3 mm3, A in mm2, h in um.
KEYS = "V A_tool A_prev h_tool h_m h_max".split()
VECTORS = [
    (45, 0, 0, 0.08, 0.15, "right", 3.2416, 0.8577, 0.7202, 3.780, 4.501, 10.30),
    (45, 21, 45, 0.12, 0.15, "right", 5.3724, 0.9280, 0.7158, 5.789, 7.506, 15.96),
    (45, 21, 45, 0.12, 0.15, "left", 5.3293, 0.9244, 0.7134, 5.765, 7.471, 15.88),
    (45, 21, 90, 0.16, 0.35, "right", 16.5751, 1.4222, 1.1185, 11.654, 14.819, 32.00),
    (-45, 0, 0, 0.08, 0.15, "right", 4.0254, 1.0078, 0.8537, 3.994, 4.715, 10.86),
    (-45, 21, 45, 0.12, 0.15, "right", 7.1256, 1.0854, 0.8229, 6.565, 8.659, 18.11),
    (-45, 21, 45, 0.12, 0.15, "left", 7.0378, 1.0788, 0.8187, 6.524, 8.596, 17.96),
    (-45, 21, 90, 0.16, 0.35, "right", 21.8923, 1.6176, 1.2150, 13.534, 18.018, 37.28),
    (-10, 0, 0, 0.12, 0.15, "right", 10.5885, 1.5907, 1.2784, 6.656, 8.282, 18.16),
    (-10, 0, 90, 0.12, 0.15, "right", 10.5301, 1.4133, 0.9838, 7.451, 10.703, 20.62),
    (-10, 1.5, 45, 0.12, 0.15, "right", 11.3453, 1.5153, 1.1205, 7.487, 10.125, 20.68),
    (10, 0, 0, 0.12, 0.15, "right", 3.6313, 0.7216, 0.5447, 5.032, 6.667, 13.90),
    (10, 0, 90, 0.12, 0.15, "right", 3.6399, 0.7741, 0.6276, 4.702, 5.800, 12.94),
    (10, 4.5, 45, 0.12, 0.15, "right", 3.8660, 0.7608, 0.5934, 5.082, 6.515, 14.04),
]


def vector_chip(row):
    radius, position, direction, feed, stepover, uncut = row[:6]
    return ball_end.chip(
        ("cylinder", radius), DIAMETER, feed, stepover, ALLOWANCE, direction, position, uncut
    )


def figures(chip):
    """A chip, or arrays of them, in the words and units of the reference."""
    return {
        "V": 1e3 * chip.volume,
        "A_tool": chip.tool_face,
        "A_prev": chip.previous_face,
        "h_tool": 1e3 * chip.mean_thickness_tool,
        "h_m": 1e3 * chip.mean_thickness,
        "h_max": 1e3 * chip.max_thickness,
    }


def table():
    """(reference values, ours) by name for the 90 chips of the file; tip_V among them."""
    path = Path(__file__).resolve().parents[1] / "ball_end_chips.csv"
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    wanted = {
        name: numpy.array([float(row[name]) for row in rows])
        for name in (*KEYS, "tip_V", "f_z", "a_e", "A_f", "y_t")
    }
    sides = []
    for uncut in ("right", "left"):
        found = ball_end.chips(
            [("cylinder", RADII[row["part"]]) for row in rows],
            DIAMETER,
            *(wanted.pop(name) if uncut == "left" else wanted[name] for name in ("f_z", "a_e")),
            ALLOWANCE,
            *(wanted.pop(name) if uncut == "left" else wanted[name] for name in ("A_f", "y_t")),
            uncut,
        )
        sides.append({**figures(found), "tip_V": found.tip_share})
    return wanted, {name: (sides[0][name] + sides[1][name]) / 2 for name in sides[0]}


def on_the_plane(feed, stepover, radius=5.0, depth=ALLOWANCE):
    """V, A_tool and A_prev on a plane in mm, by slices of height z; no stepover: a slot."""
    x, w = numpy.polynomial.legendre.leggauss(40)
    # Fine towards z = 0, where slices are narrower than stepover and feed.
    ends = depth * numpy.linspace(0, 1, 121) ** 4
    z = (ends[:-1, None] + numpy.diff(ends)[:, None] * 0.5 * (1 + x)).ravel()
    w = (numpy.diff(ends)[:, None] * 0.5 * w).ravel()
    rho = numpy.sqrt(2 * radius * z - z * z)
    e = -rho if stepover is None else numpy.maximum(rho - stepover, -rho)
    q = numpy.arcsin(numpy.minimum(1, feed / (2 * rho)))
    low, half = numpy.arcsin(e / rho), numpy.pi / 2
    tool = half + half - low - numpy.maximum(low, half - q) + numpy.maximum(0, q - half - low)
    before = numpy.maximum(0, (half - q) - numpy.maximum(low, q - half))
    # The integral of min(feed, 2 sqrt(rho^2 - y^2)) over y from e to rho.
    edge = numpy.sqrt(numpy.maximum(0, rho**2 - feed * feed / 4))

    def cap(y):
        y = numpy.clip(y, -rho, rho)
        return y * numpy.sqrt(rho**2 - y * y) + rho**2 * numpy.arcsin(y / rho)

    inner = numpy.clip(e, -edge, edge)
    volume = feed * (edge - inner) + cap(rho) - cap(numpy.maximum(e, edge))
    volume += numpy.where(e < -edge, cap(-edge) - cap(e), 0)
    return (w * volume).sum(), (w * radius * tool).sum(), (w * radius * before).sum()

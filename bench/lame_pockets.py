# Pockets besides those of the corpus, for Lamé spirals: by name, as cases of the corpus.
import math

PIECES = 120  # of an ellipse


def box(width, height):
    x, y = width / 2, height / 2
    return [(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)]


def circle(radius):
    return [(radius, 0, 1), (-radius, 0, 1)]


def island(radius):
    return [(radius, 0, -1), (-radius, 0, -1)]


def polygon(corners, radius):
    angles = [2 * math.pi * i / corners for i in range(corners)]
    return [(radius * math.cos(angle), radius * math.sin(angle), 0) for angle in angles]


def slot(length, width):
    """With round ends."""
    x, y = (length - width) / 2, width / 2
    return [(-x, -y, 0), (x, -y, 1), (x, y, 0), (-x, y, 1)]


def ellipse(a, b):
    """As arcs that turn as its tangent does."""
    chain = []
    for i in range(PIECES):
        here, there = (2 * math.pi * k / PIECES for k in (i, i + 1))
        before, after = (math.atan2(b * math.cos(t), -a * math.sin(t)) for t in (here, there))
        turn = math.remainder(after - before, 2 * math.pi)
        chain.append((a * math.cos(here), b * math.sin(here), math.tan(turn / 4)))
    return chain


def case(outer, *islands):
    return {
        "tool": 6.0,
        "outer": outer,
        "islands": islands,
        "engagement_deg": 60,
        "axial_depth": 3.0,
        "feed": 255.0,
        "link_feed": 1500.0,
        "max_feed": 1000.0,
        "roll_radius": 1.0,
    }


CASES = {
    "octagon70": case(polygon(8, 35 / math.cos(math.pi / 8))),  # from side to side
    "ellipse70x44": case(ellipse(35, 22)),
    "slot60x30": case(slot(60, 30)),
    "triangle70": case(polygon(3, 70 / math.sqrt(3))),  # its sides
    "rectangle60x40": case(box(60, 40)),
    "rectangle90x30": case(box(90, 30)),
    "square150": case(box(150, 150)),
    "square20": case(box(20, 20)),
    # Around an island of 40 mm.
    "ring18": case(circle(38), island(20)),
    "ring22": case(circle(42), island(20)),
}

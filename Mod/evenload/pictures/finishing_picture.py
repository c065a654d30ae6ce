"""Pictures of finishing paths seen from above, coloured by height."""

from evenload import planar, units
from evenload.pictures import path_picture
from evenload.translation import translate


def picture(op, path):
    """Draws the last path of a finishing operation into a PNG or SVG file.

    Raises ValueError for an operation that has not been computed since its document was opened.
    """
    last = op.Proxy.last
    if last is None:
        raise ValueError("%s has no path to draw: recompute it first." % op.Label)
    title = translate("%s: %d s, %d passes") % (op.Label, round(op.CuttingTime), op.Passes)
    draw(path, last.toolpath.moves, title)


def draw(path, moves, title):
    """The same for moves as the core returns them."""
    lowest = min(move[3] for move in moves if move[0] == planar.CUT)
    unit = units.LENGTH.shown
    samples = [
        (x, y, (z - lowest) / unit.size, kind) for (x, y, z), kind in zip(*planar.drawn(moves))
    ]
    meaning = translate("height of the tool's tip above z = %.3f, %s")
    meaning %= lowest / unit.size, unit.name
    path_picture.draw(path, samples, [], None, title, meaning)

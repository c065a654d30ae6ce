"""The moves of the program that is posted: commands survive rounding, and what cannot be written as
an arc becomes lines.
"""

from itertools import groupby

from evenload import _core
from evenload.planar import RAPID, sweep_of


def posted(moves):
    """The moves (kind, x, y, z, sweep, cx, cy, feed) of the core as its commands make them.

    Commands do not say what a move is for: moves for one purpose are written together.
    """
    made, at = [], None
    for kind, group in groupby(moves, key=lambda move: move[0]):
        for name, words in _core.path_commands(list(group), at):
            # The first command only rises: anywhere will do.
            x0, y0, z0 = at or moves[0][1:4]
            x, y, z = words.get("X", x0), words.get("Y", y0), words.get("Z", z0)
            turn = (0.0, 0.0, 0.0)
            if name in ("G2", "G3"):
                i, j = words["I"], words["J"]
                turn = (sweep_of(x - x0, y - y0, i, j, name == "G3"), x0 + i, y0 + j)
            made.append((RAPID if name == "G0" else kind, x, y, z, *turn, words.get("F", 0.0)))
            at = (x, y, z)
    return made

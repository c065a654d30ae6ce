# Reading G-code: a long program of lines and arcs.
import math
import random
import time

from evenload import _core

REPEATS = 5


def program(lines):
    pick = random.Random(1)
    x = y = 0.0
    text = ["G21 G90 G17", "G0 X0 Y0 Z5", "G1 Z-1 F300"]
    for i in range(lines - len(text)):
        if i % 2:
            x, y = round(pick.uniform(-90, 90), 4), round(pick.uniform(-90, 90), 4)
            text.append("N%d G1 X%.4f Y%.4f" % (i, x, y))
            continue
        radius, angle, sweep = pick.uniform(1, 5), pick.uniform(0, 6), pick.uniform(0.2, 5)
        dx, dy = -radius * math.cos(angle), -radius * math.sin(angle)
        to = x + dx + radius * math.cos(angle + sweep), y + dy + radius * math.sin(angle + sweep)
        text.append("N%d G3 X%.4f Y%.4f I%.4f J%.4f F500." % (i, *to, dx, dy))
        x, y = round(to[0], 4), round(to[1], 4)
    return "\n".join(text)


def figures():
    for lines in (10000, 100000):
        text, times = program(lines), []
        for _ in range(REPEATS):
            start = time.perf_counter()
            read = _core.read_gcode(text)
            times.append(time.perf_counter() - start)
        assert not read.notes and len(read.moves) >= lines - 2
        yield "gcode.lines_%d" % lines, min(times), "s"

"""freecadcmd tests/freecad/post_public_cases.py: posts the public cases of the corpus, by this
FreeCAD, to $EVENLOAD_POSTED/NAME.ngc; `./run same-gcode` compares them.

Left out is what FreeCADs write each in their own way: comments, and the height that 0.20 goes to
before its first operation.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
from conftest import Bench  # noqa: E402
from FreeCAD import Vector  # noqa: E402
from models import case_model, corpus_case  # noqa: E402

CASES = (
    "boss_open circle12 comb inch_slot lame_hex50 lame_square35 lshape ring slot875 slot9 square60 "
    "square_island star two_rooms two_rooms_closed"
).split()


def posted(case):
    """The program of a case, without what is FreeCAD's own in it."""
    from evenload import host

    doc = FreeCAD.newDocument("Case")
    on = Bench(doc, case_model(case), tool=case["tool"], feed=case["feed"])
    op = on.operation(
        FinalDepth=-case["axial_depth"],
        StepDown=case["axial_depth"],
        EngagementAngle=case["engagement_deg"],
        FeedControl="Constant removal rate",
        LinkFeed="%g mm/min" % case["link_feed"],
        MaximumFeed="%g mm/min" % case["max_feed"],
        RollRadius=case["roll_radius"],
    )
    if case.get("hole"):
        x, y, diameter = case["hole"]
        on.set(op, Entry="Predrilled hole", EntryPoint=Vector(x, y, 0), HoleDiameter=diameter)
    on.done(op)
    text = host.post(on.job, "linuxcnc", "--no-show-editor --precision 4")
    FreeCAD.closeDocument(doc.Name)
    lines = [line.strip() for line in text.splitlines() if not line.startswith("(")]
    lines = [line for line in lines if line]
    first = next(i for i, line in enumerate(lines) if line.startswith("G0"))
    if lines[first + 1].startswith("M"):  # a rapid before the tool change
        del lines[first]
    return "\n".join(lines) + "\n"


code = 2
try:
    for name in CASES:
        with open(os.path.join(os.environ["EVENLOAD_POSTED"], name + ".ngc"), "w") as file:
            file.write(posted(corpus_case(name)))
    code = 0
finally:
    sys.stdout.flush()
    sys.stderr.flush()
    if code == 0:
        os._exit(0)
